#pragma once

#include <arb.h>

#include <compare>
#include <concepts>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

/// Numbers known to within a radius (Arb). A result computed from balls contains the result for any numbers
/// in them.
namespace oddity::truth {

/// Two balls overlap in a comparison: with more bits they may not.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The route is not an enclosure.
struct NotEnclosed : std::logic_error {
  using std::logic_error::logic_error;
};

class Ball {
 public:
  /// Precision of the computed midpoints in bits.
  static inline thread_local slong bits = 256;

  Ball() { arb_init(x_); }
  template <std::integral Integer>
  Ball(Integer n) {
    arb_init(x_);
    arb_set_si(x_, static_cast<slong>(n));
  }
  /// The exact value of the double.
  Ball(double x) {
    arb_init(x_);
    arb_set_d(x_, x);
  }
  Ball(const Ball& b) {
    arb_init(x_);
    arb_set(x_, b.x_);
  }
  Ball(Ball&& b) noexcept {
    arb_init(x_);
    arb_swap(x_, b.x_);
  }
  Ball& operator=(const Ball& b) {
    arb_set(x_, b.x_);
    return *this;
  }
  Ball& operator=(Ball&& b) noexcept {
    arb_swap(x_, b.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  /// The integer, if it is known exactly, as from ceil().
  explicit operator int() const { return static_cast<int>(arf_get_si(arb_midref(x_), ARF_RND_NEAR)); }

  arb_ptr data() { return x_; }
  arb_srcptr data() const { return x_; }

  friend Ball operator-(const Ball& a) {
    return made([&](arb_ptr y) { arb_neg(y, a.x_); });
  }
  friend Ball operator+(const Ball& a, const Ball& b) {
    return made([&](arb_ptr y) { arb_add(y, a.x_, b.x_, bits); });
  }
  friend Ball operator-(const Ball& a, const Ball& b) {
    return made([&](arb_ptr y) { arb_sub(y, a.x_, b.x_, bits); });
  }
  friend Ball operator*(const Ball& a, const Ball& b) {
    return made([&](arb_ptr y) { arb_mul(y, a.x_, b.x_, bits); });
  }
  friend Ball operator/(const Ball& a, const Ball& b) {
    return finite([&](arb_ptr y) { arb_div(y, a.x_, b.x_, bits); }, "a divisor");
  }
  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator-=(const Ball& b) { return *this = *this - b; }
  Ball& operator*=(const Ball& b) { return *this = *this * b; }
  Ball& operator/=(const Ball& b) { return *this = *this / b; }

  friend bool operator<(const Ball& a, const Ball& b) {
    return decided(arb_lt(a.x_, b.x_), arb_ge(a.x_, b.x_));
  }
  friend bool operator>(const Ball& a, const Ball& b) { return b < a; }
  friend bool operator<=(const Ball& a, const Ball& b) { return !(b < a); }
  friend bool operator>=(const Ball& a, const Ball& b) { return !(a < b); }
  friend bool operator==(const Ball& a, const Ball& b) {
    return decided(arb_eq(a.x_, b.x_), arb_ne(a.x_, b.x_));
  }

  /// The ball that f writes to its argument.
  template <class F>
  static Ball made(const F& f) {
    Ball y;
    f(y.x_);
    return y;
  }
  /// The ball that f writes. Throws Undecided if it is not finite, as at a singularity that the operand may
  /// contain.
  template <class F>
  static Ball finite(const F& f, const char* operand) {
    Ball y = made(f);
    if (!arb_is_finite(y.x_)) throw Undecided(std::string(operand) + " may have no such value");
    return y;
  }

 private:
  static bool decided(int yes, int no) {
    if (!yes && !no) throw Undecided("two balls overlap that are to be compared");
    return yes != 0;
  }

  arb_t x_;
};

/// A double that is not less than the bound. It represents the bound's 30 bits.
double from_above(const mag_t);
/// The double nearest to its midpoint.
double middle_of(const Ball&);
/// A bound on the absolute value of its numbers.
double greatest_size(const Ball&);
/// Its midpoint, without the radius.
Ball midpoint(const Ball&);
/// All numbers within `radius` of x.
Ball within(const Ball& x, const Ball& radius);
/// The union of both, with the numbers between them.
Ball between(const Ball& a, const Ball& b);
/// The exact value of a decimal. Throws std::invalid_argument.
Ball decimal(const std::string&);

Ball abs(const Ball&);
Ball sqrt(const Ball&);
Ball exp(const Ball&);
Ball log(const Ball&);
Ball sin(const Ball&);
Ball cos(const Ball&);
Ball sinh(const Ball&);
Ball cosh(const Ball&);
Ball acos(const Ball&);
Ball asin(const Ball&);
Ball atan(const Ball&);
Ball atan2(const Ball& y, const Ball& x);
Ball pow(const Ball&, int);
Ball ldexp(const Ball&, int);
Ball ceil(const Ball&);
Ball round(const Ball&);
Ball fmin(const Ball&, const Ball&);
inline bool isfinite(const Ball& x) { return arb_is_finite(x.data()) != 0; }

static_assert(sizeof(Ball) == sizeof(arb_struct), "Arb takes an array of them for its own");

}  // namespace oddity::truth

template <>
struct std::numeric_limits<oddity::truth::Ball> {
  static constexpr bool is_specialized = true;
  static oddity::truth::Ball epsilon() {
    return oddity::truth::ldexp(oddity::truth::Ball(1), static_cast<int>(1 - oddity::truth::Ball::bits));
  }
};
