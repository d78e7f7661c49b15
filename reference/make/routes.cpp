#include "reference/make/routes.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/math/special_functions/sin_pi.hpp>
#include <stdexcept>

namespace oddity::truth {

Number pi() { return acos(Number(-1)); }

Number elliptic_k(const Number& k) {
  if (!(abs(k) < 1)) throw std::domain_error("K(k) needs |k| < 1");
  Number a = 1, b = sqrt(1 - k * k);
  while (abs(a - b) > pow(Number(10), 3 - static_cast<int>(working_digits))) {
    const Number mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return pi() / (a + b);
}

Number jacobi_cd(const Number& k, const Number& u) { return boost::math::jacobi_cd(k, u); }
Number cos_pi(const Number& x) { return boost::math::cos_pi(x); }
Number sin_pi(const Number& x) { return boost::math::sin_pi(x); }

Number integral(const std::function<Number(const Number&)>& f, const Number& a, const Number& b, int digits) {
  thread_local boost::math::quadrature::tanh_sinh<Number> rule(15, pow(Number(10), -120));
  return rule.integrate(f, a, b, Number(pow(Number(10), -digits - 4)));
}

}  // namespace oddity::truth
