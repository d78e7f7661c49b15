#include "report/study/stability.hpp"

#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "report/charts/chart.hpp"
#include "report/charts/stability_map.hpp"
#include "report/pages/stability_view.hpp"
#include "report/study/approve.hpp"
#include "report/study/limit_records.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double interval = 2;  // s, between two looks at the motion

/// A motion of size 1, observed at four times.
Quantity motion() {
  Quantity quantity{"x", "m", "a length", {"exact", Value{1, 1, 1, 1}}, 0, {0.01, "close"}};
  quantity.samples = 4;
  return quantity;
}

const Answer fine{Value{1, 1, 1, 1}, 4}, near_by{Value{1, 1, 1, 1.5}, 4}, far{Value{1, 1, 1, 100}, 4};

/// A method that is unstable at some steps, by theory and as measured.
Method method(const std::function<bool(double)>& unstable, std::vector<ode::Tongue> theory = {}) {
  const auto lost = [unstable](double step) {
    const double time = unstable(step) ? 7.0 : infinity;
    return ode::Loss{time, {time, time, time}};
  };
  const auto lost_along_truth = [unstable](double step) { return unstable(step) ? 7.0 : infinity; };
  return {"model",
          "algorithm",
          halving("step", 1, 4),
          [unstable](double step) { return unstable(step) ? far
                                           : step > 0.03  ? near_by
                                                          : fine; },
          Outcome::ok,
          "",
          [theory] { return theory; },
          [lost, lost_along_truth](const ode::Criteria&) {
            return Disturbances{1000,
                                2000,
                                1,
                                true,
                                lost,
                                [](double) { return 0.0; },
                                [](double, double) { return 0.0; },
                                lost_along_truth,
                                [](double) { return 0.0; }};
          }};
}

Method stable_up_to(double limit) {
  return method([limit](double step) { return step > limit; }, {{limit, infinity}});
}

Limit found(const Method& m) { return limit_of(motion(), m, interval); }

const std::filesystem::path reference_folder = std::filesystem::path(ODDITY_SOURCE) / "reference";

/// A scene's motion over a horizon, with or without its reference.
Quantity scene(Number number, double horizon, const Reference& truth = Reference::nothing()) {
  for (const Entry& entry : registry())
    if (entry.number == number)
      return motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), Horizon{horizon}, truth);
  throw std::logic_error("no such scene");
}

Limit limit_in(const Quantity& quantity, std::string_view model, std::string_view algorithm, double horizon) {
  return limit_of(quantity, *method_of(quantity, model, algorithm), horizon / quantity.samples);
}

/// A pendulum of 1 s from 1 rad, with and without a conserved energy.
struct Silent {
  using State = std::array<double, 2>;
  State start() const { return {1, 0}; }
  template <class X>
  void operator()(const X& x, X& dxdt, const auto&) const {
    using std::sin;
    dxdt[0] = x[1];
    dxdt[1] = -40 * sin(x[0]);
  }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const {
    a[0] = -40 * std::sin(q[0]);
  }
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
};
struct Watched : Silent {
  auto conserved(const State& x, double) const { return energy_of(x[1] * x[1] / 2, -40 * std::cos(x[0])); }
};

/// An error of `a` at step 1: equal to the game's centimetre except for its last bit.
constexpr Parameter at_an_edge[] = {{"a", 0.01, "m", "error at a step of 1", 0.001, 0.1}};
Quantity error_of_a(const Parameters& p, const Horizon&, const Reference&) {
  Quantity q{"place", "m", "a place", {"zero", Value{0, 0, 0, 0}}, 0, {1e-6, "a micrometre"}};
  Method m = method([](double) { return false; });
  m.run = [a = p["a"]](double step) { return Answer{Value(std::vector(4, a * step))}; };
  return q.add(m);
}
const Entry edge{{3, 99},
                 "",
                 {"made up", "", at_an_edge,
                  Scene{.motion = error_of_a,
                        .horizon = 4,
                        .game_tolerance = 0.01,
                        .sweep_parameter = "a",
                        .sweep_values = {0.01, 0.011},
                        .perturbed_parameters = {"a"},
                        .axes = {{"x"}, "s", {{"m", {0}}}}},
                  nullptr}};

}  // namespace

TEST_CASE("the first loss of stability is found to 0.5 %, from below", "[stability]") {
  for (double threshold : {1.9, 0.7, 0.3, 0.0501}) {
    const Limit limit = found(stable_up_to(threshold));
    INFO("threshold " << threshold << ": " << shown_step(limit));
    CHECK(near(limit.stable, threshold, 0.005 * threshold));
    CHECK(limit.stable <= threshold);
    CHECK(limit.unstable > threshold);
    CHECK(limit.lost == 7);
    CHECK(limit.step() == limit.stable);
    REQUIRE(limit.at);
    REQUIRE(limit.broken);
    CHECK(limit.at->setting <= limit.stable);
    CHECK(limit.broken->setting >= std::min(limit.unstable, interval));
    for (double step : {limit.at->setting, limit.broken->setting})
      CHECK(near(interval / step, std::round(interval / step), 1e-9));
    CHECK(beyond(limit) == "diverged");
    REQUIRE(limit.within);
    CHECK(limit.within->setting <= 0.03);
    CHECK(limit.within->setting > 0.0295);
  }
}

TEST_CASE("steps beyond a tongue do not hide it", "[stability]") {
  const auto tongue = [](double step) { return step > 0.5 && step < 0.6; };
  for (const Limit& limit : {found(method(tongue, {{0.5, 0.6}})), found(method(tongue))}) {
    CHECK(near(limit.step(), 0.5, 0.0025));
    CHECK(limit.longest == interval);
  }
  const Limit wrong_theory = found(method([](double step) { return step > 0.2; }, {{1.8, infinity}}));
  CHECK(near(wrong_theory.step(), 0.2, 0.001));
  CHECK(near(agreement(wrong_theory), 0.2 / 1.8, 0.001));
}

TEST_CASE("the limit is every step only where theory proves it", "[stability]") {
  const auto never = [](double) { return false; };
  const Limit proved = found(method(never)), tried = found(method(never, {{3, infinity}}));
  CHECK(proved.step() == infinity);
  CHECK(shown_step(proved) == "every step");
  CHECK(tried.step() == interval);
  CHECK(shown_step(tried) == "at least 2");
  CHECK(agreement(tried) == 1);
  for (const Limit& limit : {proved, tried}) {
    CHECK_FALSE(limit.broken);
    CHECK(beyond(limit) == "stable");
    CHECK(how_it_breaks(limit, {}).empty());
  }
}

TEST_CASE("a method that no step keeps stable has none", "[stability]") {
  const Limit limit = found(method([](double) { return true; }, {{0, infinity}}));
  CHECK(limit.step() == 0);
  CHECK(limit.theory() == 0);
  CHECK(shown_step(limit) == "none");
  CHECK(shown_tongues(limit) == "every step");
  CHECK(agreement(limit) == 1);
  CHECK_FALSE(limit.at);
  CHECK_FALSE(limit.within);
}

TEST_CASE("McLachlan's tongues are found, in theory and as measured", "[stability]") {
  const Quantity pulleys = scene({3, 19}, 8);
  const auto pulley = [&](std::string_view algorithm) {
    return limit_in(pulleys, "two coordinates", algorithm, 8);
  };
  const Limit verlet = pulley("velocity Verlet"), mclachlan = pulley("McLachlan 4");
  const double fastest = 2 / verlet.theory();  // Verlet's limit is h omega = 2
  CHECK(near(verlet.step(), 2 / fastest, 0.02 * verlet.step()));
  CHECK(near(mclachlan.theory(), 2.967808 / fastest, 0.001));
  CHECK(near(mclachlan.step(), 2.967808 / fastest, 0.02 * mclachlan.step()));
  CHECK(mclachlan.tongues.size() == 3);
  const Limit pendulum = limit_in(scene({3, 5}, 10), "one angle", "McLachlan 4", 10);
  CHECK(near(pendulum.theory(), 2.967808 / std::sqrt(9.81), 0.002));
  CHECK(within(pendulum.step(), 0.93, 0.995));
  const Limit planet = limit_in(scene({3, 3}, 2), "Cartesian", "McLachlan 4", 2);
  CHECK(within(planet.step(), 0.2, 0.3825));
  const Limit bar = limit_in(scene({3, 23}, 10), "one angle", "Adams-Bashforth-Moulton 6", 10);
  CHECK(within(bar.step(), 0.1, 1.0 / 6));
}

TEST_CASE("explicit Euler has no stable step on an undamped pendulum", "[stability]") {
  const Limit limit = limit_in(scene({3, 5}, 10), "one angle", "explicit Euler", 10);
  CHECK(limit.step() == 0);
  CHECK(limit.theory() == 0);
  REQUIRE(limit.unstable > 0);
  CHECK(limit.unstable <= 0.02 / 2.9);
  CHECK(std::isfinite(limit.lost));
}

TEST_CASE("the recorded limit is every step only for implicit Euler, and where nothing can grow",
          "[stability]") {
  for (const ApprovedLimit& a : read_limits(reference_folder / "approved")) {
    INFO(a.place);
    // No mode at all; and none of the two particles with a rod that semi-implicit Euler's step makes grow.
    const bool free_fall =
        a.exercise == "3.29" && (a.model == "x, y, theta" || a.algorithm == "semi-implicit Euler");
    if (std::isinf(a.step)) CHECK((a.algorithm == "linearly implicit Euler" || free_fall));
    if (std::isinf(a.step)) CHECK((std::isinf(a.theory) && a.unstable == "no step"));
    CHECK(a.error.has_value() == (a.step > 0));
  }
}

TEST_CASE("the page calls explicit Euler unconditionally unstable if its row has no stable step",
          "[stability]") {
  const Limits all = read_limits(reference_folder / "approved");
  const auto row = std::ranges::find_if(all, [](const ApprovedLimit& a) {
    return a.exercise == "3.5" && a.model == "one angle" && a.algorithm == "explicit Euler";
  });
  REQUIRE(row != all.end());
  CHECK((row->step == 0 && row->theory == 0 && row->unstable == "every step"));
  CHECK(stability_page({}).find("explicit Euler is unconditionally unstable") != std::string::npos);
}

TEST_CASE("symplectic Euler loses the pendulum where four steps make one swing", "[stability]") {
  const double a = std::numbers::pi / 6, frequency = std::sqrt(9.81) * (1 - a * a / 16);
  const Limit limit = limit_in(scene({3, 5}, 10), "one angle", "symplectic Euler", 10);
  CHECK(
      near(limit.step() * frequency, std::sqrt(2.0), 0.04));  // a quarter turn: cos = 1 - (h omega)^2 / 2 = 0
}

TEST_CASE("a limit does not depend on the horizon shown", "[stability]") {
  const auto at = [](Number number, std::string_view model, std::string_view algorithm, double horizon) {
    return limit_in(scene(number, horizon), model, algorithm, horizon).step();
  };
  for (const char* algorithm : {"velocity Verlet", "Runge-Kutta 4", "McLachlan 4", "Adams-Bashforth 4"}) {
    INFO(algorithm);
    for (double horizon : {5.0, 20.0}) {
      const double usual = at({3, 5}, "one angle", algorithm, 10);
      CHECK(near(at({3, 5}, "one angle", algorithm, horizon), usual, 0.02 * usual));
    }
    for (double horizon : {4.0, 16.0}) {
      const double usual = at({3, 19}, "two coordinates", algorithm, 8);
      CHECK(near(at({3, 19}, "two coordinates", algorithm, horizon), usual, 0.02 * usual));
    }
  }
}

TEST_CASE("a limit that depends on the watched time or the allowed size is marked", "[stability]") {
  // Lost after 1500 s beyond 0.4, and at once beyond 0.5; grown to three times its size beyond 0.3.
  const auto slowly = [](double step) {
    const double time = step > 0.5 ? 1 : step > 0.4 ? 1500 : infinity;
    return ode::Loss{time, {time, time, time}};
  };
  const auto swelling = [](double step) {
    const double time = step > 0.5 ? 1 : infinity, size = step > 0.3 ? 2 : time;
    return ode::Loss{time, {size, size, time}};
  };
  const auto limit_by = [](const std::function<ode::Loss(double)>& lost) {
    Method m = stable_up_to(0.5);
    m.disturbances = [lost, usual = m.disturbances](const ode::Criteria& c) {
      Disturbances d = usual(c);
      d.lost = lost;
      return d;
    };
    return measured_limit(m, interval);
  };
  const Limit slow = limit_by(slowly), swollen = limit_by(swelling);
  REQUIRE((slow.soft && swollen.soft));
  CHECK(near(slow.stable, 0.5, 0.003));
  CHECK(near(slow.soft->least, 0.4, 0.003));
  CHECK(near(slow.soft->most, 0.5, 0.003));
  CHECK(near(swollen.stable, 0.3, 0.003));
  CHECK(near(swollen.soft->most, 0.5, 0.003));
  CHECK_FALSE(measured_limit(stable_up_to(0.5), interval).soft);
}

TEST_CASE("a limit does not depend on a conserved quantity", "[stability]") {
  const auto limits = [](const auto& model) {
    Quantity quantity = motion();
    SceneMethods(quantity, {4}, halving("step", 1, 4), tolerances()).by_engine_integrators("model", model);
    std::vector<double> all;
    for (const Method& m : quantity.methods)
      if (m.disturbances) all.push_back(limit_of(quantity, m, 1).step());
    return all;
  };
  const auto silent = limits(Silent{});
  CHECK(silent.size() == 4);
  CHECK((limits(Watched{}) == silent));
}

TEST_CASE("no step below a limit is unstable, nor one that does not divide an interval", "[stability]") {
  struct Case {
    Number number;
    const char* model;
    double horizon;
  };
  for (const Case& c : {Case{{3, 5}, "one angle", 10}, Case{{3, 23}, "one angle", 10}}) {
    const Quantity shown = scene(c.number, c.horizon);
    const Quantity later = scene(c.number, 6 * c.horizon);
    for (const Method& m : shown.methods) {
      if (m.model != c.model || !m.disturbances) continue;
      const double limit = limit_of(shown, m, c.horizon / shown.samples).step();
      if (!(limit > 0) || std::isinf(limit)) continue;
      const auto largest = [&](const Answer& answer) {
        double most = 0;
        for (double x : answer.value) most = std::max(most, std::abs(x));
        return answer.reached() ? most : infinity;
      };
      const double size = largest(m.run(limit / 50)) + largest(m.run(limit / 40));
      for (double step = limit / 8; step < limit; step *= 1.0173) {
        INFO(m.algorithm << " at " << step << ", stable to " << limit);
        CHECK(largest(method_of(later, m.model, m.algorithm)->run(step)) <= 2 * size);
      }
    }
  }
}

TEST_CASE("stability survives conversion to JSON and back, with infinite limits", "[stability]") {
  Results results;
  ExerciseResult& e = results.exercises.emplace_back();
  e.number = {3, 5};
  Stability& s = e.stability.emplace();
  s.quantity = "x";
  s.steps = {1, 0.5};
  s.parameter = "a";
  Limit limit = found(stable_up_to(0.1));
  limit.cure = limit.at;
  const Limit none = found(method([](double) { return true; }, {{0, 1.5}, {1.6, infinity}}));
  s.limits = {limit, found(method([](double) { return false; })), none};
  s.map = {{"model", "algorithm", 0.1, infinity, {Outcome::diverged, Outcome::ok}, {true, false}}};
  const std::string json = to_json(results);
  const Results read = results_from_json(json, "here");
  CHECK(to_json(read) == json);
  CHECK(read.exercises[0].stability->limits[1].theory() == infinity);
  CHECK(read.exercises[0].stability->limits[2].tongues.at(1).to == infinity);
  CHECK(stability_page(read) == stability_page(results));
  CHECK(stability_text(read.exercises[0]) == stability_text(e));
  CHECK(map_svg(read.exercises[0]) == map_svg(e));
  CHECK(limit_rows(read) == limit_rows(results));
  CHECK(map_rows(results) == "3.5,model,algorithm,0.1,Xo,*.\n");
}

TEST_CASE("recorded limits and maps are read, broken ones named by line", "[stability]") {
  const ScratchFolder folder;
  const std::string head =
      "exercise,model,algorithm,step,theory,unstable,watched,soft,error,needed,beyond,why\n";
  const std::string file =
      folder.file("limits.csv", head + "3.5,m,a,0.1,inf,no step,2,0.1 to 0.2,0.5,,diverged,\"so, so\"\n")
          .string();
  const Limits limits = read_limits(folder.path());
  REQUIRE(limits.size() == 1);
  CHECK(limits[0].step == 0.1);
  CHECK(limits[0].theory == infinity);
  CHECK(limits[0].unstable == "no step");
  CHECK(limits[0].watched == 2);
  CHECK(limits[0].soft == "0.1 to 0.2");
  CHECK(limits[0].error == 0.5);
  CHECK_FALSE(limits[0].needed);
  CHECK(limits[0].why == "so, so");
  const auto said = [&](const std::string& text) {
    folder.file("limits.csv", text);
    const std::string all = complaint([&] { read_limits(folder.path()); });
    return all.starts_with(file) ? all.substr(file.size()) : all;
  };
  CHECK(said(head + "3.5,m,a,x,1,,,,1,1,ok,\n") == ":2: 'x' in column 4 is not a number");
  CHECK(said(head + "3.5,m,a,-1,1,,,,1,1,ok,\n") == ":2: a step must be zero or positive, or inf");
  CHECK(said(head + "3.5,m,a,1,1,,,,1,1,ok,\n3.5,m,a,1,1,,,,1,1,ok,\n") == ":3: a second row for 3.5, m, a");
  CHECK(said("exercise,step\n3.5,1\n") ==
        ":1: the columns must be "
        "exercise,model,algorithm,step,theory,unstable,watched,soft,error,needed,beyond,why");
  const auto maps = [&](const std::string& rows) {
    folder.file("stability_maps.csv", "exercise,model,algorithm,value,outcomes,fragile\n" + rows);
    return read_maps(folder.path());
  };
  CHECK(maps("3.5,m,a,1,Xo,\n3.5,m,a,2,oo,.*\n").at(1).outcomes == "oo");
  CHECK(maps("3.5,m,a,1,Xo,\n3.5,m,a,2,oo,.*\n").at(1).fragile == ".*");
  for (const std::string marks : {"*", "***", "o*"})
    CHECK(complaint([&] {
            maps("3.5,m,a,1,Xo," + marks + "\n");
          }).find(":2: '" + marks + "' in column 6 must be a dot") != std::string::npos);
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
    return to_json(with_stability(blank, tasks, truth));
  };
  CHECK((examined(1) == examined(4)));
}

TEST_CASE("a letter of a map may differ on another machine only where the last bits decide", "[stability]") {
  const auto ends_so = [](double a, Outcome outcome) {
    const MapRow row{"model", "algorithm", a, infinity, {Outcome::ok}, {false}};
    return ends_so_within_roundings(Task(edge), row, 0, outcome, Reference::nothing());
  };
  CHECK(ends_so(0.01, Outcome::ok));
  CHECK(ends_so(0.01, Outcome::inaccurate));
  CHECK_FALSE(ends_so(0.01, Outcome::diverged));
  CHECK(ends_so(0.01 * (1 - 1e-12), Outcome::ok));
  CHECK_FALSE(ends_so(0.01 * (1 - 1e-12), Outcome::inaccurate));
  CHECK_FALSE(ends_so(0.011, Outcome::ok));
}

TEST_CASE("a letter that roundings decide is marked, and no other", "[stability]") {
  const std::vector<Task> tasks{Task(edge)};
  Results blank;
  blank.exercises.emplace_back().number = edge.number;
  const Results results = with_stability(blank, tasks, Reference::nothing());
  for (const MapRow& row : results.exercises[0].stability->map) {
    INFO("an error of " << row.value << " ends " << letters(row));
    CHECK(fragile_cells(row) == (row.value == 0.01 ? "*..........." : ""));
    CHECK(letters(row).substr(0, 2) == (row.value <= 0.01 ? "oo" : "io"));
  }
  CHECK(stability_text(results.exercises[0])
            .find("decide how these end: model, algorithm at 0.01 m, step 1 ") != std::string::npos);
}

TEST_CASE("roundings decide at most one in a hundred recorded letters", "[stability]") {
  std::ptrdiff_t letters = 0, marked = 0;
  for (const ApprovedMap& row : read_maps(std::filesystem::path(ODDITY_SOURCE) / "reference" / "approved")) {
    letters += std::ssize(row.outcomes);
    marked += std::ranges::count(row.fragile, '*');
  }
  CHECK(letters > 10'000);
  CHECK(100 * marked <= letters);
}

TEST_CASE("tongues are read as they are shown", "[stability]") {
  for (const char* text : {"no step", "every step", "from 0.02", "to 0.219, 0.22 to 0.223, from 1e-05",
                           "0.453 to 0.572", "0.464 to 0.555, from 0.882"}) {
    INFO(text);
    const auto tongues = tongues_shown_as(text);
    REQUIRE(tongues);
    Limit limit;
    limit.tongues = *tongues;
    CHECK(shown_tongues(limit) == text);
  }
  for (const char* text : {"", "none", "from", "0.4 to 0.5 and more"})
    CHECK_FALSE((tongues_shown_as(text) && !tongues_shown_as(text)->empty()));
}

TEST_CASE("ranges of limits are read as they are shown", "[stability]") {
  for (const char* text : {"0.464 to 0.555", "0 to 0.13"}) {
    const auto soft = soft_shown_as(text);
    REQUIRE(soft);
    CHECK(shown_soft(*soft) == text);
  }
  for (const char* text : {"", "0.4", "0.4 to 0.5 and more", "to 0.5", "0.4to 0.5"})
    CHECK_FALSE(soft_shown_as(text));
}

TEST_CASE("limits looked for where they are approved are those of a scan", "[stability]") {
  const Reference truth(reference_folder);
  const Task task(*std::ranges::find(registry(), Number{3, 5}, &Entry::number));
  Results blank;
  blank.exercises.emplace_back().number = {3, 5};
  const Limits approved = read_limits(reference_folder / "approved");
  const auto limits_with = [&](const Limits& records) {
    return with_stability(blank, std::span(&task, 1), truth, {}, {}, &records).exercises[0].stability->limits;
  };
  Limits wrong = approved;
  for (ApprovedLimit& row : wrong) {
    row.step *= 1.2, row.theory *= 0.8, row.why = "no reason";
    row.soft = row.soft.empty() ? "0.1 to 0.2" : "";
    const bool is_odd = (&row - wrong.data()) % 2 == 1;
    row.needed = !row.needed ? 0.01 : is_odd ? std::optional<double>() : 1.3 * *row.needed;
  }
  for (const Limit& limit : limits_with(wrong)) {
    const auto row = std::ranges::find_if(approved, [&](const ApprovedLimit& one) {
      return one.exercise == "3.5" && one.model == limit.model && one.algorithm == limit.algorithm;
    });
    INFO(limit.model << ", " << limit.algorithm);
    REQUIRE(row != approved.end());
    CHECK(difference(limit, *row) == "");
  }
}
