#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <numbers>

/// What models are written with. A model is generic in its number type: float, double, dual numbers,
/// intervals, lanes of several numbers, the record of a Taylor series. Each offers the functions below that
/// make sense for it, found by its own namespace, and takes part in arithmetic with whole numbers and with
/// its parameters' type.
namespace oddity {

using std::abs, std::sqrt, std::hypot, std::exp, std::expm1, std::log, std::sin, std::cos, std::tan,
    std::asin, std::acos, std::atan2, std::sinh, std::cosh, std::asinh, std::copysign, std::remainder,
    std::pow;

/// By how much of a number its rounding errs at most; of double, where a number type holds doubles.
template <class T>
constexpr double unit_roundoff = 0x1p-53;
template <>
inline constexpr double unit_roundoff<float> = 0x1p-24;

/// `yes` where the condition holds, else `no`. Both are computed; number types whose comparisons are not
/// plain truths have their own.
template <class T>
T select(bool condition, const T& yes, const T& no) {
  return condition ? yes : no;
}
/// Component by component, for conditions that are not plain truths.
template <class Condition, class T, std::size_t n>
requires(!std::same_as<Condition, bool>) std::array<T, n> select(const Condition& condition,
                                                                 const std::array<T, n>& yes,
                                                                 std::array<T, n> no) {
  for (std::size_t i = 0; i < n; ++i) no[i] = select(condition, yes[i], no[i]);
  return no;
}
/// yes() where the condition holds, else no(). Where the condition is a plain truth, only that one is
/// computed.
template <class Condition, class Yes, class No>
auto either(const Condition& condition, const Yes& yes, const No& no) {
  if constexpr (std::same_as<Condition, bool>)
    return condition ? yes() : no();
  else
    return select(condition, yes(), no());
}
/// A loop's condition, which goes on while it holds for any of several numbers.
inline bool any_of(bool condition) { return condition; }

template <class A, class B>
auto dot(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class A, class B>
auto cross(const std::array<A, 3>& a, const std::array<B, 3>& b) {
  using T = decltype(a[0] * b[0]);
  return std::array<T, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A conserved quantity, and what moves in it: the part that is exchanged with the rest, such as the kinetic
/// energy, which does not depend on where a potential is counted from.
template <class T>
struct Conserved {
  T value, moving;
};

/// The energy; its kinetic part moves.
template <class T>
std::array<Conserved<T>, 1> energy_of(const T& kinetic, const T& potential) {
  return {{{kinetic + potential, kinetic}}};
}

/// What happens at an event: the motion goes on from `after`; or ends there; or passes, nothing being
/// changed. Another law of motion from there on is a component of the state that nothing else changes.
template <class State>
struct Happening {
  State after;
  bool ends = false, passes = false;
};

/// The complete elliptic integral of the first kind of the modulus whose complement is given: pi/2 over the
/// arithmetic-geometric mean of 1 and sqrt(1 - k^2) [DLMF 19.8.5]. Eight means are enough for double from
/// 1e-16 on.
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
