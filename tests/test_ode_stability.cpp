// The limits of stability that the algorithms' docstrings give, measured: the largest h |lambda| up to which
// one step of a linear problem has no eigenvalue outside of the unit circle.

#include "solvers/ode/stability.hpp"

#include "tests/catch.hpp"
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

TEST_CASE("an oscillation stays for a thousand steps below the limit and is lost above", "[solvers]") {
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

TEST_CASE("the stable step allows a tenfold growth beyond the truth's", "[solvers]") {
  const double span = 10;
  const auto along = [&](std::complex<double> lambda, std::string_view algorithm) {
    return stable_step(algorithm, {span, {{lambda, -lambda}}});
  };
  const std::complex<double> turning(0, 1), parting(1, 0);
  for (std::string_view algorithm : {"explicit Euler", "velocity Verlet", "Runge-Kutta 4"}) {
    const double h = along(turning, algorithm);
    INFO(algorithm << ": " << h);
    CHECK(near(growth(algorithm, h * turning) / h * span, std::log(10.0), 1e-3));
  }
  CHECK(near(along(turning, "velocity Verlet"), 2, 0.15));
  CHECK(along(turning, "velocity Verlet") > 2);
  CHECK(along(turning, "Runge-Kutta 4") > 2 * std::sqrt(2.0));
  for (std::string_view algorithm : {"velocity Verlet", "explicit Euler"}) {
    INFO(algorithm << " grows no faster than what parts in truth");
    CHECK(std::isinf(along(parting, algorithm)) == (algorithm == "velocity Verlet"));
  }
  CHECK(near(along(parting, "explicit Euler"), 2, 1));
}
