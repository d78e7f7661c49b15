#include "report/study/fit.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/ode/implicit_euler.hpp"
#include "solvers/ode/rosenbrock_4.hpp"
#include "solvers/ode/stability.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

/// x' = -k (x - cos t), a stiff relaxation to a slow motion; starts on the slow motion.
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

/// y' = z y in its real and imaginary parts.
struct Spiral {
  double re, im;
  template <class X, class T>
  void operator()(const X& y, X& dydt, const T&) const {
    dydt = {re * y[0] - im * y[1], im * y[0] + re * y[1]};
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

TEST_CASE("Rosenbrock 4's work grows as the fourth root of its accuracy, as for a method of order 4",
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

namespace {

/// theta'' = -sin(theta) between its unstable equilibria, together with an equation with explicit time: theta
/// = 2 asin(tanh t), y = exp(sin t).
struct Both {
  using State = std::array<double, 3>;
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T& t) const {
    using std::cos, std::sin;
    dxdt[0] = x[1];
    dxdt[1] = -sin(x[0]);
    dxdt[2] = x[2] * cos(t);
  }
  static State exact(double t) {
    return {2 * std::asin(std::tanh(t)), 2 / std::cosh(t), std::exp(std::sin(t))};
  }
};

/// The errors of the pendulum and of the equation with time, from `from` to `to`.
template <class Algorithm>
std::array<double, 2> errors(double from, double to, double setting) {
  const auto solved = ode::integrate<Algorithm>(Both(), Both::exact(from), from, to, setting);
  REQUIRE(solved.reached());
  return {std::abs(solved.value[0] - Both::exact(to)[0]), std::abs(solved.value[2] - Both::exact(to)[2])};
}

double height(const std::array<double, 1>& x, double) { return x[0]; }

}  // namespace

TEST_CASE("implicit Euler has order 1 forward and backward", "[solvers]") {
  for (double direction : {1.0, -1.0}) {
    const auto coarse = errors<ode::ImplicitEuler>(-1.5 * direction, 1.5 * direction, 0x1p-9);
    const auto fine = errors<ode::ImplicitEuler>(-1.5 * direction, 1.5 * direction, 0x1p-10);
    CHECK(near(std::log2(coarse[0] / fine[0]), 1, 0.05));
    CHECK(near(std::log2(coarse[1] / fine[1]), 1, 0.05));
  }
}

TEST_CASE("Rosenbrock 4 has an error proportional to its tolerance, forward and backward", "[solvers]") {
  for (double direction : {1.0, -1.0}) {
    std::vector<double> tolerances, pendulum, driven;
    for (double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      const auto error = errors<ode::Rosenbrock4>(-1.5 * direction, 1.5 * direction, tolerance);
      tolerances.push_back(tolerance);
      pendulum.push_back(error[0]);
      driven.push_back(error[1]);
    }
    CHECK(near(power_law(tolerances, pendulum).exponent, 1, 0.15));
    CHECK(near(power_law(tolerances, driven).exponent, 1, 0.2));
  }
}

TEST_CASE("implicit Euler's step is 1/(1 + h k), for any stiffness", "[solvers]") {
  for (double k : {0.5, 10.0, 1e3, 1e9}) {
    const auto decay = [k](const auto& x, auto& dxdt, const auto&) { dxdt[0] = -k * x[0]; };
    const auto solved = ode::integrate<ode::ImplicitEuler>(decay, std::array{1.0}, 0, 1, 1);
    CHECK(near(solved.value[0], 1 / (1 + k), 3e-16));
  }
}

TEST_CASE("a fast transient is over after few steps and leaves nothing behind", "[solvers]") {
  const Relaxation stiff{1e6};
  for (double tolerance : {1e-4, 1e-6, 1e-8}) {
    const auto solved = ode::integrate<ode::Rosenbrock4>(stiff, std::array{2.0}, 0, 2, tolerance);
    CHECK(solved.reached());
    CHECK(near(solved.value[0], stiff.exact(2), tolerance));
    CHECK(solved.evaluations < 2000);
  }
}

TEST_CASE("implicit steps cost their evaluations and their Jacobians, and report all calls", "[solvers]") {
  long calls = 0;
  const auto counted = [&](const auto& x, auto& dxdt, const auto& t) {
    ++calls;
    Quadratic()(x, dxdt, t);
  };
  CHECK(ode::integrate<ode::ImplicitEuler>(counted, std::array{1.0}, 0, 1, 0.125).evaluations == 8 * 2);
  CHECK(calls == 8 * 2);
  calls = 0;
  const long reported = ode::integrate<ode::Rosenbrock4>(counted, std::array{1.0}, 0, 1, 1e-6).evaluations;
  CHECK(reported == calls);
  calls = 0;
  const long reported_by_event =
      ode::find_event<ode::Rosenbrock4>(counted, std::array{1.0}, 0, 2, 1e-6, [](const auto& x, double) {
        return x[0] - 0.5;
      }).evaluations;
  CHECK(reported_by_event == calls);
}

TEST_CASE("implicit methods find events", "[solvers]") {
  const auto crossing = []<class Algorithm>(double setting) {
    const Relaxation stiff{1e3};
    const auto event = ode::find_event<Algorithm>(stiff, std::array{stiff.exact(0)}, 0, 4, setting, height);
    REQUIRE(event.reached());
    return event.value.time - (3.14159265358979323846 / 2 + std::atan(1e-3));  // cos t + sin t / k = 0
  };
  CHECK(near(crossing.operator()<ode::ImplicitEuler>(0.01), 0, 1e-4));
  for (double tolerance : {1e-4, 1e-6, 1e-8})
    CHECK(near(crossing.operator()<ode::Rosenbrock4>(tolerance), 0, tolerance));
}

TEST_CASE("linearly implicit Euler steps over a pole, onto the solution's other branch", "[solvers]") {
  for (double step : {0.01, 0.001}) {
    const auto solved = ode::integrate<ode::ImplicitEuler>(Pole{}, std::array{1.0}, 0, 2, step);
    CHECK(solved.reached());
    CHECK(near(solved.value[0], -1, 10 * step));
  }
}

TEST_CASE("implicit methods refuse an invalid setting, and end where the problem does", "[solvers]") {
  const auto root = [](const auto& x, auto& dxdt, const auto&) {
    using std::sqrt;
    dxdt[0] = -1 - sqrt(x[0]);
  };
  for (double setting : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(ode::integrate<ode::ImplicitEuler>(Quadratic{}, std::array{1.0}, 0, 1, setting).ending ==
          Ending::raised);
    CHECK(ode::integrate<ode::Rosenbrock4>(Quadratic{}, std::array{1.0}, 0, 1, setting).ending ==
          Ending::raised);
  }
  CHECK_FALSE(ode::integrate<ode::ImplicitEuler>(root, std::array{1.0}, 0, 5, 0.01).reached());
  CHECK_FALSE(ode::integrate<ode::Rosenbrock4>(root, std::array{1.0}, 0, 5, 1e-6).reached());
}

TEST_CASE("implicit Euler grows as in linear theory, and has no largest stable step for a decaying motion",
          "[solvers]") {
  for (const Spiral& z : {Spiral{-1, 0}, {-10, 5}, {0.5, 0.25}, {0, 2}}) {
    const auto step = ode::integrate<ode::ImplicitEuler>(z, std::array{1.0, 0.0}, 0, 1, 1).value;
    CHECK(near(ode::growth(ode::ImplicitEuler::name, {z.re, z.im}), std::log(std::hypot(step[0], step[1])),
               1e-12));
  }
  CHECK(std::isinf(ode::stable_step(ode::ImplicitEuler::name, {10, {{{-1000, 0}, {-0.004, 0}}}})));
}
