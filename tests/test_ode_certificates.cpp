// Every algorithm's certificate: its order is measured, from both sides, on problems with and without
// explicit time, forward and backward. If it controls its step, the error must be proportional to the
// tolerance, and the cost of a stiff problem is checked. A new algorithm in solvers/ode/algorithms.hpp is
// certified without a line here.

#include "report/study/fit.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"
#include "tests/ode_algorithms.hpp"

using namespace oddity::ode;
using namespace problems;

namespace {

struct Span {
  double from, to;
};

/// The largest error over the motion: at the end it may vanish by accident.
template <class Algorithm>
double error_of_fixed_steps(const Problem& problem, Span span, int n) {
  const auto states = fixed_steps<Algorithm>(problem.system, problem.exact(span.from), span.from, span.to, n);
  double worst = 0;
  for (std::size_t i = 0; i < states.size(); ++i)
    worst = std::max(worst, distance(states[i], problem.exact(span.from + static_cast<double>(i) *
                                                                              (span.to - span.from) / n)));
  return worst;
}

/// GSL's bsimp has order 12, and a separate test.
template <class Algorithm>
constexpr bool has_fixed_order = (!has_tolerance(Algorithm::kind) ||
                                  HasPlain<Algorithm>)&&!std::is_same_v<Algorithm, Bsimp>;

/// Largest error allowed at the end, in tolerances. Multistep drivers control the error of a step, not of the
/// motion, and start with the lowest order.
template <class Algorithm>
constexpr double most_tolerances = changes_order<Algorithm> ? 1000 : 50;
template <class Algorithm>
constexpr double least_tolerances = changes_order<Algorithm>              ? 0.5
                                    : Algorithm::kind == Kind::controlled ? 0.05
                                                                          : 0.01;

/// Halves a step at which the error is small, but still far above rounding.
template <class Algorithm>
double measured_order(const Problem& problem, Span span, int times = 1) {
  constexpr int order = Algorithm::order;
  constexpr int usual = order <= 1   ? 1024
                        : order <= 4 ? 512
                        : order <= 5 ? 256
                        : order <= 6 ? 128
                        : order <= 8 ? 32
                                     : 16;
  const int n = times * (multistep<Algorithm> ? std::max(usual, 256) : usual);
  return std::log2(error_of_fixed_steps<Algorithm>(problem, span, n / 2) /
                   error_of_fixed_steps<Algorithm>(problem, span, n));
}

/// Beyond order 8 the error reaches rounding before its leading term is alone (test_tableaus.cpp has the
/// order itself).
template <class Algorithm>
Within near_its_order(double measured, double allowed) {
  constexpr int order = Algorithm::order;
  return within(measured, order - allowed, order + (order > 8 ? 1 : allowed));
}

/// The slope of log(error at the end) over log(tolerance).
template <class Algorithm>
double proportionality(const Problem& problem, Span span) {
  std::vector<double> tolerances, errors;
  for (double tolerance : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    const auto solved =
        integrate<Algorithm>(problem.system, problem.exact(span.from), span.from, span.to, tolerance);
    CHECK(solved.reached());
    const double error = distance(solved.value, problem.exact(span.to));
    CHECK(within(error / tolerance, least_tolerances<Algorithm>, most_tolerances<Algorithm>));
    tolerances.push_back(tolerance);
    errors.push_back(error);
  }
  return oddity::power_law(tolerances, errors).exponent;
}

/// Explicit, with step control, of fixed order or almost.
template <class Algorithm>
constexpr bool is_explicit = Algorithm::kind == Kind::controlled ||
                             (HasPlain<Algorithm> && !std::is_same_v<Algorithm, Bsimp>);

}  // namespace

TEST_CASE("every fixed step has its order without explicit time, forward and backward", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (has_fixed_order<Algorithm>) {
      for (Span span : {Span{0, 5}, Span{0, -5}})
        if (std::is_same_v<Algorithm, Rk8pd>)  // the next term of a linear problem's error is larger
          CHECK(within(measured_order<Algorithm>(oscillator, span), 7.9, 9.1));
        else
          CHECK(near_its_order<Algorithm>(measured_order<Algorithm>(oscillator, span), 0.15));
      for (Span span : {Span{-1.5, 1.5}, Span{1.5, -1.5}})
        CHECK(near_its_order<Algorithm>(measured_order<Algorithm>(separatrix, span), 0.25));
    }
  });
}

TEST_CASE("every fixed step has its order with explicit time, forward and backward", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (!of_positions_and_velocities<Algorithm> && has_fixed_order<Algorithm>) {
      constexpr int times = Algorithm::order <= 6 ? 2 : Algorithm::order <= 8 ? 3 : 4;
      for (Span span : {Span{0, 10}, Span{0, -10}})
        CHECK(near_its_order<Algorithm>(measured_order<Algorithm>(driven, span, times), 0.25));
    }
  });
}

TEST_CASE("semi-implicit Euler has order 1 if forces depend on velocity and time, forward and backward",
          "[solvers]") {
  for (const Problem* problem : {&damped, &pushed})
    for (double end : {5.0, -5.0})
      CHECK(near(measured_order<SemiImplicitEuler>(*problem, {0, end}), 1, 0.05));
}

TEST_CASE("if rates are functions of time every estimator sees its error, or reports that it does not",
          "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (has_tolerance(Algorithm::kind)) {
      for (const Problem* problem : {&clocked, &pushed})
        for (double end : {8.0, -2.0}) {
          const auto error = [&](double tolerance) {
            const auto solved = integrate<Algorithm>(problem->system, problem->exact(0), 0, end, tolerance);
            CHECK(solved.reached());
            return distance(solved.value, problem->exact(end));
          };
          if (Algorithm::facts.blind_to_time) {
            if (problem == &clocked) CHECK(error(1e-12) == error(1e-4));
            CHECK(error(1e-12) > 1e-9);
          } else {
            for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10})
              CHECK(error(tolerance) < most_tolerances<Algorithm> * tolerance);
          }
        }
    }
  });
}

TEST_CASE("every controlled step has an error proportional to its tolerance", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (has_tolerance(Algorithm::kind) && !std::is_same_v<Algorithm, Bsimp>) {
      const double allowed = changes_order<Algorithm> ? 0.25 : 0.15;
      for (Span span : {Span{-1.5, 1.5}, Span{1.5, -1.5}})
        CHECK(near(proportionality<Algorithm>(separatrix, span), 1, allowed));
      for (Span span : {Span{0, 8}, Span{0, -8}})
        CHECK(near(proportionality<Algorithm>(driven, span), 1, allowed));
    }
  });
}

TEST_CASE("every controlled step costs the same forward and backward", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (has_tolerance(Algorithm::kind)) {
      for (double tolerance : {1e-4, 1e-8, 1e-12}) {
        const auto forward = integrate<Algorithm>(oscillator.system, State{1, 0}, 0, 5, tolerance);
        const auto backward = integrate<Algorithm>(oscillator.system, State{1, 0}, 0, -5, tolerance);
        CHECK(forward.evaluations == backward.evaluations);
        CHECK(near(forward.value[0], backward.value[0], 1e-15));
      }
    }
  });
}

TEST_CASE("a controlled step on a stiff problem is as small as stability requires", "[solvers]") {
  // The attraction at the rate 1000 over two seconds needs 2000 / 3.3 steps of Dormand-Prince's six new
  // evaluations; a looser tolerance saves nothing.
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (is_explicit<Algorithm>) {
      for (double tolerance : {1e-2, 1e-4, 1e-6}) {
        const auto solved = integrate<Algorithm>(stiff.system, stiff.exact(0), 0, 2, tolerance);
        CHECK(solved.reached());
        CHECK(distance(solved.value, stiff.exact(2)) < 10 * tolerance);
        CHECK(within(static_cast<double>(solved.evaluations), 3000, 10'000));
      }
    }
  });
  const auto dormand_prince = integrate<DormandPrince54>(stiff.system, stiff.exact(0), 0, 2, 1e-4);
  CHECK(within(static_cast<double>(dormand_prince.evaluations), 2 * rate / 3.307 * 6,
               1.3 * 2 * rate / 3.307 * 6));
}

TEST_CASE("the methods for stiff problems take a fraction of that", "[solvers]") {
  const auto evaluations = []<class Algorithm>(double tolerance) {
    INFO(Algorithm::name);
    const auto solved = integrate<Algorithm>(stiff.system, stiff.exact(0), 0, 2, tolerance);
    CHECK(solved.reached());
    CHECK(distance(solved.value, stiff.exact(2)) < 20 * tolerance);
    return solved.evaluations;
  };
  for (double tolerance : {1e-2, 1e-4, 1e-6}) {
    CHECK(evaluations.operator()<Rosenbrock4>(tolerance) < 700);
    CHECK(evaluations.operator()<Msbdf>(tolerance) < 200);
    CHECK(evaluations.operator()<Bsimp>(tolerance) < 1500);
  }
#ifdef ODDITY_SUNDIALS
  CHECK(evaluations.operator()<CvodeBdf>(1e-6) < 100);
#endif
}

TEST_CASE("a fixed step on a stiff problem holds below its stability limit and explodes above", "[solvers]") {
  const auto error = []<class Algorithm>(double h_times_rate) {
    const auto solved = integrate<Algorithm>(stiff.system, stiff.exact(0), 0, 2, h_times_rate / rate);
    return distance(solved.value, stiff.exact(2));
  };
  CHECK(error.operator()<ExplicitEuler>(1.98) < 1e-3);
  CHECK(error.operator()<ExplicitEuler>(2.03) > 1e3);
  CHECK(error.operator()<RungeKutta4>(2.75) < 1e-3);
  CHECK(error.operator()<RungeKutta4>(2.84) > 1e3);
}

TEST_CASE("bsimp has order 12, forward and backward, for any tolerance", "[solvers]") {
  for (double direction : {1.0, -1.0}) {
    CHECK(near(std::log2(error_of_fixed_steps<Bsimp>(oscillator, {0, 5 * direction}, 2) /
                         error_of_fixed_steps<Bsimp>(oscillator, {0, 5 * direction}, 4)),
               12, 0.5));
    const auto evaluations = [&](double tolerance) {
      return integrate<Bsimp>(separatrix.system, separatrix.exact(0), 0, direction, tolerance).evaluations;
    };
    CHECK(evaluations(1e-2) == evaluations(1e-8));
  }
}

TEST_CASE("bsimp's error is below 200 tolerances, and at a loose tolerance far below", "[solvers]") {
  for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for (double end : {8.0, -8.0}) {
      const auto solved = integrate<Bsimp>(driven.system, driven.exact(0), 0, end, tolerance);
      CHECK(solved.reached());
      CHECK(distance(solved.value, driven.exact(end)) < 200 * tolerance);
    }
  CHECK(distance(integrate<Bsimp>(separatrix.system, separatrix.exact(0), 0, 1.5, 1e-4).value,
                 separatrix.exact(1.5)) < 1e-9);
}

TEST_CASE("every algorithm returns to its start", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto there = integrate<Algorithm>(separatrix.system, separatrix.exact(0), 0, 1, fine<Algorithm>);
    const auto back = integrate<Algorithm>(separatrix.system, there.value, 1, 0, fine<Algorithm>);
    CHECK(distance(back.value, separatrix.exact(0)) < 2e-3);
  });
}
