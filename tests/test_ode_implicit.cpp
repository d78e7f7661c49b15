#include "solvers/ode/implicit_euler.hpp"
#include "solvers/ode/rosenbrock_4.hpp"
#include "tests/catch.hpp"

using namespace oddity;

namespace {

/// x' = -k (x - cos t), a stiff relaxation to a slow motion; starts on the slow motion's solution.
struct Relaxation {
  double k;
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T& t) const {
    using std::cos;
    dxdt[0] = -k * (x[0] - cos(t));
  }
  double exact(double t) const { return k / (1 + k * k) * (k * std::cos(t) + std::sin(t)); }
};

/// x' = -x^2: x = 1 / (1 + t).
struct Quadratic {
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    dxdt[0] = -x[0] * x[0];
  }
};

/// x' = x^2: x = 1 / (1 - t).
struct Pole {
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    dxdt[0] = x[0] * x[0];
  }
};

template <class Algorithm, class System>
double error(const System& system, double x0, double t1, double setting, double exact) {
  const auto solved = ode::integrate<Algorithm>(system, std::array{x0}, 0, t1, setting);
  INFO(solved.message);
  REQUIRE(solved.reached());
  return std::abs(solved.value[0] - exact);
}

}  // namespace

TEST_CASE("implicit Euler has order 1, with explicit time and without", "[solvers]") {
  const Relaxation slow{1};
  const double with_time = error<ode::ImplicitEuler>(slow, slow.exact(0), 2, 0.01, slow.exact(2)) /
                           error<ode::ImplicitEuler>(slow, slow.exact(0), 2, 0.005, slow.exact(2));
  const double without = error<ode::ImplicitEuler>(Quadratic{}, 1, 2, 0.01, 1.0 / 3) /
                         error<ode::ImplicitEuler>(Quadratic{}, 1, 2, 0.005, 1.0 / 3);
  INFO("ratios of halving the step: " << with_time << ", " << without);
  CHECK(std::abs(std::log2(with_time) - 1) < 0.1);
  CHECK(std::abs(std::log2(without) - 1) < 0.1);
}

TEST_CASE("Rosenbrock 4 keeps its error near the tolerance, stiff and not, with explicit time and without",
          "[solvers]") {
  for (double tolerance : {1e-5, 1e-7, 1e-9}) {
    for (double k : {1.0, 1e3, 1e6}) {
      const Relaxation system{k};
      const double missed = error<ode::Rosenbrock4>(system, system.exact(0), 2, tolerance, system.exact(2));
      INFO("k = " << k << ", tolerance " << tolerance << ", error " << missed);
      CHECK(missed < 10 * tolerance);
    }
    CHECK(error<ode::Rosenbrock4>(Quadratic{}, 1, 2, tolerance, 1.0 / 3) < 10 * tolerance);
  }
}

TEST_CASE("Rosenbrock 4 works as a method of order 4 does: its work grows as the fourth root of its accuracy",
          "[solvers]") {
  const Relaxation system{1};
  const auto work = [&](double tolerance) {
    return static_cast<double>(
        ode::integrate<ode::Rosenbrock4>(system, std::array{1.0}, 0, 20, tolerance).evaluations);
  };
  const double growth = std::log10(work(1e-10) / work(1e-6)) / 4;
  INFO("evaluations grow as tolerance^-" << growth);
  CHECK(growth > 0.2);
  CHECK(growth < 0.3);
}

TEST_CASE("implicit methods take steps far beyond the explicit limit", "[solvers]") {
  const Relaxation stiff{1e6};
  const auto solved = ode::integrate<ode::Rosenbrock4>(stiff, std::array{stiff.exact(0)}, 0, 2, 1e-6);
  REQUIRE(solved.reached());
  CHECK(solved.evaluations < 5000);
  CHECK(error<ode::ImplicitEuler>(stiff, stiff.exact(0), 2, 0.1, stiff.exact(2)) < 1e-3);
}

TEST_CASE("Rosenbrock 4 does not step over a pole", "[solvers]") {
  CHECK_FALSE(ode::integrate<ode::Rosenbrock4>(Pole{}, std::array{1.0}, 0, 2, 1e-6).reached());
}
