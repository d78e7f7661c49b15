#pragma once

#include "extras/lanes/series.hpp"

/// Elementary functions of registers, for lanes. A register of one number takes the same operations in the
/// same order as a wide one, none of them fused. So a number has the same bits on every instruction set. Each
/// function is within three units in the last place in double and in float (test_lanes_functions.cpp).
/// Exceptions: hypot is the root of the sum of squares, with its range; asinh fails where x^2 overflows, sinh
/// and cosh where e^|x| does.
namespace oddity::lanes {

template <class V>
[[gnu::always_inline]] inline V polynomial(const V& x, const auto& coefficients) {
  V sum = all<V>(coefficients.back());
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

template <class V>
[[gnu::always_inline]] inline V abs(const V& x) {
  return from_bits<V>(bits(x) & Series<Number<V>>::size_bits);
}
template <class V>
[[gnu::always_inline]] inline V copysign(const V& size, const V& sign) {
  constexpr auto kept = Series<Number<V>>::size_bits;
  return from_bits<V>((bits(size) & kept) | (bits(sign) & ~kept));
}
/// The nearest whole number, if x is below a quarter of `shift`.
template <class V>
[[gnu::always_inline]] inline V rounded(const V& x) {
  constexpr auto shift = Series<Number<V>>::shift;
  return (x + shift) - shift;
}

/// The larger of two non-negative numbers, compared by their bits, of which those of NaN are the largest.
template <class V>
[[gnu::always_inline]] inline V larger_size(const V& x, const V& y) {
  return bits(x) > bits(y) ? x : y;
}

template <class V>
[[gnu::always_inline]] inline V hypot(const V& x, const V& y) {
  return sqrt(x * x + y * y);
}

// ---- sine and cosine --------------------------------------------------------------------------------------

/// y, or the C library's value where x is beyond `limit`. Declared const, as it touches no memory: otherwise
/// a model's stored values would be read and computed again after every sine.
template <class V>
[[gnu::noinline, gnu::cold, gnu::const]] V corrected_beyond(V y, V x, Number<V> limit,
                                                            Number<V> (*by_library)(Number<V>)) {
  using Numbers = std::array<Number<V>, count<V>>;
  auto out = std::bit_cast<Numbers>(y);
  const auto in = std::bit_cast<Numbers>(x);
  for (std::size_t i = 0; i < count<V>; ++i)
    if (std::abs(in[i]) > limit) out[i] = by_library(in[i]);
  return std::bit_cast<V>(out);
}

/// The sine of x plus `quarters` right angles. The nearest n right angles are subtracted from x in three
/// parts [W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980]. n times each of the
/// first two is exact up to the limit.
template <class V>
[[gnu::always_inline]] inline V sine_from(const V& x, Number<V> quarters) {
  using S = Series<Number<V>>;
  const V n = rounded(V(x * S::quarters_per_radian));
  const V r = x - n * S::quarter[0] - n * S::quarter[1] - n * S::quarter[2], z = r * r;
  const auto quadrant = bits(V(n + quarters + S::shift));
  const V sine = r + r * z * polynomial(z, S::sine);
  const V cosine = 1 - z / 2 + z * z * polynomial(z, S::cosine);
  const V size = (quadrant & 1) != 0 ? cosine : sine;
  return from_bits<V>(bits(size) ^ ((quadrant & 2) << (S::width - 2)));
}

template <class V>
[[gnu::always_inline]] inline V sin(const V& x) {
  using T = Number<V>;
  constexpr T limit = Series<T>::angle_limit;
  V y = sine_from(x, T(0));
  if (ones(abs(x) > limit)) [[unlikely]]
    y = corrected_beyond<V>(
        y, x, limit, +[](T one) { return std::sin(one); });
  return y;
}
template <class V>
[[gnu::always_inline]] inline V cos(const V& x) {
  using T = Number<V>;
  constexpr T limit = Series<T>::angle_limit;
  V y = sine_from(x, T(1));
  if (ones(abs(x) > limit)) [[unlikely]]
    y = corrected_beyond<V>(
        y, x, limit, +[](T one) { return std::cos(one); });
  return y;
}

// ---- exponentials -----------------------------------------------------------------------------------------

/// 2^n for a whole n between the exponents of normal numbers.
template <class V>
[[gnu::always_inline]] inline V power_of_two(const V& n) {
  using S = Series<Number<V>>;
  return from_bits<V>((bits(V(n + S::shift)) << S::digits) + bits(all<V>(1)));
}
/// x = n ln 2 + r; `rest` is exp(r) - 1.
template <class V>
struct Split {
  V n, rest;
};
template <class V>
[[gnu::always_inline]] inline Split<V> split(const V& x) {
  using S = Series<Number<V>>;
  const V n = rounded(V(x * S::octaves_per_one)), r = x - n * S::octave[0] - n * S::octave[1];
  return {n, r + r * r * polynomial(r, S::exponential)};
}
/// Keeps NaN.
template <class V>
[[gnu::always_inline]] inline V clamped(const V& x, Number<V> least, Number<V> most) {
  const V low = x < least ? all<V>(least) : x;
  return low > most ? all<V>(most) : low;
}

template <class V>
[[gnu::always_inline]] inline V exp(const V& x) {
  using S = Series<Number<V>>;
  const auto [n, rest] = split(clamped(x, S::least_exponent, S::most_exponent));
  const V half = rounded(V(n / 2));  // 2^n itself may overflow or underflow
  return (1 + rest) * power_of_two(half) * power_of_two(V(n - half));
}
template <class V>
[[gnu::always_inline]] inline V expm1(const V& x) {
  using S = Series<Number<V>>;
  const auto [n, rest] = split(clamped(x, -S::digits, S::most_exponent));
  const V half = power_of_two(V(n - 1));
  const V y = (half * rest + (half - Number<V>(0.5))) * 2;
  return n == 0 ? rest : y;
}
template <class V>
[[gnu::always_inline]] inline V sinh(const V& x) {
  const V e = expm1(abs(x));
  return copysign(e > 1 / unit<V> ? e / 2 : (e + e / (e + 1)) / 2, x);
}
template <class V>
[[gnu::always_inline]] inline V cosh(const V& x) {
  const V e = exp(abs(x));
  return (e + 1 / e) / 2;
}

// ---- logarithms -------------------------------------------------------------------------------------------

/// x = 2^n m with m between the roots of 1/2 and 2; log m = 2 artanh((m - 1)/(m + 1)).
template <class V>
[[gnu::always_inline]] inline V log(const V& x) {
  using T = Number<V>;
  using S = Series<T>;
  constexpr T least = std::numeric_limits<T>::min(), infinity = std::numeric_limits<T>::infinity();
  constexpr T lift = T(std::uint64_t(1) << S::digits);
  const V normal = x < least ? x * lift : x;
  const auto root = bits(all<V>(S::root_half)), one = bits(all<V>(1));
  const auto up = bits(normal) - root + one;  // has the exponent n
  const auto fraction = (up & ((Whole<T>(1) << S::digits) - 1)) + root;
  const auto exponent = (up >> S::digits) - (one >> S::digits);
  const V n =
      from_bits<V>(exponent + bits(all<V>(S::shift))) - S::shift + (x < least ? all<V>(-S::digits) : V{});
  const V m = from_bits<V>(fraction), s = (m - 1) / (m + 1), z = s * s;
  const V y = n * S::octave[0] + (2 * s + (s * z * polynomial(z, S::logarithm) + n * S::octave[1]));
  const V beyond = x == 0 ? all<V>(-infinity) : (x > 0 ? x : all<V>(std::numeric_limits<T>::quiet_NaN()));
  const auto ordinary = (x > 0) & (x < infinity);
  return ordinary ? y : beyond;
}
template <class V>
[[gnu::always_inline]] inline V log1p(const V& x) {
  const V up = 1 + x;
  return log(up) + (x - (up - 1)) / up;
}
template <class V>
[[gnu::always_inline]] inline V asinh(const V& x) {
  const V size = abs(x), square = size * size;
  return copysign(log1p(V(size + square / (1 + sqrt(V(1 + square))))), x);
}

// ---- angles -----------------------------------------------------------------------------------------------

template <class V>
[[gnu::always_inline]] inline V atan2(const V& y, const V& x) {
  using T = Number<V>;
  using S = Series<T>;
  const V ax = abs(x), ay = abs(y);
  const auto steep = ay > ax;
  const V less = steep ? ax : ay, more = steep ? ay : ax;
  const auto near_diagonal = less > S::tangent_of_eighth * more;
  const V over = near_diagonal ? less - more : less, under = near_diagonal ? less + more : more;
  const V t = under == 0 ? V{} : over / under, z = t * t;
  V angle = t + t * z * polynomial(z, S::arctangent);
  angle = near_diagonal ? S::half_quarter[0] + (angle + S::half_quarter[1]) : angle;
  angle = steep ? 2 * S::half_quarter[0] - (angle - 2 * S::half_quarter[1]) : angle;
  angle = bits(x) < 0 ? 4 * S::half_quarter[0] - (angle - 4 * S::half_quarter[1]) : angle;
  return copysign(angle, y);
}
template <class V>
[[gnu::always_inline]] inline V asin(const V& x) {
  return atan2(x, sqrt(V((1 - x) * (1 + x))));
}

/// x^(-1/5) within 1/50 for x from 1e-4 to 1e4: one step of Newton's method, from a logarithm that is linear
/// between the powers of two.
template <class V>
[[gnu::always_inline]] inline V inverse_fifth_root(const V& x) {
  using T = Number<V>;
  using S = Series<T>;
  constexpr int dropped = S::digits - 14;  // bits of the fraction, so that the rest is below `shift`
  constexpr T scale = T(std::int64_t(1) << (S::digits - dropped));
  const V exponent = from_bits<V>((bits(x) >> dropped) + bits(all<V>(S::shift))) - S::shift;
  const V wanted = T(1.2) * S::bias * scale - exponent * T(0.2);
  const V y = from_bits<V>((bits(V(wanted + S::shift)) - bits(all<V>(S::shift))) << dropped);
  const V square = y * y;
  return y * (T(1.2) - T(0.2) * x * square * square * y);
}

/// x minus the nearest whole multiple n of y, exactly: the product by Dekker's splitting. n is below 2^26, or
/// 2^12 for floats.
template <class V>
[[gnu::always_inline]] inline V remainder(const V& x, const V& y) {
  constexpr Number<V> splitter = (std::uint64_t(1) << (Series<Number<V>>::digits / 2 + 1)) + 1;
  const V n = rounded(V(x / y)), wide = y * splitter, high = wide - (wide - y), low = y - high;
  const V r = (x - n * high) - n * low, half = abs(y) / 2;
  const V lower = r > half ? r - abs(y) : r;
  return lower < -half ? lower + abs(y) : lower;
}

}  // namespace oddity::lanes
