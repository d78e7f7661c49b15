// Compiled as C++17, as uBLAS of Boost 1.74 requires.
#define BOOST_UBLAS_NDEBUG 1
#include <boost/numeric/odeint/stepper/implicit_euler.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

namespace {

constexpr double g = 9.81, start = 0.5, h = 0.3, enough = 1e-12;

/// Newton's iteration for y = x + h f(y), with f of the pendulum of 1 m and the matrix at the start.
int evaluations_of_newtons_iteration() {
  double angle = start, speed = 0, change = 1;
  int count = 0;
  const double pull = h * g * std::cos(start), determinant = 1 + h * pull;
  while (change > enough) {
    ++count;
    const double angle_off = angle - start - h * speed, speed_off = speed + h * g * std::sin(angle);
    const double by = (angle_off + h * speed_off) / determinant;
    const double speed_by = (speed_off - pull * angle_off) / determinant;
    angle -= by, speed -= speed_by, change = std::hypot(by, speed_by);
  }
  return count;
}

}  // namespace

TEST_CASE("Odeint's implicit Euler factorizes a factorized matrix", "[libraries]") {
  using Vector = boost::numeric::ublas::vector<double>;
  using Matrix = boost::numeric::ublas::matrix<double>;
  const Shown shown{"odeint_implicit_euler", BOOST_LIB_VERSION};
  int calls = 0;
  const auto pendulum = [&](const Vector& x, Vector& dxdt, double) {
    ++calls;
    dxdt[0] = x[1], dxdt[1] = -g * std::sin(x[0]);
  };
  const auto jacobian = [](const Vector& x, Matrix& m, double) {
    m(0, 0) = m(1, 1) = 0, m(0, 1) = 1, m(1, 0) = -g * std::cos(x[0]);
  };
  Vector x(2);
  x[0] = start, x[1] = 0;
  boost::numeric::odeint::implicit_euler<double>(enough).do_step(std::make_pair(pendulum, jacobian), x, 0.0,
                                                                 h);
  const int newton = evaluations_of_newtons_iteration();
  shown.check("takes 30 evaluations to 1e-12", calls == 30, calls);
  shown.check("the matrix as it was takes 10", newton == 10, newton);
}
