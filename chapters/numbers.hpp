#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <numbers>

/// Functions that models are written with. A model is generic in its number type: float, double, dual
/// numbers, intervals, SIMD lanes, the record of a Taylor series. Each type offers those functions below that
/// make sense for it, found by argument-dependent lookup. It can be combined with whole numbers and with its
/// parameters' type.
namespace oddity {

using std::abs, std::sqrt, std::hypot, std::exp, std::expm1, std::log, std::sin, std::cos, std::tan,
    std::asin, std::acos, std::atan2, std::sinh, std::cosh, std::asinh, std::copysign, std::remainder,
    std::pow;

/// Largest relative rounding error of a number; that of double for number types made of doubles.
template <class T>
constexpr double unit_roundoff = 0x1p-53;
template <>
inline constexpr double unit_roundoff<float> = 0x1p-24;

/// `yes` if the condition holds, otherwise `no`. Both are computed. Number types whose comparisons are not
/// bool overload it.
template <class T>
T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
/// Component by component, for conditions that are not bool.
template <class Condition, class T, std::size_t n>
requires(!std::same_as<Condition, bool>) std::array<T, n> select(const Condition& condition,
                                                                 const std::array<T, n>& yes,
                                                                 std::array<T, n> no) {
  for (std::size_t i = 0; i < n; ++i) no[i] = select(condition, yes[i], no[i]);
  return no;
}
/// yes() if the condition holds, otherwise no(). If the condition is a bool, only that one is called.
template <class Condition, class Yes, class No>
auto either(const Condition& condition, const Yes& yes, const No& no) {
  if constexpr (std::same_as<Condition, bool>)
    return condition ? yes() : no();
  else
    return select(condition, yes(), no());
}
/// A loop's condition, true while it holds for any of several numbers.
inline bool any_of(bool condition) { return condition; }

/// The sum of term(row) over a table's rows, component by component. A row's numbers have the type of `any`.
/// Number types that record loops overload it.
template <class T, std::size_t columns, std::size_t rows, class Term>
auto sum_over(const T& any, const std::array<std::array<double, columns>, rows>& table, const Term& term) {
  std::array<T, columns> row;
  row.fill(any);
  const auto term_of = [&](std::size_t i) {
    for (std::size_t k = 0; k < columns; ++k) row[k] = T(table[i][k]);
    return term(row);
  };
  auto sum = term_of(0);
  for (std::size_t i = 1; i < rows; ++i) {
    const auto more = term_of(i);
    std::transform(sum.begin(), sum.end(), more.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

/// f(arguments), an array that depends on arguments and parameters alone. A printed program calls a function
/// with this head: "friction(u, v, w)". Number types that record functions overload it.
template <class T, std::size_t n, class F>
auto as_function(const char* /*head*/, const std::array<T, n>& arguments, const F& f) {
  return f(arguments);
}

template <class A, class B>
auto dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class A, class B>
auto cross(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  using T = decltype(a[0] * b[0]);
  return std::array<T, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A conserved quantity, and its moving part: the part that is exchanged with the rest, such as the kinetic
/// energy. It does not depend on the zero of a potential.
template <class T>
struct Conserved {
  T value, moving;
};

/// The energy; its moving part is the kinetic energy.
template <class T>
std::array<Conserved<T>, 1> energy_of(const T& kinetic, const T& potential) {
  return {{{kinetic + potential, kinetic}}};
}

/// Result of an event: the motion continues from `after`, ends there, or passes unchanged. To switch to
/// another law of motion, set a component of the state that nothing else changes.
template <class State>
struct Happening {
  State after;
  bool ends = false, passes = false;
};

/// Complete elliptic integral of the first kind for the modulus with this complement. It is pi/2 over the
/// arithmetic-geometric mean of 1 and sqrt(1 - k^2) [DLMF 19.8.5]. Eight means suffice in double for
/// complements of 1e-16 or more.
template <class T>
T elliptic_K_of_complement(const T& complement) {
  T a(1), b = complement;
  for (int i = 0; i < 8; ++i) {
    const T mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return T(std::numbers::pi) / (2 * a);
}

}  // namespace oddity
