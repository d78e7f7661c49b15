#pragma once

#include <array>
#include <functional>

#include "reference/truth.hpp"

/// Derivatives in high precision from function values alone.
namespace oddity::truth {

/// The limit of f(h) for h -> 0, with f even in h, such as a central difference. Starts from the steps 1/32,
/// 1/64, ... and extrapolates (Aitken-Neville) until two columns agree to `digits` digits.
Numbers even_limit(const std::function<Numbers(const Number& h)>& f, int digits);

// ---- vectors and matrices, row by row ---------------------------------------------------------------------

using Vector = std::array<Number, 3>;
using Matrix = std::array<Vector, 3>;

inline Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector scaled(const Number& s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Numbers numbers(const Vector& a) { return {a[0], a[1], a[2]}; }

/// The angular velocity of a rotation R(t): the skew part of R(t + h) R(t - h)^T, over 2h, in the limit.
template <class Rotation>
Numbers angular_velocity(const Rotation& R, const Number& t, int digits) {
  return even_limit(
      [&](const Number& h) -> Numbers {
        const Matrix a = R(Number(t + h)), b = R(Number(t - h));
        const auto skew = [&](std::size_t i, std::size_t j) -> Number {
          return (dot(a[i], b[j]) - dot(a[j], b[i])) / (4 * h);
        };
        return {skew(2, 1), skew(0, 2), skew(1, 0)};
      },
      digits);
}

}  // namespace oddity::truth
