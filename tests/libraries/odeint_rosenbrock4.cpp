// Compiled as C++17, as uBLAS of Boost 1.74 requires.
#define BOOST_UBLAS_NDEBUG 1
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/version.hpp>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

namespace {

namespace odeint = boost::numeric::odeint;
using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;
using AsItIs = odeint::default_rosenbrock_coefficients<double>;

struct Turned : AsItIs {
  const double d4 = -AsItIs::d4;
};

/// Error for x' = x cos t, with the solution exp(sin t), at t = 2.
template <class Coefficients>
double error(int n) {
  odeint::rosenbrock4<double, Coefficients> stepper;
  const auto rhs = [](const Vector& x, Vector& dxdt, double t) { dxdt[0] = x[0] * std::cos(t); };
  const auto jacobian = [](const Vector& x, Matrix& m, double t, Vector& dfdt) {
    m(0, 0) = std::cos(t), dfdt[0] = -x[0] * std::sin(t);
  };
  Vector x(1);
  x[0] = 1;
  for (int i = 0; i < n; ++i) stepper.do_step(std::make_pair(rhs, jacobian), x, i * 2.0 / n, 2.0 / n);
  return std::abs(x[0] - std::exp(std::sin(2.0)));
}

}  // namespace

TEST_CASE("a coefficient of Odeint's Rosenbrock 4 has the wrong sign", "[libraries]") {
  const Shown shown{"odeint_rosenbrock4", BOOST_LIB_VERSION};
  const double as_it_is = std::log2(error<AsItIs>(80) / error<AsItIs>(160));
  const double turned = std::log2(error<Turned>(80) / error<Turned>(160));
  shown.check("its order is 1", std::abs(as_it_is - 1) < 0.1, as_it_is);
  shown.check("4 with the sign turned", std::abs(turned - 4) < 0.3, turned);
}
