#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace oddity {

/// A number with the same bits on every machine and by every compiler. It uses only operations that IEEE 754
/// rounds correctly, each rounded separately, and the functions below. Sums and products must not be fused:
/// no pragma of g++ forbids that everywhere, so each product goes through a register.
template <class T>
class Lockstep {
 public:
  Lockstep() = default;
  template <class A>
  requires(std::integral<A> || std::same_as<A, T>) constexpr Lockstep(A x) : x_(static_cast<T>(x)) {}
  template <std::floating_point A>
  requires(!std::same_as<A, T>) constexpr explicit Lockstep(A x) : x_(static_cast<T>(x)) {}
  template <class U>
  requires(!std::same_as<U, T>) constexpr explicit Lockstep(const Lockstep<U>& x)
      : x_(static_cast<T>(x.value())) {}

  constexpr T value() const { return x_; }

  friend constexpr Lockstep operator+(const Lockstep& a, const Lockstep& b) { return a.x_ + b.x_; }
  friend constexpr Lockstep operator-(const Lockstep& a, const Lockstep& b) { return a.x_ - b.x_; }
  friend Lockstep operator*(const Lockstep& a, const Lockstep& b) { return apart(a.x_ * b.x_); }
  friend constexpr Lockstep operator/(const Lockstep& a, const Lockstep& b) { return a.x_ / b.x_; }
  friend constexpr Lockstep operator-(const Lockstep& a) { return -a.x_; }
  friend constexpr Lockstep operator+(const Lockstep& a) { return a; }
  constexpr Lockstep& operator+=(const Lockstep& b) { return *this = *this + b; }
  constexpr Lockstep& operator-=(const Lockstep& b) { return *this = *this - b; }
  Lockstep& operator*=(const Lockstep& b) { return *this = *this * b; }
  constexpr Lockstep& operator/=(const Lockstep& b) { return *this = *this / b; }
  friend constexpr bool operator<(const Lockstep& a, const Lockstep& b) { return a.x_ < b.x_; }
  friend constexpr bool operator>(const Lockstep& a, const Lockstep& b) { return a.x_ > b.x_; }
  friend constexpr bool operator<=(const Lockstep& a, const Lockstep& b) { return a.x_ <= b.x_; }
  friend constexpr bool operator>=(const Lockstep& a, const Lockstep& b) { return a.x_ >= b.x_; }
  friend constexpr bool operator==(const Lockstep& a, const Lockstep& b) { return a.x_ == b.x_; }

 private:
  static T apart(T product) {
#if defined(__GNUC__) && !defined(__clang__)
#if defined(__SSE2_MATH__)
    asm("" : "+x"(product));
#elif defined(__aarch64__)
    asm("" : "+w"(product));
#else
    asm("" : "+m"(product));
#endif
#endif
    return product;
  }

  T x_;
};

/// The functions in double, each within four units in the last place.
namespace lockstep {

using Real = Lockstep<double>;

inline std::int64_t bits(const Real& x) { return std::bit_cast<std::int64_t>(x.value()); }
inline Real from_bits(std::int64_t x) { return std::bit_cast<double>(x); }
inline Real size_of(const Real& x) { return std::abs(x.value()); }
inline Real sqrt(const Real& x) { return std::sqrt(x.value()); }
inline Real ceil(const Real& x) { return std::ceil(x.value()); }
inline Real fmax(const Real& x, const Real& y) { return x < y ? y : x; }
inline Real with_sign(const Real& size, const Real& sign) {
  return std::copysign(size.value(), sign.value());
}

/// Added to a number, rounds it to a whole one in the last bits of the sum.
inline constexpr double shift = 0x1.8p52;
inline Real rounded(const Real& x) { return (x + shift) - shift; }

inline Real polynomial(const Real& x, const auto& coefficients) {
  Real sum = coefficients.back();
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

// clang-format off
/// Interpolations at Chebyshev nodes with errors below 2^-56.5:
/// (sin r / r - 1) / r^2 in r^2, r up to pi/4
inline constexpr std::array sine_series{
    -0x1.5555555555555p-3, 0x1.1111111111110p-7, -0x1.a01a01a0198dep-13, 0x1.71de3a5455b9ap-19, -0x1.ae64540000f84p-26,
    0x1.6121703ee57b1p-33, -0x1.ab0f25d21fd92p-41};
/// (cos r - 1 + r^2 / 2) / r^4 in r^2, r up to pi/4
inline constexpr std::array cosine_series{
    0x1.5555555555555p-5, -0x1.6c16c16c16944p-10, 0x1.a01a019f4671dp-16, -0x1.27e4fa0d3726cp-22, 0x1.1eeb5de1e2b95p-29,
    -0x1.9075bb669682cp-37};
/// (exp r - 1 - r) / r^2, r up to log 2 / 2
inline constexpr std::array exponential_series{
    0x1.0000000000000p-1, 0x1.5555555555557p-3, 0x1.5555555555556p-5, 0x1.111111110ff87p-7, 0x1.6c16c16c16212p-10,
    0x1.a01a01aca0134p-13, 0x1.a01a01a741b3cp-16, 0x1.71ddffef9e7b1p-19, 0x1.27e4da1a3bf04p-22, 0x1.af52906239de4p-26,
    0x1.1f75aba0b1e2ep-29};
/// (2 artanh s / s - 2) / s^2 in s^2, s up to (sqrt 2 - 1) / (sqrt 2 + 1)
inline constexpr std::array logarithm_series{
    0x1.5555555555558p-1, 0x1.9999999994e76p-2, 0x1.2492492e6dfddp-2, 0x1.c71c6247410e3p-3, 0x1.7462e17b4cdd0p-3,
    0x1.39f8963ccbdc2p-3, 0x1.2b9f7fb3de73fp-3};
/// (arctan t / t - 1) / t^2 in t^2, t up to tan(pi/8)
inline constexpr std::array arctangent_series{
    -0x1.5555555555555p-2, 0x1.99999999992b1p-3, -0x1.249249242e44ap-3, 0x1.c71c718053ec6p-4, -0x1.745d0a620f485p-4,
    0x1.3b125117d4164p-4, -0x1.10f97c604830ap-4, 0x1.dfd550f02f5dap-5, -0x1.a0413ef02020ep-5, 0x1.4064bd87c0666p-5,
    -0x1.37c6a16c69300p-6};
/// The bits of 2/pi.
inline constexpr std::array<std::uint32_t, 38> quarters_per_radian{
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab};
// clang-format on

// pi/2 and log 2 as sums of parts; whole multiples of all parts except the last are exact
inline constexpr std::array quarter{0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
inline constexpr std::array half_quarter{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
inline constexpr std::array octave{0x1.62e42fefa38p-1, 0x1.ef35793c76730p-45};

/// An angle as a number of right angles, modulo four, and a rest.
struct Reduced {
  std::int64_t quarters;
  Real rest;
};
/// Subtracts the nearest multiple of a right angle in three parts [W. J. Cody and W. Waite, Software Manual
/// for the Elementary Functions, 1980].
inline Reduced reduced_near(const Real& x) {
  const Real n = rounded(x * 0x1.45f306dc9c883p-1);
  return {bits(n + shift), x - n * quarter[0] - n * quarter[1] - n * quarter[2]};
}
/// Multiplies x = m 2^e by 192 bits of 2/pi, from the first that gives no multiple of four [M. H. Payne and
/// R. N. Hanek, SIGNUM Newsletter 18 (1983) 19].
inline Reduced reduced_far(const Real& x) {
  const std::int64_t all = bits(size_of(x)), exponent = (all >> 52) - 1075;
  const std::uint64_t m = (static_cast<std::uint64_t>(all) & 0xfffffffffffff) | 0x10000000000000;
  const std::uint32_t halves[]{static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(m >> 32)};
  const auto bits_from = [](std::int64_t first) {  // 32 bits; bit 0 is the first after the point
    const auto word = [](std::int64_t i) -> std::uint64_t {
      return i < 0 || i > 37 ? 0 : quarters_per_radian[static_cast<std::size_t>(i)];
    };
    const std::int64_t at = first >> 5, off = first & 31;
    return static_cast<std::uint32_t>(((word(at) << 32 | word(at + 1)) << off) >> 32);
  };
  std::array<std::uint32_t, 6> product{};  // lowest word first
  for (std::size_t i = 0; i < 2; ++i) {
    std::uint64_t carried = 0;
    for (std::size_t j = 0; i + j < 6; ++j) {
      const std::int64_t first = exponent - 2 + 32 * (5 - static_cast<std::int64_t>(j));
      carried += std::uint64_t(halves[i]) * bits_from(first) + product[i + j];
      product[i + j] = static_cast<std::uint32_t>(carried);
      carried >>= 32;
    }
  }
  const std::uint32_t top = product[5];
  std::int64_t quarters = top >> 30;
  const bool is_over_half = (top >> 29 & 1) != 0;
  product[5] &= 0x3fffffff;
  if (is_over_half) {  // a negative rest: two's complement of 190 bits
    ++quarters;
    std::uint64_t carried = 1;
    for (auto& word : product) {
      carried += static_cast<std::uint32_t>(~word);
      word = static_cast<std::uint32_t>(carried);
      carried >>= 32;
    }
    product[5] &= 0x3fffffff;
  }
  Real fraction = 0;  // in right angles; adds the smallest part first
  for (std::size_t i = 0; i < 6; ++i)
    fraction =
        fraction + Real(product[i]) * from_bits((1023 - 190 + 32 * static_cast<std::int64_t>(i)) << 52);
  const Real rest = fraction * (2 * half_quarter[0]);
  const bool is_negative = x < 0;
  return {is_negative ? -quarters : quarters, is_over_half != is_negative ? -rest : rest};
}

/// The sine of x plus a number of right angles.
inline Real sine_from(const Real& x, std::int64_t quarters) {
  const Real size = size_of(x);
  if (!(size < std::numeric_limits<double>::infinity())) return x - x;
  const auto [n, r] = size > 0x1.8p20 ? reduced_far(x) : reduced_near(x);
  const Real z = r * r;
  const std::int64_t quadrant = n + quarters;
  const Real y = (quadrant & 1) != 0 ? 1 - z / 2 + z * z * polynomial(z, cosine_series)
                                     : r + r * z * polynomial(z, sine_series);
  return (quadrant & 2) != 0 ? -y : y;
}
inline Real sin(const Real& x) { return sine_from(x, 0); }
inline Real cos(const Real& x) { return sine_from(x, 1); }
inline Real tan(const Real& x) { return sin(x) / cos(x); }

/// 2^n for a whole n between the exponents of normal numbers.
inline Real power_of_two(const Real& n) { return from_bits((bits(n + shift) << 52) + bits(1)); }
/// x = n ln 2 + r: n, and exp(r) - 1.
struct Split {
  Real n, rest;
};
inline Split split(const Real& x) {
  const Real n = rounded(x * 0x1.71547652b82fep+0), r = x - n * octave[0] - n * octave[1];
  return {n, r + r * r * polynomial(r, exponential_series)};
}
/// Keeps NaN.
inline Real clamped(const Real& x, double least, double most) {
  return x < least ? Real(least) : x > most ? Real(most) : x;
}
inline Real exp(const Real& x) {
  const auto [n, rest] = split(clamped(x, -746, 710));
  const Real half = rounded(n / 2);  // 2^n itself may not be a normal number
  return (1 + rest) * power_of_two(half) * power_of_two(n - half);
}
inline Real expm1(const Real& x) {
  const auto [n, rest] = split(clamped(x, -52, 710));
  const Real half = power_of_two(n - 1);
  return n == 0 ? rest : (half * rest + (half - 0.5)) * 2;
}
inline Real sinh(const Real& x) {
  const Real e = expm1(size_of(x));
  return with_sign(e > 0x1p53 ? e / 2 : (e + e / (e + 1)) / 2, x);
}
inline Real cosh(const Real& x) {
  const Real e = exp(size_of(x));
  return (e + 1 / e) / 2;
}

/// x = 2^n m with m between the roots of 1/2 and 2; log m = 2 artanh((m - 1)/(m + 1)).
inline Real log(const Real& x) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(x > 0) || !(x < infinity)) return x == 0 ? Real(-infinity) : x > 0 ? x : (x - x) / 0;
  const bool is_normal = x >= std::numeric_limits<double>::min();
  const std::int64_t root_half = bits(0x1.6a09e667f3bcdp-1), one = bits(1);
  const std::int64_t up = bits(is_normal ? x : x * 0x1p52) - root_half + one;  // its exponent is n
  const Real n = ((up >> 52) - (one >> 52)) - (is_normal ? 0 : 52);
  const Real m = from_bits((up & 0xfffffffffffff) + root_half), s = (m - 1) / (m + 1), z = s * s;
  return n * octave[0] + (2 * s + (s * z * polynomial(z, logarithm_series) + n * octave[1]));
}
inline Real log1p(const Real& x) {
  const Real up = 1 + x;
  return log(up) + (x - (up - 1)) / up;
}
inline Real asinh(const Real& x) {
  const Real size = size_of(x), square = size * size;
  return with_sign(log1p(size + square / (1 + sqrt(1 + square))), x);
}

inline Real atan2(const Real& y, const Real& x) {
  const Real ax = size_of(x), ay = size_of(y);
  const bool is_steep = ay > ax;
  const Real less = is_steep ? ax : ay, more = is_steep ? ay : ax;
  const bool is_near_diagonal = less > 0x1.a827999fcef32p-2 * more;
  const Real over = is_near_diagonal ? less - more : less, under = is_near_diagonal ? less + more : more;
  const Real t = under == 0 ? Real(0) : over / under, z = t * t;
  Real angle = t + t * z * polynomial(z, arctangent_series);
  if (is_near_diagonal) angle = half_quarter[0] + (angle + half_quarter[1]);
  if (is_steep) angle = 2 * half_quarter[0] - (angle - 2 * half_quarter[1]);
  if (bits(x) < 0) angle = 4 * half_quarter[0] - (angle - 4 * half_quarter[1]);
  return with_sign(angle, y);
}
inline Real asin(const Real& x) { return atan2(x, sqrt((1 - x) * (1 + x))); }
inline Real acos(const Real& x) { return atan2(sqrt((1 - x) * (1 + x)), x); }

}  // namespace lockstep

// The functions that models call. In float they round the results in double.

template <class T>
Lockstep<T> abs(const Lockstep<T>& x) {
  return std::abs(x.value());
}
template <class T>
Lockstep<T> sqrt(const Lockstep<T>& x) {
  return std::sqrt(x.value());
}
template <class T>
Lockstep<T> copysign(const Lockstep<T>& size, const Lockstep<T>& sign) {
  return std::copysign(size.value(), sign.value());
}
/// Exact by IEEE 754.
template <class T>
Lockstep<T> remainder(const Lockstep<T>& x, const Lockstep<T>& y) {
  return std::remainder(x.value(), y.value());
}
/// Overflows if a square does, unlike std::hypot.
template <class T>
Lockstep<T> hypot(const Lockstep<T>& x, const Lockstep<T>& y) {
  return sqrt(x * x + y * y);
}
template <class T>
Lockstep<T> hypot(const Lockstep<T>& x, const Lockstep<T>& y, const Lockstep<T>& z) {
  return sqrt(x * x + y * y + z * z);
}
template <class T>
Lockstep<T> sin(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::sin(lockstep::Real(x)));
}
template <class T>
Lockstep<T> cos(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::cos(lockstep::Real(x)));
}
template <class T>
Lockstep<T> tan(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::tan(lockstep::Real(x)));
}
template <class T>
Lockstep<T> exp(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::exp(lockstep::Real(x)));
}
template <class T>
Lockstep<T> expm1(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::expm1(lockstep::Real(x)));
}
template <class T>
Lockstep<T> log(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::log(lockstep::Real(x)));
}
template <class T>
Lockstep<T> sinh(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::sinh(lockstep::Real(x)));
}
template <class T>
Lockstep<T> cosh(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::cosh(lockstep::Real(x)));
}
template <class T>
Lockstep<T> asinh(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::asinh(lockstep::Real(x)));
}
template <class T>
Lockstep<T> asin(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::asin(lockstep::Real(x)));
}
template <class T>
Lockstep<T> acos(const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::acos(lockstep::Real(x)));
}
template <class T>
Lockstep<T> atan2(const Lockstep<T>& y, const Lockstep<T>& x) {
  return Lockstep<T>(lockstep::atan2(lockstep::Real(y), lockstep::Real(x)));
}

/// Whether this program rounds each operation separately and keeps subnormal numbers, which compiler options
/// may change. With a = 1 + 2^-30, rounding a^2 drops 2^-60.
inline bool is_in_lockstep() {
  volatile double given = 1 + 0x1p-30, least = std::numeric_limits<double>::min();
  const Lockstep<double> a = given, tiny = least;
  return a * a - (1 + 0x1p-29) == 0 && tiny / 2 > 0;
}

/// FNV-1a hash, in 64 bits, of the bits of numbers, lowest byte first. NaNs, whose bits depend on the
/// machine, count as ones.
class BitsHash {
 public:
  void add(const auto& numbers) {
    for (const auto& number : numbers) {
      const double x(number.value());
      std::uint64_t bits = x == x ? std::bit_cast<std::uint64_t>(x) : ~std::uint64_t(0);
      for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash_ = (hash_ ^ (bits & 255)) * 0x100000001b3;
    }
  }
  unsigned long long value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace oddity
