#include "report/stability.hpp"

#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "reference/bad_input.hpp"
#include "report/chart.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double interval = 2;  // s, between two looks at the motion

/// A motion of size 1, looked at four times.
Quantity motion() {
  Quantity quantity{"x", "m", "a length", {"exact", Value{1, 1, 1, 1}}, 0, {0.01, "close"}};
  quantity.samples = 4;
  return quantity;
}

const Answer fine{Value{1, 1, 1, 1}, 4}, far{Value{1, 1, 1, 100}, 4};

/// A method whose answer depends on its step, and theory's limit for it.
template <class Answers>
Method method(const Answers& answer, double theory = infinity) {
  return {"model", "algorithm", halving("step", 1, 4), answer, Outcome::ok, "", [theory] { return theory; }};
}

Method stable_up_to(double limit) {
  return method([limit](double step) { return step <= limit ? fine : far; });
}

Limit found(const Method& m) { return limit_of(motion(), m, interval); }

}  // namespace

TEST_CASE("a threshold is bracketed to one step an interval, or to 1 %", "[stability]") {
  for (double threshold : {1.9, 0.7, 0.3, 0.0501, 0.00777, 0.00013}) {
    const Limit limit = found(stable_up_to(threshold));
    INFO("threshold " << threshold << ": " << shown_step(limit));
    REQUIRE(limit.stable);
    REQUIRE(limit.broken);
    CHECK(limit.stable->setting <= threshold);
    CHECK(limit.broken->setting > threshold);
    const double stable = interval / limit.stable->setting, broken = interval / limit.broken->setting;
    CHECK(near(stable, std::round(stable), 1e-9));
    CHECK((stable - broken < 1 + 1e-9 || limit.broken->setting < 1.0102 * limit.stable->setting));
    CHECK(limit.step() == limit.stable->setting);
    CHECK(limit.broken->outcome == Outcome::diverged);
    CHECK(beyond(limit) == "diverged");
  }
}

TEST_CASE("a coarse step that is stable by accident does not count", "[stability]") {
  const Limit limit = found(method([](double step) { return step <= 0.1 || step > 0.5 ? fine : far; }));
  REQUIRE(limit.stable);
  CHECK(near(limit.step(), 0.1, 1.01e-3));
  REQUIRE(limit.broken);
  CHECK(limit.broken->setting > 0.1);
  CHECK(limit.broken->setting < 0.106);
}

TEST_CASE("a gap far below a seeming limit is found where theory points at it", "[stability]") {
  const auto answer = [](double step) { return step < 1e-4 || step > 1e-3 ? fine : far; };
  CHECK(found(method(answer)).step() == infinity);
  CHECK(near(found(method(answer, 2e-4)).step(), 1e-4, 2e-6));
}

TEST_CASE("a method that no step breaks has no limit", "[stability]") {
  const Limit limit = found(stable_up_to(infinity));
  CHECK(limit.step() == infinity);
  CHECK_FALSE(limit.broken);
  CHECK(shown_step(limit) == "at least 2");
  CHECK(beyond(limit) == "stable");
  CHECK(how_it_breaks(limit, "m").empty());
}

TEST_CASE("a method that every step breaks is given up at 262,144 steps or 200,000 evaluations",
          "[stability]") {
  const Limit cheap = found(stable_up_to(0));
  CHECK(cheap.step() == 0);
  CHECK_FALSE(cheap.stable);
  REQUIRE(cheap.broken);
  const double steps = 4 * interval / cheap.broken->setting;
  CHECK(steps >= 262'144);
  CHECK(steps < 2 * 262'144);
  CHECK(shown_step(cheap).starts_with("none above "));
  const Limit dear = found(method([](double step) {
    return Answer{far.value, std::lround(4 * interval / step * 100)};
  }));
  CHECK(dear.step() == 0);
  CHECK(dear.broken->evaluations >= 200'000);
  CHECK(dear.broken->evaluations < 400'000);
}

TEST_CASE("each way of failing breaks a method, an error or a small drift does not", "[stability]") {
  const auto judged = [](const Answer& answer) {
    return stable(run(motion(), method([&](double) { return answer; }), 1));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(judged(fine));
  CHECK(judged({Value{1, 1, 1, 10.9}}));
  CHECK_FALSE(judged({Value{1, 1, 1, 11.1}}));
  CHECK(judged({fine.value, 4, nan, 1}));
  CHECK_FALSE(judged({fine.value, 4, nan, 1.01}));
  CHECK_FALSE(judged({fine.value, 4, nan, nan}));
  CHECK_FALSE(judged({Value{1, 1, 1, nan}}));
  CHECK_FALSE(judged({Value{1, 1, 1}}));
  for (Ending ending : {Ending::non_finite, Ending::stalled, Ending::raised})
    CHECK_FALSE(judged({fine.value, 4, nan, 0, ending}));
  const Method throws = method([](double) -> Answer { throw std::runtime_error("no"); });
  CHECK_FALSE(stable(run(motion(), throws, 1)));
}

TEST_CASE("theory agrees when its limit lies between the two steps", "[stability]") {
  TimedTrial stable, broken;
  stable.setting = 0.5, broken.setting = 0.75;
  const auto with = [&](double theory) {
    Limit limit;
    limit.theory = theory, limit.stable = stable, limit.broken = broken;
    return limit;
  };
  CHECK(agreement(with(0.6)) == 1);
  CHECK(agreement(with(0.25)) == 2);
  CHECK(agreement(with(1.5)) == 0.5);
  CHECK(agreement(with(infinity)) == 0);
  CHECK(agreement(with(0)) == infinity);
  Limit never = with(infinity);
  never.broken.reset();
  CHECK(agreement(never) == 1);
  Limit always = with(0);
  always.stable.reset();
  CHECK(agreement(always) == 1);
}

TEST_CASE("stability survives the way to JSON and back, infinite limits too", "[stability]") {
  Results results;
  ExerciseResult& e = results.exercises.emplace_back();
  e.number = {3, 5};
  Stability& s = e.stability.emplace();
  s.quantity = "x";
  s.steps = {1, 0.5};
  s.parameter = "a";
  Limit limit = found(stable_up_to(0.1));
  limit.theory = infinity;
  limit.cure = limit.stable;
  s.limits = {limit, found(stable_up_to(infinity)), found(stable_up_to(0))};
  s.map = {{"model", "algorithm", 0.1, infinity, {Outcome::diverged, Outcome::ok}}};
  const std::string json = to_json(results);
  const Results read = results_from_json(json, "here");
  CHECK(to_json(read) == json);
  CHECK(read.exercises[0].stability->limits[0].theory == infinity);
  CHECK(stability_page(read) == stability_page(results));
  CHECK(stability_text(read.exercises[0]) == stability_text(e));
  CHECK(map_script(read.exercises[0], "f") == map_script(e, "f"));
  CHECK(limit_rows(read) == limit_rows(results));
  CHECK(map_rows(results) == "3.5,model,algorithm,0.1,Xo\n");
}

TEST_CASE("limits and maps on record are read, broken ones named by line", "[stability]") {
  const ScratchFolder folder;
  const std::string head = "exercise,model,algorithm,step,theory,beyond,why\n";
  const std::string file = folder.file("limits.csv", head + "3.5,m,a,0.1,inf,diverged,\"so, so\"\n").string();
  const Limits limits = read_limits(folder.path());
  REQUIRE(limits.size() == 1);
  CHECK(limits[0].step == 0.1);
  CHECK(limits[0].theory == infinity);
  CHECK(limits[0].why == "so, so");
  const auto said = [&](const std::string& text) {
    folder.file("limits.csv", text);
    const std::string all = complaint([&] { read_limits(folder.path()); });
    return all.starts_with(file) ? all.substr(file.size()) : all;
  };
  CHECK(said(head + "3.5,m,a,x,1,ok,\n") == ":2: 'x' in column 4 is not a number");
  CHECK(said(head + "3.5,m,a,-1,1,ok,\n") == ":2: a step must be zero or positive, or inf");
  CHECK(said(head + "3.5,m,a,1,1,ok,\n3.5,m,a,1,1,ok,\n") == ":3: a second row for 3.5, m, a");
  CHECK(said("exercise,step\n3.5,1\n") ==
        ":1: the columns must be exercise,model,algorithm,step,theory,beyond,why");
  folder.file("stability_maps.csv", "exercise,model,algorithm,value,outcomes\n3.5,m,a,1,Xo\n3.5,m,a,2,oo\n");
  CHECK(read_maps(folder.path()).at(1).outcomes == "oo");
}

TEST_CASE("stability does not depend on the number of threads", "[stability]") {
  const std::filesystem::path folder = std::filesystem::path(ODDITY_SOURCE) / "reference";
  const Reference truth(folder);
  std::vector<Task> tasks;
  for (const Entry& entry : registry())
    if (entry.number == Number{3, 5}) tasks.emplace_back(entry);
  const auto examined = [&](std::size_t threads) {
    const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
    Results blank;
    blank.exercises.emplace_back().number = {3, 5};
    return to_json(with_stability(blank, tasks, truth, read_limits(folder)));
  };
  CHECK((examined(1) == examined(4)));
}
