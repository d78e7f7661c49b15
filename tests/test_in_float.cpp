// Methods in float: the algorithms, how they are driven, and what roundings may cost.

#include <cmath>
#include <vector>

#include "chapters/03_rigid_body_motion/05_pendulum/models.hpp"
#include "chapters/in_float.hpp"
#include "report/study/run.hpp"
#include "tests/catch.hpp"

using namespace oddity;

namespace {

/// x' = 1 and the times at which it was asked.
struct Clock {
  mutable std::vector<float> asked = {};
  void operator()(const std::array<float, 2>&, std::array<float, 2>& dxdt, float t) const {
    asked.push_back(t);
    dxdt = {1, 0};
  }
};

/// x'' = -x.
template <class T>
struct Swing {
  void operator()(const std::array<T, 2>& x, std::array<T, 2>& dxdt, T) const { dxdt = {x[1], -x[0]}; }
  void acceleration(const std::array<T, 1>& q, std::array<T, 1>& a) const { a = {-q[0]}; }
};

template <class T>
using Any = ode::AnySystem<2, T>;

const char* const in_float_too[] = {"explicit Euler",   "symplectic Euler",  "velocity Verlet",
                                    "Runge-Kutta 4",    "modified midpoint", "McLachlan 4",
                                    "Adams-Bashforth 4"};

Quantity pendulum_motion(const Horizon& horizon) {
  const Exercise& exercise = std::ranges::find(registry(), exercise_number("3.5"), &Entry::number)->exercise;
  return motion(*exercise.scene, Parameters(exercise.parameters), horizon,
                Reference(std::string(ODDITY_SOURCE) + "/reference"));
}

}  // namespace

TEST_CASE("in float an algorithm does what it does in double, to a rounding a step", "[in_float]") {
  const ode::Adapted<Any<double>, Swing<double>> in_double{Swing<double>{}};
  const ode::Adapted<Any<float>, Swing<float>> in_float{Swing<float>{}};
  const std::vector<double> times{0, 1, 2, 3, 4};
  for (const char* name : in_float_too) {
    INFO(name);
    REQUIRE(ode::in_float<2>(name));
    const auto exact = ode::precompiled<2>(name)(in_double, {1, 0}, times, 0.01, {});
    const auto single = (*ode::in_float<2>(name))(in_float, {1, 0}, times, 0.01);
    CHECK(single.reached());
    CHECK(single.evaluations == exact.evaluations);
    double apart = 0;
    for (std::size_t k = 0; k < times.size(); ++k)
      for (std::size_t i = 0; i < 2; ++i)
        apart = std::max(apart, std::abs(single.value[k][i] - exact.value[k][i]));
    CHECK(apart > 0x1p-26);
    CHECK(apart < 400 * 8 * 0x1p-24);
  }
}

TEST_CASE("what is in double only has no counterpart in float", "[in_float]") {
  for (const char* name : {"Fehlberg 7(8)", "Bulirsch-Stoer", "GSL msbdf", "linearly implicit Euler"})
    CHECK_FALSE(ode::in_float<2>(name));
}

TEST_CASE("the time of a motion in float is counted in double, and does not drift", "[in_float]") {
  const Clock clock;
  const ode::Adapted<Any<float>, const Clock&> any(clock);
  const std::vector<double> times{0, 100};
  (*ode::in_float<2>("explicit Euler"))(any, {0, 0}, times, 0.01);
  REQUIRE(clock.asked.size() == 10'000);
  for (std::size_t i = 0; i < clock.asked.size(); i += 999)
    CHECK(clock.asked[i] == static_cast<float>(100.0 / 10'000 * static_cast<double>(i)));
}

TEST_CASE("a scene's parameters are rounded one by one", "[in_float]") {
  const pendulum::Given<double> given{0.1, 1, 9.81};
  const auto single = rounded_to<float>(given);
  CHECK(single.a == 0.1F);
  CHECK(single.L == 1);
  CHECK(single.g == 9.81F);
  CHECK(rounded_to<double>(single).a == static_cast<double>(0.1F));
}

TEST_CASE("each method in float stands beside one in double, and is judged by it", "[in_float]") {
  const Quantity swing = pendulum_motion({10});
  REQUIRE(swing.methods_in_float.size() > 10);
  for (const Method& m : swing.methods_in_float) {
    INFO(m.model << ", " << m.algorithm);
    CHECK(m.precision == Precision::in_float);
    CHECK_FALSE(m.unstable_steps);
    CHECK_FALSE(m.disturbances);
    REQUIRE(m.algorithm.ends_with(" in float"));
    const Method* like = method_of(swing, m.model, m.algorithm.substr(0, m.algorithm.size() - 9));
    REQUIRE(like);
    CHECK(like->knob.settings == m.knob.settings);
  }
}

TEST_CASE("an error beyond what roundings allow is seen", "[in_float]") {
  const Quantity swing = pendulum_motion({10});
  const Method& single = *method_of(swing, "one angle", "Runge-Kutta 4 in float");
  const double step = single.knob.settings[4];
  const TimedTrial in_double = as_result(run(swing, *method_of(swing, "one angle", "Runge-Kutta 4"), step));
  TimedTrial in_float = as_result(run(swing, single, step));
  in_float.roundings = single.roundings(step);
  CHECK(in_float.precision == Precision::in_float);
  CHECK(in_float.error > in_double.error);
  CHECK(as_accurate_as_roundings_allow(in_float, in_double));
  in_float.error = 2 * in_double.error + 1.01 * in_float.roundings;
  CHECK_FALSE(as_accurate_as_roundings_allow(in_float, in_double));
  in_float.error = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(as_accurate_as_roundings_allow(in_float, in_double));
  CHECK(single.roundings(step / 2) > 1.5 * single.roundings(step));
  CHECK(in_float.roundings < 0.02);
}

TEST_CASE("a name under which a scene has nothing is refused", "[in_float]") {
  Quantity swing = pendulum_motion({10});
  const pendulum::Given<double> given{0.5, 1, 9.81};
  CHECK_THROWS_AS(with_float(swing, {10}, given, {"small angel", "", "", "", ""}), std::logic_error);
  CHECK_THROWS_AS(with_float(swing, {10}, given, {"small angle"}), std::logic_error);
}
