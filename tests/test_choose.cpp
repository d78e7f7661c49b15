// Choosing, on a made-up scene whose truth is a = x(t) for all t and whose methods err by known amounts.

#include <cmath>
#include <set>

#include "reference/bad_input.hpp"
#include "report/study/choose.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"

using namespace oddity;

namespace {

constexpr Parameter parameters[] = {{"a", 1, "m", "where it stays", 0, 10}};

/// x = a (1 + error) at one frame in the middle, and a at the others, of that many evaluations.
Method method(std::string model, std::string algorithm, Knob knob, double a, int frames,
              std::function<double(double)> error, std::function<long(double)> evaluations) {
  return {std::move(model), std::move(algorithm), std::move(knob), [=](double setting) {
            std::vector<double> x(static_cast<std::size_t>(frames), a);
            x[x.size() / 2] *= 1 + error(setting);
            return Answer{Value(std::move(x)), evaluations(setting)};
          }};
}

/// "coarse": off by a tenth of (a - 1). "stepping": off by its step, in float by 0.02 at least. "rich":
/// right, at a hundred evaluations.
Quantity place(const Parameters& p, const Horizon& horizon, const Reference&) {
  const double a = p["a"];
  const auto everywhere = static_cast<std::size_t>(horizon.count());
  Quantity q{"place", "m",        "", {"exact", Value(std::vector<double>(everywhere, a))},
             1e-16,   {1e-6, ""}, {}, {}};
  const auto one = [](double) { return 1L; };
  q.add(method(
      "coarse", "closed form", no_knob(), a, horizon.count(),
      [a](double) { return std::abs(a - 1) / 10 + 1e-4; }, one));
  q.add(method(
      "stepping", "explicit", halving("step", 1, 4), a, horizon.count(), [](double h) { return h; },
      [=](double h) { return std::lround(horizon.end / h); }));
  q.add(method(
      "rich", "everything", tolerances(), a, horizon.count(), [](double e) { return e * 1e-4 + 1e-14; },
      [](double e) { return std::lround(-100 * std::log10(e)); }));
  Method single = method(
      "stepping", "explicit in float", halving("step", 1, 4), a, horizon.count(),
      [](double h) { return std::max(h, 0.02); }, [=](double h) { return std::lround(horizon.end / h); });
  single.precision = Precision::in_float;
  q.add(std::move(single));
  q.add({"absent", "raises", no_knob(), [](double) -> Answer { throw std::runtime_error("not here"); }});
  return q;
}

const Entry entry{{3, 99},
                  "",
                  {"made up", "", parameters,
                   Scene{place, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};

/// A nanosecond an evaluation.
Time counted_cost(const Method& m, double setting) {
  return {static_cast<double>(m.run(setting).evaluations) * 1e-9, 0};
}

Need asked(double error, double horizon, double frames_per_second = 10) {
  Need need{error};
  need.horizon = horizon;
  need.frames_per_second = frames_per_second;
  return need;
}

Choice choose_for(const Need& need, double a = 1, const Price& price = counted_cost) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Task task(entry);
  task.parameters.set("a", a);
  return choose(task, need, truth, price);
}

}  // namespace

TEST_CASE("the cheapest method that holds is chosen, and tested elsewhere", "[choose]") {
  const Choice choice = choose_for(asked(0.05, 10));
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "coarse");
  CHECK(choice.chosen->evaluations_per_frame == 0.01);
  CHECK(choice.margin() > 1);
  CHECK(choice.seen.size() == 3);
  CHECK(choice.unseen.size() == 3);
  CHECK(choice.seen != choice.unseen);
  CHECK_FALSE(choice.next_cheaper);
  REQUIRE(choice.next_richer);
  CHECK(choice.next_richer->model == "rich");
}

TEST_CASE("what restarts cost a method counts as often as runs are ended", "[choose]") {
  // One evaluation a frame after 30 to begin with; the other takes two, from the first frame on.
  const auto scene = [](const Parameters& p, const Horizon& horizon, const Reference&) {
    const auto frames = static_cast<std::size_t>(horizon.count());
    Quantity q{"place", "m",        "", {"exact", Value(std::vector<double>(frames, p["a"]))},
               1e-16,   {1e-6, ""}, {}, {}};
    const auto exact = [](double) { return 1e-9; };
    for (long each : {1, 2})
      q.add(method(each == 1 ? "with a history" : "without", "exact", no_knob(), p["a"], horizon.count(),
                   exact, [=](double) { return each * horizon.count() + (each == 1 ? 30 : 0); }));
    return q;
  };
  const Entry contacts{{3, 98},
                       "",
                       {"contacts", "", parameters,
                        Scene{scene, 10, 0.01, "a", {1, 2}, {"a"}, {{"x"}, "s", {{"m", {0}}}}}, nullptr}};
  const Task task(contacts);
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Need need = asked(0.01, 100);
  const auto chosen = [&] { return *choose(task, need, truth, counted_cost).chosen; };
  CHECK(chosen().model == "with a history");
  CHECK(chosen().seconds_per_frame == Approx(1.03e-9));
  need.restart_every = 10;
  CHECK(chosen().model == "with a history");
  CHECK(chosen().seconds_per_frame == Approx(1.03e-9 * (1 + 29.97 / 1.03 / 100)));
  need.restart_every = 2;
  CHECK(chosen().model == "without");
  CHECK(chosen().seconds_per_frame == Approx(2e-9));
}

TEST_CASE("a coarse model that fails beside the start asked for is not chosen", "[choose]") {
  const Choice choice = choose_for(asked(0.005, 1));
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "rich");
  REQUIRE(choice.next_cheaper);
  CHECK(choice.next_cheaper->model == "stepping");
  CHECK(choice.next_cheaper->outcome == Outcome::inaccurate);
}

TEST_CASE("steps divide the frame, and the first that holds is taken", "[choose]") {
  const Choice choice = choose_for(asked(0.06, 0.1), 5);
  const auto stepping = std::ranges::find(choice.candidates, "stepping", &Candidate::model);
  REQUIRE(stepping != choice.candidates.end());
  CHECK(stepping->holds());
  CHECK(std::round(1 / (stepping->setting * 10)) == 10);
}

TEST_CASE("a simple method is one of fixed step or closed form that holds with a margin of three",
          "[choose]") {
  Need need = asked(0.1, 0.3);
  need.objective = Objective::simple;
  const Choice margin = choose_for(need, 5);
  REQUIRE(margin.chosen);
  CHECK(margin.by_objective);
  CHECK(margin.chosen->model == "stepping");
  CHECK(margin.chosen->error <= 1 / 3.0);
  need.error = 1e-7;
  const Choice rich = choose_for(need, 5);
  REQUIRE(rich.chosen);
  CHECK_FALSE(rich.by_objective);
  CHECK(rich.chosen->model == "rich");
}

TEST_CASE("of what costs the same within a quarter the most accurate is chosen, and the tie is told",
          "[choose]") {
  const auto price = [](const Method& m, double) -> Time {
    return {m.model == "coarse" ? 1e-6 : m.model == "rich" ? 1.2e-6 : 1, 0};
  };
  const Choice tie = choose_for(asked(0.05, 10), 1, price);
  REQUIRE(tie.chosen);
  CHECK(tie.chosen->model == "rich");
  REQUIRE_FALSE(tie.ties.empty());
  CHECK(tie.ties.front().model == "coarse");
  const auto dearer = [](const Method& m, double) -> Time {
    return {m.model == "coarse" ? 1e-6 : m.model == "rich" ? 1.3e-6 : 1, 0};
  };
  CHECK(choose_for(asked(0.05, 10), 1, dearer).chosen->model == "coarse");
  const auto noisy = [](const Method& m, double) -> Time {
    return {m.model == "coarse" ? 1e-6 : m.model == "rich" ? 1.3e-6 : 1, 0.2e-6};
  };
  CHECK(choose_for(asked(0.05, 10), 1, noisy).chosen->model == "rich");
}

TEST_CASE("only, exclude: words of models and algorithms", "[choose]") {
  Need need = asked(0.05, 10);
  need.exclude = {"coarse"};
  CHECK(choose_for(need).chosen->model == "rich");
  need.only = {"explicit"};
  need.error = 1e-5;
  CHECK_FALSE(choose_for(need, 5).chosen);
  need.only = {"nobody"};
  CHECK(complaint([&] {
          choose_for(need);
        }).find("no method is left; this scene has coarse by closed form") != std::string::npos);
}

TEST_CASE("a need relative to the motion is the same at any size", "[choose]") {
  for (double a : {1.0, 8.0}) {
    Need need = asked(2e-8, 10);
    need.relative = true;
    const Choice choice = choose_for(need, a);
    REQUIRE(choice.chosen);
    CHECK(choice.chosen->model == "rich");
    CHECK(choice.chosen->setting == 1e-4);
  }
}

TEST_CASE("a need that nothing meets is said, with the nearest miss", "[choose]") {
  Need need = asked(1e-9, 10);
  need.budget = 1e-9;
  const Choice poor = choose_for(need);
  CHECK_FALSE(poor.chosen);
  REQUIRE(poor.nearest_miss);
  CHECK(poor.nearest_miss->holds());
  CHECK(poor.nearest_miss->seconds_per_frame > 1e-9);
  CHECK(choice_text(poor, false).find("times the budget") != std::string::npos);

  const Choice impossible = choose_for(asked(1e-15, 10));
  CHECK_FALSE(impossible.chosen);
  REQUIRE(impossible.nearest_miss);
  CHECK(impossible.nearest_miss->model == "rich");
  CHECK(choice_text(impossible, false).find("Nothing here meets that") != std::string::npos);
}

TEST_CASE("an error is shown in the unit asked in", "[choose]") {
  Need need = asked(0.05, 10);
  need.shown = {{"m", {"cm", 0.01}}};
  const Choice choice = choose_for(need);
  CHECK(choice_text(choice, false).find("place within 5 cm at every frame") != std::string::npos);
  CHECK(choice_json(choice).find("\"error\": 5.0") != std::string::npos);
  CHECK(choice_csv(choice).find("error [cm]") != std::string::npos);
}

TEST_CASE("a precision is asked for, and what is chosen in double is tried in float", "[choose]") {
  Need need = asked(0.05, 10, 100);
  need.only = {"stepping"};
  const auto precisions = [](const Choice& choice) {
    std::set<Precision> all;
    for (const Candidate& t : choice.candidates) all.insert(t.precision);
    return all;
  };
  const Choice in_double = choose_for(need);
  REQUIRE(in_double.chosen);
  CHECK(precisions(in_double) == std::set{Precision::in_double});
  REQUIRE(in_double.in_float);
  CHECK(in_double.in_float->algorithm == "explicit in float");
  CHECK(in_double.in_float->setting == in_double.chosen->setting);
  CHECK(in_double.in_float->holds());
  CHECK(answer_text(in_double).find("in float: error 0.02 m, holds") != std::string::npos);
  CHECK(choice_csv(in_double).find("stepping,explicit,double,") != std::string::npos);

  need.in_float = true;
  CHECK(precisions(choose_for(need)).size() == 2);
  need.in_double = false;
  const Choice in_float = choose_for(need);
  REQUIRE(in_float.chosen);
  CHECK(in_float.chosen->algorithm == "explicit in float");
  CHECK(precisions(in_float) == std::set{Precision::in_float});
  CHECK_FALSE(in_float.in_float);
  CHECK(answer_text(in_float).find("in float:") == std::string::npos);
  CHECK(choice_json(in_float).find("\"precision\": \"float\"") != std::string::npos);

  need.in_double = true, need.in_float = false, need.error = 0.015;
  CHECK(answer_text(choose_for(need)).find("in float: inaccurate, error 0.02 m at a = 1: fails") !=
        std::string::npos);
  need.only = {"rich"};
  CHECK(answer_text(choose_for(need)).find("in double only") != std::string::npos);
}

TEST_CASE("what fails at a higher cost than the chosen one's is not followed to finer settings", "[choose]") {
  Need need = asked(5e-4, 10);
  const auto steps_of = [](const Choice& choice) {
    const auto stepping = std::ranges::find(choice.candidates, "stepping", &Candidate::model);
    return stepping == choice.candidates.end() ? 0 : std::lround(1 / (stepping->setting * 10));
  };
  const Choice left = choose_for(need);
  CHECK(left.chosen->model == "rich");
  CHECK(left.explanation.left == 1);
  CHECK(steps_of(left) == 16);
  need.exclude = {"coarse", "rich"};
  const Choice followed = choose_for(need);
  REQUIRE(followed.chosen);
  CHECK(followed.explanation.left == 0);
  CHECK(steps_of(followed) == 256);
}

TEST_CASE("what fails at a lower cost than the chosen one's is followed", "[choose]") {
  const auto price = [](const Method& m, double setting) -> Time {
    return {m.model == "stepping" ? 1e-9 / setting : 1, 0};
  };
  const Choice choice = choose_for(asked(5e-4, 10), 1, price);
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "stepping");
}

TEST_CASE("an answer explains what was tried and where its time went", "[choose]") {
  const Choice choice = choose_for(asked(0.05, 10));
  const Explanation& e = choice.explanation;
  CHECK(e.starts == 6);
  CHECK(e.methods == 4);
  CHECK(e.rounds == 1);
  CHECK(e.settings >= e.methods);
  CHECK(e.timed >= 1);
  CHECK(e.evaluations > 0);
  CHECK(e.truth_by == "exact");
  CHECK(e.truth_error == 1e-16 / 0.05);
  const std::string text = explanation_text(choice);
  CHECK(text.find("true motions: ") != std::string::npos);
  CHECK(text.find("4 methods at ") != std::string::npos);
  CHECK(choice_json(choice).find("\"explanation\"") != std::string::npos);
}

TEST_CASE("an answer that takes too long is no answer", "[choose]") {
  Need need = asked(0.05, 10);
  need.time_limit = 1e-9;
  CHECK_THROWS_AS(choose_for(need), OutOfTime);
}

TEST_CASE("what cannot be chosen for is refused", "[choose]") {
  CHECK(complaint([] { choose_for(asked(0, 10)); }).find("the error must be positive") != std::string::npos);
  CHECK(complaint([] { choose_for(asked(0.1, 1e-3)); }).find("shorter than a frame") != std::string::npos);
  CHECK(complaint([] { choose_for(asked(1e-30, 10)); }).find("known to") != std::string::npos);
  Need period = asked(0.1, 10);
  period.criterion = Criterion::period;
  CHECK(complaint([&] { choose_for(period); }).find("no two periods") != std::string::npos);
  const Entry still{{7, 99}, "", {"still", "", parameters, {}, nullptr}};
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  CHECK(complaint([&] { choose(Task(still), Need{0.1}, truth); }).find("has no motion") != std::string::npos);
}
