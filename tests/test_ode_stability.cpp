// The limits of stability in the algorithms' docstrings, measured: the largest h |lambda| up to which one
// step of a linear problem has no eigenvalue outside of the unit circle.

#include "solvers/ode/stability.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/verify/catch.hpp"
#include "solvers/ode/disturbed.hpp"
#include "solvers/ode/known_tongues.hpp"
#include "tests/near.hpp"
#include "tests/ode_algorithms.hpp"

using namespace oddity::ode;
using namespace problems;

namespace {

template <class Algorithm>
State one_step(const Problem& problem, State x, double h) {
  return fixed_steps<Algorithm>(problem.system, x, 0, h, 1).back();
}

/// The spectral radius of one step's matrix.
template <class Algorithm>
double radius(const Problem& problem, double h) {
  const State a = one_step<Algorithm>(problem, {1, 0}, h), b = one_step<Algorithm>(problem, {0, 1}, h);
  const double half_trace = (a[0] + b[1]) / 2, determinant = a[0] * b[1] - a[1] * b[0];
  const double discriminant = half_trace * half_trace - determinant;
  return discriminant < 0 ? std::sqrt(determinant) : std::abs(half_trace) + std::sqrt(discriminant);
}

/// The first h at which the radius leaves 1 by more than `growth`: stepped up to, then bisected.
template <class Algorithm>
double limit(const Problem& problem, double growth = 1e-12) {
  const auto stable = [&](double h) { return radius<Algorithm>(problem, h) <= 1 + growth; };
  double low = 0;
  while (low < 20 && stable(low + 0.01)) low += 0.01;
  double high = low + 0.01;
  for (int i = 0; i < 40; ++i) (stable((low + high) / 2) ? low : high) = (low + high) / 2;
  return low;
}

}  // namespace

TEST_CASE("limits of stability on the negative real axis", "[solvers]") {
  CHECK(near(limit<ExplicitEuler>(decay), 2, 1e-9));
  CHECK(near(limit<RungeKutta4>(decay), 2.785, 5e-4));
  CHECK(near(limit<CashKarp54>(decay), 3.734, 5e-4));
  CHECK(near(limit<DormandPrince54>(decay), 3.307, 5e-4));
  CHECK(near(limit<Fehlberg78>(decay), 5.008, 5e-4));
}

TEST_CASE("limits of stability on the imaginary axis", "[solvers]") {
  CHECK(near(limit<SymplecticEuler>(oscillator), 2, 1e-6));
  CHECK(near(limit<VelocityVerlet>(oscillator), 2, 1e-6));
  CHECK(near(limit<RungeKutta4>(oscillator), 2 * std::sqrt(2.0), 1e-6));
  CHECK(near(limit<DormandPrince54>(oscillator), 0.997, 5e-4));
  CHECK(near(limit<Fehlberg78>(oscillator), 2.365, 5e-4));
}

TEST_CASE("explicit Euler and Cash-Karp are nowhere stable on the imaginary axis", "[solvers]") {
  CHECK(limit<ExplicitEuler>(oscillator) < 1e-5);
  CHECK(near(radius<ExplicitEuler>(oscillator, 0.1), std::sqrt(1.01), 1e-15));
  CHECK(limit<CashKarp54>(oscillator) < 0.05);
  const double growth = radius<CashKarp54>(oscillator, 0.2) - 1,
               less = radius<CashKarp54>(oscillator, 0.1) - 1;
  CHECK(growth > 0);
  CHECK(near(std::log2(growth / less), 6, 0.1));
}

TEST_CASE("an oscillation stays bounded for a thousand steps below the limit and is lost above",
          "[solvers]") {
  const auto amplitude = []<class Algorithm>(double h) {
    double most = 0;
    for (const State& x : fixed_steps<Algorithm>(oscillator.system, {1, 0}, 0, 1000 * h, 1000))
      most = std::max(most, std::abs(x[0]));
    return most;
  };
  CHECK(amplitude.operator()<VelocityVerlet>(1.99) < 1.01);
  CHECK(amplitude.operator()<VelocityVerlet>(2.01) > 1e6);
  CHECK(amplitude.operator()<SymplecticEuler>(1.9) < 5);
  CHECK(amplitude.operator()<SymplecticEuler>(2.01) > 1e6);
  CHECK(amplitude.operator()<RungeKutta4>(2.8) <= 1);
  CHECK(amplitude.operator()<RungeKutta4>(2.86) > 1e6);
  CHECK(amplitude.operator()<ExplicitEuler>(0.1) > 100);
}

namespace {

/// The steps at which an algorithm is unstable on y' = lambda y.
std::vector<Tongue> tongues(std::string_view algorithm, std::complex<double> lambda) {
  return unstable_steps(algorithm, {10, {{lambda, std::conj(lambda)}}});
}

const std::complex<double> turning(0, 1), parting(1, 0), fading(-1, 0), ringing(-0.1, 1);

}  // namespace

TEST_CASE("known tongues are taken where a few steps confirm them", "[solvers][stability]") {
  const Spectrum spectrum{10, {{turning, std::conj(turning)}, {2.0 * turning, -2.0 * turning}}};
  const auto found = unstable_steps("Runge-Kutta 4", spectrum);
  REQUIRE(found.size() == 1);
  const auto with = [&](std::vector<Tongue> known) {
    const KnownTongues here(known);
    return unstable_steps("Runge-Kutta 4", spectrum);
  };
  const double rounded = std::round(found[0].from * 1000) / 1000;
  CHECK(with({{rounded, found[0].to}})[0].from == rounded);
  for (const double wrong : {0.97, 1.03})
    CHECK(with({{wrong * rounded, found[0].to}})[0].from == found[0].from);
  CHECK(with({})[0].from == found[0].from);
  CHECK(with({{rounded, 3}, {4, found[0].to}}).size() == 1);
}

TEST_CASE("linear theory's first loss of stability, and every tongue beyond", "[solvers]") {
  const auto first = [](std::string_view algorithm, std::complex<double> lambda) {
    return stable_step(algorithm, {10, {{lambda}}});
  };
  CHECK(first("explicit Euler", turning) == 0);
  CHECK(near(first("explicit Euler", fading), 2, 1e-9));
  CHECK(near(first("explicit Euler", ringing), 0.2 / 1.01, 1e-9));
  CHECK(near(first("velocity Verlet", turning), 2, 1e-3));
  CHECK(near(first("Runge-Kutta 4", turning), 2 * std::sqrt(2.0), 0.003));
  CHECK(near(first("Runge-Kutta 4", 50.0 * turning), 2 * std::sqrt(2.0) / 50, 0.0001));
  CHECK(near(first("modified midpoint", turning), std::pow(0.128, 0.2), 0.01));  // grows by h^6 / 128
  CHECK(near(first("Adams-Bashforth 4", turning), 0.43, 0.005));
  CHECK(near(first("Adams-Bashforth-Moulton 6", turning), 0.5267, 0.005));
  CHECK(std::isinf(first("linearly implicit Euler", turning)));
  const auto found = tongues("McLachlan 4", turning);
  REQUIRE(found.size() == 3);
  CHECK(near(found[0].from, 2.967808, 1e-3));
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double middle = i == 2 ? found[2].from + 1 : (found[i].from + found[i].to) / 2;
    CHECK(growth("McLachlan 4", middle * turning) > 0.01);
  }
  for (double h = 0.05; h < 12; h += 0.0037) {  // in even steps, unlike the scan
    const bool listed = std::ranges::any_of(found, [&](const Tongue& t) { return t.from < h && h < t.to; });
    const bool grows = growth("McLachlan 4", h * turning) > negligible_growth * h;
    INFO("h = " << h);
    CHECK((listed == grows || std::ranges::any_of(found, [&](const Tongue& t) {
             return std::abs(h - t.from) < 1e-6 || std::abs(h - t.to) < 1e-6;
           })));
  }
}

TEST_CASE("if a disturbance decays in the true motion, the limit is where it neither decays nor grows",
          "[solvers][stability]") {
  // For explicit Euler -2 Re(lambda) / |lambda|^2; for the others |R(h lambda)| = 1 itself.
  for (const std::complex<double> lambda :
       {std::complex<double>(-0.4, 2), {-1, 1}, {-0.05, 0.3}, {-3, 0.01}, {-0.02, 1}, {-7, 0}}) {
    INFO("lambda = " << lambda);
    const auto limit = [&](std::string_view algorithm) {
      return stable_step(algorithm, {10, {{lambda, std::conj(lambda)}}});
    };
    const double euler = -2 * lambda.real() / std::norm(lambda);
    CHECK(near(limit("explicit Euler"), euler, 1e-9 * euler));
    for (std::string_view algorithm : {"Runge-Kutta 4", "modified midpoint", "Adams-Bashforth 4"}) {
      INFO(algorithm);
      const double h = limit(algorithm);
      CHECK(std::abs(growth(algorithm, h * lambda)) < 1e-8);
      CHECK(growth(algorithm, 0.999 * h * lambda) < 0);
      CHECK(growth(algorithm, 1.001 * h * lambda) > 0);
    }
    const double c = -2 * lambda.real(), k = std::norm(lambda);
    CHECK(near(limit("semi-implicit Euler"), (std::sqrt(c * c + 4 * k) - c) / k, 1e-6 / std::sqrt(k)));
  }
}

namespace {

/// Two oscillations that a magnetic field couples, as in Foucault's pendulum, and damping.
struct Gyroscopic {
  void operator()(const std::array<double, 4>& x, std::array<double, 4>& dxdt, double) const {
    dxdt = {x[2], x[3], -x[0] - 0.1 * x[2] + 0.5 * x[3], -2 * x[1] - 0.1 * x[3] - 0.5 * x[2]};
  }
};

}  // namespace

TEST_CASE("semi-implicit Euler's limit is that of its step with coupled velocities", "[solvers][stability]") {
  const Adapted<AnySystem<4>, Gyroscopic> system{Gyroscopic{}};
  std::array<double, 4> zero{};
  const auto rhs = [&](const double* x, double* dxdt, double t) {
    std::array<double, 4> state, rate;
    std::copy_n(x, 4, state.begin());
    system(state, rate, t);
    std::ranges::copy(rate, dxdt);
  };
  Spectrum spectrum{10, {}, {jacobian_at(rhs, zero, 0)}, {false, false, true, true}};
  spectrum.at.push_back(eigenvalues_of(spectrum.jacobians[0]));
  const double limit = stable_step("semi-implicit Euler", spectrum);
  const auto size_after = [&](double h) {  // after 100,000 steps from a motion in both modes
    return integrate<SemiImplicitEuler>(system, std::array{1.0, 0.5, -0.3, 0.7}, 0, 100'000 * h, h).value;
  };
  const auto largest = [](const auto& x) {
    return std::abs(*std::ranges::max_element(x, {}, [](double y) { return std::abs(y); }));
  };
  CHECK(within(limit, 0.1, 0.2 / 0.26));  // larger than where the velocities alone grow: |1 + h (-0.1 + 0.5
                                          // i)| = 1
  CHECK(largest(size_after(0.99 * limit)) < 1e-3);
  CHECK(largest(size_after(1.01 * limit)) > 1e3);
}

TEST_CASE("semi-implicit Euler is symplectic Euler where forces depend only on positions", "[solvers]") {
  for (double h : {0.1, 0.7}) {
    const auto a = integrate<SemiImplicitEuler>(separatrix.system, State{0.5, 1}, 0, 7, h);
    const auto b = integrate<SymplecticEuler>(separatrix.system, State{0.5, 1}, 0, 7, h);
    CHECK(a.value == b.value);
    CHECK(a.evaluations == b.evaluations);
  }
}

namespace {

/// A rotation about an axis at a rate that is an unknown: (cos, sin, rate), with friction.
struct Turning {
  static constexpr std::array<std::size_t, 1> velocities{2};
  void operator()(const std::array<double, 3>& x, std::array<double, 3>& dxdt, double) const {
    dxdt = {-x[1] * x[2], x[0] * x[2], -0.5 * x[2]};
  }
};

/// A position whose velocity is a function of time.
struct Carried {
  static constexpr std::array<std::size_t, 0> velocities{};
  void operator()(const std::array<double, 1>&, std::array<double, 1>& dxdt, double t) const { dxdt = {t}; }
};

}  // namespace

TEST_CASE("semi-implicit Euler takes the new velocities, which a system declares or shows", "[solvers]") {
  const auto turned = integrate<SemiImplicitEuler>(Turning{}, std::array{1.0, 0.0, 2.0}, 0, 0.25, 0.25);
  CHECK(turned.value == std::array{1.0, 0.25 * 1.75, 1.75});
  CHECK(turned.evaluations == 2);
  const auto carried = integrate<SemiImplicitEuler>(Carried{}, std::array{1.0}, 0, 0.5, 0.25);
  CHECK(carried.value[0] == 1 + 0.25 * (0.25 + 0.5));
  const auto seen = velocities_of<State>(damped.system);
  CHECK(seen.is == std::array{false, true});
  CHECK(seen.are_all_rates());
  CHECK_FALSE(velocities_of<State>(decay.system).known);
}

TEST_CASE("a rate that depends only on time is detected", "[solvers]") {
  CHECK(has_rates_of_time<State>(clocked.system));
  CHECK(has_rates_of_time<State>(pushed.system));
  CHECK_FALSE(has_rates_of_time<State>(driven.system));
  CHECK_FALSE(has_rates_of_time<State>(damped.system));
}

TEST_CASE("with explicit Euler an undamped oscillation grows at the rate h omega^2 / 2", "[solvers]") {
  for (double h : {1e-1, 1e-2, 1e-3}) {
    CHECK(growth("explicit Euler", h * turning) > 0);
    CHECK(near(growth("explicit Euler", h * turning) / h, h / 2, h * h * h));
  }
}

TEST_CASE("neighbours that diverge in the true motion may diverge up to twice as fast", "[solvers]") {
  for (std::string_view algorithm : {"explicit Euler", "velocity Verlet", "Runge-Kutta 4"})
    CHECK(tongues(algorithm, parting).empty());
  const auto found = tongues("linearly implicit Euler", parting);
  REQUIRE(found.size() == 1);
  for (double h : {found[0].from, found[0].to}) CHECK(near(-std::log(std::abs(1 - h)), 2.001 * h, 1e-6));
}

namespace {

struct Oscillator {
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], -x[0]}; }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const { a[0] = -q[0]; }
};

struct Growth {
  void operator()(const std::array<double, 1>& x, std::array<double, 1>& dxdt, double) const { dxdt = x; }
};

}  // namespace

TEST_CASE("two motions that start together diverge where theory predicts", "[solvers]") {
  const Adapted<AnySystem<2>, Oscillator> oscillation{Oscillator{}};
  const Disturbed<2> disturbed(oscillation, {1, 0}, 1000);
  CHECK(disturbed.span() == 1000);
  const auto lost = [&](std::string_view algorithm, double h) {
    return disturbed.lost(algorithm, h).time(1);
  };
  for (const auto& [algorithm, limit] :
       {std::pair("velocity Verlet", 2.0), std::pair("Runge-Kutta 4", 2.8284),
        std::pair("McLachlan 4", 2.9678), std::pair("Adams-Bashforth 4", 0.43),
        std::pair("Adams-Bashforth-Moulton 6", 0.5267)}) {
    INFO(algorithm);
    CHECK(std::isinf(lost(algorithm, 0.5 * limit)));
    CHECK(std::isfinite(lost(algorithm, 1.03 * limit)));
  }
  CHECK(std::isinf(lost("McLachlan 4", 4.5)));  // between two tongues
  CHECK(std::isfinite(lost("explicit Euler", 0.02)));
  CHECK(lost("explicit Euler", 0.04) < lost("explicit Euler", 0.02));
  for (double h : {0.1, 1.0, 10.0}) CHECK(std::isinf(lost("linearly implicit Euler", h)));
}

TEST_CASE("a disturbance is followed to the very end of its span", "[solvers]") {
  const Adapted<AnySystem<2>, Oscillator> oscillation{Oscillator{}};
  for (double part : {1.0, 87.0, 129.0, 157.0, 174.0})  // 1000 / 87 * 1000 / 1000 is not 1000 / 87
    CHECK(Disturbed<2>(oscillation, {1, 0}, 1000 / part).span() == 1000 / part);
}

TEST_CASE("with a constant Jacobian a disturbance of the true motion is lost where theory predicts",
          "[solvers]") {
  const Adapted<AnySystem<2>, Oscillator> oscillation{Oscillator{}};
  const Disturbed<2> disturbed(oscillation, {1, 0}, 1000);
  for (const auto& [algorithm, limit] :
       {std::pair("velocity Verlet", 2.0), std::pair("Runge-Kutta 4", 2.8284),
        std::pair("McLachlan 4", 2.9678), std::pair("Adams-Bashforth 4", 0.43),
        std::pair("Adams-Bashforth-Moulton 6", 0.5267)}) {
    INFO(algorithm);
    CHECK(std::isinf(disturbed.lost_along_truth(algorithm, 0.97 * limit)));
    CHECK(std::isfinite(disturbed.lost_along_truth(algorithm, 1.03 * limit)));
  }
}

TEST_CASE("a growing disturbance is lost at the step at which a method exaggerates it too much",
          "[solvers]") {
  // x' = x diverges by t in the true motion; implicit Euler by a factor of 1 / (1 - h) in a step.
  const Adapted<AnySystem<1>, Growth> growth{Growth{}};
  const Disturbed<1> disturbed(growth, {1}, 18);
  const double h = 0.9, in_a_step = -std::log(1 - h);
  int steps = 1;
  while (steps * in_a_step <= Criteria{}.as_fast * steps * h + std::log(Criteria{}.granted)) ++steps;
  CHECK(near(disturbed.lost_along_truth("linearly implicit Euler", h), steps * h, 1e-12));
}

TEST_CASE("an oscillation's turns are counted", "[solvers]") {
  const Adapted<AnySystem<2>, Oscillator> oscillation{Oscillator{}};
  const Disturbed<2> disturbed(oscillation, {1, 0}, 1000);
  CHECK(near(disturbed.turns_in_a_step("Runge-Kutta 4", 0.1), 0.1 / (2 * std::numbers::pi), 1e-3));
  // Verlet turns faster: cos = 1 - h^2 / 2.
  for (double h : {0.5, 1.0, std::sqrt(2.0), 1.7})
    CHECK(near(disturbed.turns_in_a_step("velocity Verlet", h),
               std::acos(1 - h * h / 2) / (2 * std::numbers::pi), 1e-2));
}

TEST_CASE("implicit Euler makes nothing grow that does not grow in the true motion, at any step",
          "[solvers]") {
  // Justifies the recorded limit "every step" beyond the steps that are scanned.
  for (double direction = std::numbers::pi / 2; direction <= std::numbers::pi; direction += 0.01)
    for (double size = 1e-6; size < 1e9; size *= 3)
      CHECK(growth("linearly implicit Euler", std::polar(size, direction)) <= 1e-12);
}
