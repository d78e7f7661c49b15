#include "reference/enclosures/ball.hpp"

namespace oddity::truth {

double from_above(const mag_t bound) {
  const double x = mag_get_d(bound);
  return x == 0 && !mag_is_zero(bound) ? std::numeric_limits<double>::min() : x;
}

double middle_of(const Ball& x) { return arf_get_d(arb_midref(x.data()), ARF_RND_NEAR); }
double greatest_size(const Ball& x) {
  mag_t size;
  mag_init(size);
  arb_get_mag(size, x.data());
  const double all = from_above(size);
  mag_clear(size);
  return all;
}
Ball midpoint(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_get_mid_arb(y, x.data()); });
}
Ball within(const Ball& x, const Ball& radius) {
  Ball y = x;
  arb_add_error(y.data(), radius.data());
  return y;
}
Ball between(const Ball& a, const Ball& b) {
  return Ball::made([&](arb_ptr y) { arb_union(y, a.data(), b.data(), Ball::bits); });
}
Ball decimal(const std::string& text) {
  Ball y;
  if (arb_set_str(y.data(), text.c_str(), Ball::bits) != 0)
    throw std::invalid_argument(text + " is no decimal number");
  return y;
}

Ball abs(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_abs(y, x.data()); });
}
Ball sqrt(const Ball& x) {
  return Ball::finite([&](arb_ptr y) { arb_sqrt(y, x.data(), Ball::bits); }, "the argument of a root");
}
Ball exp(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_exp(y, x.data(), Ball::bits); });
}
Ball log(const Ball& x) {
  return Ball::finite([&](arb_ptr y) { arb_log(y, x.data(), Ball::bits); }, "the argument of a logarithm");
}
Ball sin(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_sin(y, x.data(), Ball::bits); });
}
Ball cos(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_cos(y, x.data(), Ball::bits); });
}
Ball sinh(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_sinh(y, x.data(), Ball::bits); });
}
Ball cosh(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_cosh(y, x.data(), Ball::bits); });
}
Ball acos(const Ball& x) {
  return Ball::finite([&](arb_ptr y) { arb_acos(y, x.data(), Ball::bits); }, "a cosine");
}
Ball asin(const Ball& x) {
  return Ball::finite([&](arb_ptr y) { arb_asin(y, x.data(), Ball::bits); }, "a sine");
}
Ball atan(const Ball& x) {
  return Ball::made([&](arb_ptr y) { arb_atan(y, x.data(), Ball::bits); });
}
Ball atan2(const Ball& y, const Ball& x) {
  return Ball::made([&](arb_ptr angle) { arb_atan2(angle, y.data(), x.data(), Ball::bits); });
}
Ball pow(const Ball& x, int n) {
  return Ball::finite(
      [&](arb_ptr y) {
        fmpz_t exponent;
        fmpz_init_set_si(exponent, n);
        arb_pow_fmpz(y, x.data(), exponent, Ball::bits);
        fmpz_clear(exponent);
      },
      "the base of a power");
}
Ball ldexp(const Ball& x, int n) {
  return Ball::made([&](arb_ptr y) { arb_mul_2exp_si(y, x.data(), n); });
}
Ball ceil(const Ball& x) {
  const Ball y = Ball::made([&](arb_ptr z) { arb_ceil(z, x.data(), Ball::bits); });
  if (!arb_is_exact(y.data())) throw Undecided("a ball holds a whole number that it is to be rounded to");
  return y;
}
Ball round(const Ball& x) {
  const Ball y = Ball::made([&](arb_ptr z) { arb_floor(z, (x + 0.5).data(), Ball::bits); });
  if (!arb_is_exact(y.data())) throw Undecided("a ball holds the middle of two whole numbers");
  return y;
}
Ball fmin(const Ball& a, const Ball& b) {
  return Ball::made([&](arb_ptr y) { arb_min(y, a.data(), b.data(), Ball::bits); });
}

}  // namespace oddity::truth
