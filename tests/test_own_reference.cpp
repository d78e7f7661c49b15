#include "chapters/own_reference.hpp"

#include "chapters/scene.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

/// x'' = -x from x = 1 at rest.
struct Swing {
  using State = std::array<double, 2>;
  State start() const { return {1, 0}; }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], -x[0]}; }
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
};

const Horizon horizon{2.0};

Answer by_steps(double step) { return observe_integrated<ode::RungeKutta4>(Swing{}, horizon, step); }

Value cosine() {
  std::vector<double> values;
  for (double t : {0.5, 1.0, 1.5, 2.0}) values.push_back(std::cos(t));
  return Value(values);
}

/// Outcomes of Runge-Kutta at two steps, judged by this reference.
std::vector<Outcome> judged(const Known& known) {
  Quantity x = quantity("x", "1", "x", known, {1e-5, "a test"});
  x.add({"swing", "Runge-Kutta 4", {"step", {0.5, 0.01}}, by_steps});
  return {run(x, x.methods[0], 0.5).outcome, run(x, x.methods[0], 0.01).outcome};
}

}  // namespace

TEST_CASE("a closed form judges, and is reported as not independent", "[own]") {
  const Known known = closed_form(cosine(), 1e-15);
  CHECK(known.value == std::vector<double>{std::cos(0.5), std::cos(1.0), std::cos(1.5), std::cos(2.0)});
  CHECK(known.error == 1e-15);
  CHECK(known.source == "closed form, not independent");
  CHECK(judged(known) == std::vector{Outcome::inaccurate, Outcome::ok});
}

TEST_CASE("a finest run judges like a closed form, within its own error", "[own]") {
  const Answer finest = by_steps(1.0 / 1024), half_the_cost = by_steps(1.0 / 512);
  const double error = distance(finest.value, half_the_cost.value);
  const Known known = finest_run(finest, error, "Runge-Kutta 4 at 1/1024");
  CHECK(known.error == error);
  CHECK(distance(Value(known.value), cosine()) < error);
  CHECK(known.source == "finest run of Runge-Kutta 4 at 1/1024, not independent");
  CHECK(judged(known) == std::vector{Outcome::inaccurate, Outcome::ok});
}

TEST_CASE("a run that did not reach its end is no reference: nothing judged by it is ok", "[own]") {
  Answer stalled = by_steps(1.0 / 1024);
  stalled.ending = Ending::stalled;
  const Known known = finest_run(stalled, 1e-9, "Runge-Kutta 4");
  CHECK(std::isnan(known.error));
  for (double value : known.value) CHECK(std::isnan(value));
  for (Outcome outcome : judged(known)) CHECK(outcome != Outcome::ok);
}
