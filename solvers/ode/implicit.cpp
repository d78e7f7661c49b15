// Compiled as C++17: see implicit.hpp.
#define BOOST_UBLAS_NDEBUG 1  // uBLAS's checks print to standard error
#include "solvers/ode/implicit.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/implicit_euler.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <limits>
#include <utility>

namespace oddity::ode::detail {

namespace {

namespace odeint = boost::numeric::odeint;
using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Fills the values of a failed call, which uBLAS leaves uninitialized, with NaN.
void fill_if_failed(Call call, double* values, std::size_t count) {
  if (call != Call::ok) std::fill_n(values, count, no_number);
}

struct Rhs {
  const RawProblem& problem;
  void operator()(const Vector& x, Vector& dxdt, double t) const {
    fill_if_failed(problem.rhs(problem.object, &x[0], &dxdt[0], t), &dxdt[0], problem.n);
  }
};

struct Jacobian {
  const RawProblem& problem;
  void operator()(const Vector& x, Matrix& matrix, double t) const {
    fill_if_failed(problem.jacobian(problem.object, &x[0], &matrix(0, 0), nullptr, t), &matrix(0, 0),
                   problem.n * problem.n);
  }
};

/// The problem with its time as one more unknown, t' = 1. Odeint's rosenbrock4 (Boost 1.74) has the wrong
/// sign in its coefficient d4. So it has order 1 if the right-hand side depends on time, and order 4 if it
/// does not.
struct AutonomousRhs {
  const RawProblem& problem;
  void operator()(const Vector& x, Vector& dxdt, double) const {
    fill_if_failed(problem.rhs(problem.object, &x[0], &dxdt[0], x[problem.n]), &dxdt[0], problem.n);
    dxdt[problem.n] = 1;
  }
};

struct AutonomousJacobian {
  const RawProblem& problem;
  void operator()(const Vector& x, Matrix& matrix, double, Vector& dfdt) const {
    const std::size_t n = problem.n;
    Matrix inner(n, n);
    Vector by_time(n);
    const Call call = problem.jacobian(problem.object, &x[0], &inner(0, 0), &by_time[0], x[n]);
    fill_if_failed(call, &inner(0, 0), n * n);
    fill_if_failed(call, &by_time[0], n);
    matrix.clear();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) matrix(i, j) = inner(i, j);
      matrix(i, n) = by_time[i];
    }
    dfdt.clear();
  }
};

}  // namespace

struct Rosenbrock::Stepper {
  odeint::rosenbrock4_controller<odeint::rosenbrock4<double>> controller;
  Vector x;
};

Rosenbrock::Rosenbrock(std::size_t n, double tolerance)
    : stepper_(new Stepper{{tolerance, tolerance}, Vector(n + 1)}) {}
Rosenbrock::~Rosenbrock() = default;
Rosenbrock::Rosenbrock(Rosenbrock&&) noexcept = default;

bool Rosenbrock::try_step(const RawProblem& problem, double* x, double& t, double& h) {
  Vector& state = stepper_->x;
  std::copy_n(x, problem.n, state.begin());
  state[problem.n] = t;
  const auto system = std::make_pair(AutonomousRhs{problem}, AutonomousJacobian{problem});
  const auto result = stepper_->controller.try_step(system, state, t, h);
  if (result != odeint::success) return false;
  std::copy_n(state.begin(), problem.n, x);
  return true;
}

void implicit_euler_step(const RawProblem& problem, double* x, double t, double h) {
  Vector state(problem.n);
  std::copy_n(x, problem.n, state.begin());
  odeint::implicit_euler<double> one_newton_step(std::numeric_limits<double>::infinity());
  one_newton_step.do_step(std::make_pair(Rhs{problem}, Jacobian{problem}), state, t, h);
  std::copy_n(state.begin(), problem.n, x);
}

}  // namespace oddity::ode::detail
