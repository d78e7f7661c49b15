#include "reference/make/routes.hpp"

#include "reference/make/even_limit.hpp"
#include "reference/make/extrapolation.hpp"

// Tools of the generators' routes, in balls. Tools that are not enclosures throw NotEnclosed.
namespace oddity::truth {

Number pi() {
  return Ball::made([](arb_ptr y) { arb_const_pi(y, Ball::bits); });
}

/// pi/(2 M(1, sqrt(1 - k^2))), with the arithmetic-geometric mean M [DLMF 19.8.5].
Number elliptic_k(const Number& k) {
  const Number other = sqrt(1 - k * k);
  return pi() / (2 * Ball::made([&](arb_ptr y) { arb_agm(y, Number(1).data(), other.data(), Ball::bits); }));
}

Number cos_pi(const Number& x) {
  return Ball::made([&](arb_ptr y) { arb_cos_pi(y, x.data(), Ball::bits); });
}
Number sin_pi(const Number& x) {
  return Ball::made([&](arb_ptr y) { arb_sin_pi(y, x.data(), Ball::bits); });
}

Number jacobi_cd(const Number&, const Number&) { throw NotEnclosed("jacobi_cd() is not made for balls"); }
Number integral(const std::function<Number(const Number&)>&, const Number&, const Number&, int) {
  throw NotEnclosed("the double-exponential quadrature does not bound its error");
}
Numbers even_limit(const std::function<Numbers(const Number&)>&, int) {
  throw NotEnclosed("the extrapolation of a difference does not bound its error");
}
Numbers solve_extrapolation(const std::function<Numbers(const Numbers&, const Number&)>&, Numbers, Number,
                            const Number&, int, long) {
  throw NotEnclosed("the extrapolated midpoint rule does not bound its error");
}
Numbers solve_extrapolation(const std::function<Numbers(const Numbers&, const Number&)>&, const Numbers&,
                            const Number&, const Number&, Precision) {
  throw NotEnclosed("the extrapolated midpoint rule does not bound its error");
}

}  // namespace oddity::truth
