#include "report/study/fit.hpp"

#include <cmath>
#include <functional>

#include "chapters/random.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/catalog.hpp"

using namespace oddity;

namespace {

/// A method with one trial at each setting, with this error and number of evaluations.
MethodResult method(const std::string& resolution, const std::vector<double>& settings,
                    const std::function<double(double)>& error) {
  MethodResult m{"model", "algorithm", Outcome::ok, "", {}};
  for (double setting : settings) {
    TimedTrial t;
    t.resolution = resolution;
    t.setting = setting;
    t.error = error(setting);
    t.outcome = std::isfinite(t.error) ? Outcome::ok : Outcome::non_finite;
    m.trials.push_back(t);
  }
  return m;
}

/// A quantity of size 1, known to 1e-16.
QuantityResult quantity_of(std::vector<MethodResult> methods) {
  return {"q", "m", "", {"table", 1.0}, 1e-16, {1e-6, "a reason"}, std::move(methods), {}};
}

std::optional<Fit> fitted(const MethodResult& m) { return fit(quantity_of({m}), m); }

const std::vector<double> steps = halving("step", 0.5, 10).settings;

TimedTrial trial(long evaluations, double error, double seconds, Outcome outcome = Outcome::ok) {
  TimedTrial t;
  t.resolution = "step";
  t.error = error;
  t.evaluations = evaluations;
  t.outcome = outcome;
  t.time.seconds = seconds;
  return t;
}

}  // namespace

TEST_CASE("the order in the step is the slope between saturation and rounding", "[fit]") {
  const auto m = method("step", steps, [](double h) { return std::min(2.0, 3 * std::pow(h, 4)) + 2e-11; });
  const auto f = fitted(m);
  REQUIRE(f);
  CHECK(std::abs(f->exponent - 4) < 0.02);
  CHECK(std::abs(f->factor - 3) < 0.2);
  CHECK(shown_fit(m, f).starts_with("order "));
  CHECK(m.trials[f->last].error > 2e-10);
}

TEST_CASE("coarse trials that follow another law are left out", "[fit]") {
  const auto m = method("step", steps, [](double h) { return 0.1 * h * std::exp(10 * h); });
  const auto f = fitted(m);
  REQUIRE(f);
  CHECK(std::abs(f->exponent - 1) < 0.15);
  CHECK(f->last == steps.size() - 1);
  CHECK(f->first > 2);
}

TEST_CASE("trials over less than a factor of four have no order", "[fit]") {
  const auto law_over = [](double factor) {
    std::vector<double> x, y;
    for (int i = 0; i < 5; ++i) x.push_back(std::pow(factor, -i / 4.0)), y.push_back(3 * x.back() * x.back());
    return asymptotic_law(x, y);
  };
  CHECK(law_over(4));
  CHECK(!law_over(3.9));
}

TEST_CASE("the order in a count is that in 1/n", "[fit]") {
  const auto m = method("panels", doubling("panels", 4, 6).settings, [](double n) { return 5 / (n * n); });
  const auto f = fitted(m);
  REQUIRE(f);
  CHECK(std::abs(f->exponent - 2) < 1e-9);
  CHECK(std::abs(f->factor - 5) < 1e-9);
  CHECK(shown_fit(m, f) == "order 2.00");
}

TEST_CASE("errors that may scatter have a law if half of them follow it", "[fit]") {
  const auto law_over_first = [](int count) {
    return fitted(method("tolerance", halving("tolerance", 1e-3, 10).settings, [&](double tolerance) {
      return 20 * std::max(tolerance, 1e-3 * std::pow(0.5, count - 1));
    }));
  };
  CHECK(law_over_first(5));
  CHECK(!law_over_first(4));
}

TEST_CASE("a tolerance has an exponent and a factor, and may scatter", "[fit]") {
  Random random(1);
  const auto m = method("tolerance", tolerances().settings,
                        [&](double tol) { return 20 * tol * std::exp(random.between(-0.7, 0.7)); });
  const auto f = fitted(m);
  REQUIRE(f);
  CHECK(std::abs(f->exponent - 1) < 0.1);
  CHECK(shown_fit(m, f).starts_with("error ~ tol^"));
}

TEST_CASE("samples scatter, and have no order", "[fit]") {
  const auto m =
      method("samples", doubling("samples", 64, 5).settings, [](double n) { return 1 / std::sqrt(n); });
  CHECK(shown_fit(m, fitted(m)) == "error ~ (1/samples)^0.50");
}

TEST_CASE("a power law through points is the straight line of their logarithms", "[fit]") {
  const std::vector<double> x{1, 2, 8}, y{3, 12, 192};
  const PowerLaw law = power_law(x, y);
  CHECK(std::abs(law.exponent - 2) < 1e-14);
  CHECK(std::abs(law.factor - 3) < 1e-13);
  CHECK(std::abs(law(4) - 48) < 1e-12);
}

TEST_CASE("a slope that is still changing is no order", "[fit]") {
  // The higher power dominates first, as an energy's error of order 5 does before a path's of order 4.
  CHECK_FALSE(fitted(method("step", steps, [](double h) { return std::pow(h, 5) + 0.02 * std::pow(h, 4); })));
  // A third of the last error is the model's.
  const std::vector<double> six(steps.begin(), steps.begin() + 6);
  CHECK_FALSE(fitted(method("step", six, [](double h) { return 0.1 * h + 0.001; })));
  // Three trials may agree by accident.
  CHECK_FALSE(fitted(method("step", {0.5, 0.25, 0.125}, [](double h) { return h; })));
}

TEST_CASE("the order is reported well above the method's floor", "[fit]") {
  const auto m = method("step", steps, [](double h) { return h * h + 1e-5; });
  const auto f = fitted(m);
  REQUIRE(f);
  CHECK(std::abs(f->exponent - 2) < 0.02);
  CHECK(m.trials[f->last].error > 3e-4);
  CHECK(m.trials[f->last + 1].error < 3e-4);
}

TEST_CASE("in chapter 3, the order shown for an algorithm is its order", "[fit]") {
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  std::vector<Task> chapter;
  for (const Entry& entry : registry())
    if (entry.number.chapter == 3) chapter.emplace_back(entry);
  int shown = 0;
  const Results results = run(chapter, truth, false);
  for (const ExerciseResult& e : results.exercises)
    for (const QuantityResult& q : e.quantities)
      for (const MethodResult& m : q.methods) {
        const auto algorithm = std::ranges::find(ode::catalog(), m.algorithm, &ode::CatalogEntry::name);
        const auto f = fit(q, m);
        if (!f || algorithm == ode::catalog().end() || m.trials.front().resolution != "step") continue;
        ++shown;
        INFO(to_string(e.number) << " " << q.name << ": " << m.model << " by " << m.algorithm << ", "
                                 << shown_fit(m, f));
        CHECK(std::abs(f->exponent - algorithm->order) < 0.1);
      }
  CHECK(shown > 100);
}

TEST_CASE("without a power law there is no fit", "[fit]") {
  CHECK_FALSE(fitted(method("step", {0.5, 0.25}, [](double h) { return h; })));
  CHECK_FALSE(fitted(method("", {0}, [](double) { return 1e-3; })));
  CHECK_FALSE(fitted(method("step", steps, [](double) { return 1e-3; })));
  CHECK_FALSE(fitted(method("step", steps, [](double h) { return 1e-12 / h; })));
  CHECK_FALSE(fitted(method("step", steps, [](double h) { return 1e-17 * h; })));
  CHECK_FALSE(
      fitted(method("points", doubling("points", 2, 5).settings, [](double n) { return std::exp(-n); })));
  CHECK_FALSE(fitted(method("terms", {8, 9, 10, 11}, [](double n) { return std::pow(2, -n); })));
  CHECK_FALSE(fitted(method("step", steps, [](double) { return std::nan(""); })));
  Random random(1);
  CHECK_FALSE(fitted(method("step", steps, [&](double) { return random.between(1e-6, 1e-3); })));
}

TEST_CASE("failed trials are no part of a fit", "[fit]") {
  auto m = method("step", {0.5, 0.25, 0.125, 0.0625}, [](double h) { return h * h / 2; });
  REQUIRE(fitted(m));
  m.trials[1].outcome = Outcome::diverged;
  CHECK_FALSE(fitted(m));
}

TEST_CASE("the Pareto front contains the trials that nothing beats", "[fit]") {
  const MethodResult a{
      "a", "x", Outcome::ok, "", {trial(10, 1e-2, 3e-6), trial(20, 1e-4, 2e-6), trial(40, 1e-3, 1e-6)}};
  const MethodResult b{
      "b",
      "x",
      Outcome::ok,
      "",
      {trial(20, 1e-4, 2e-6), trial(20, 1e-3, 4e-6), trial(1, 1e-9, 1e-9, Outcome::stalled),
       trial(1, std::nan(""), 1e-9, Outcome::raised), trial(1, 1e9, 1e-9, Outcome::diverged)}};
  const QuantityResult q = quantity_of({a, b});
  CHECK(pareto_front(q, Cost::evaluations) ==
        std::vector<bool>{true, true, false, true, false, false, false, false});
  CHECK(pareto_front(q, Cost::time) ==
        std::vector<bool>{false, true, true, true, false, false, false, false});
}

TEST_CASE("errors below the floor are equal on the front, and trials without a time are not on it", "[fit]") {
  const MethodResult m{"a", "x", Outcome::ok, "", {trial(10, 1e-17, std::nan("")), trial(20, 0, 1e-6)}};
  const QuantityResult q = quantity_of({m});
  CHECK(pareto_front(q, Cost::evaluations) == std::vector<bool>{true, false});
  CHECK(pareto_front(q, Cost::time) == std::vector<bool>{false, true});
}
