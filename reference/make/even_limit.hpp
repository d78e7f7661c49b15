#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "reference/truth.hpp"

/// Derivatives in high precision from values alone.
namespace oddity::truth {

/// The limit of f(h), h -> 0, of an f with even powers of h only, such as a central difference: from the
/// steps 1/32, 1/64, ..., extrapolated (Aitken-Neville) until two columns agree to `digits` digits.
template <class F>
Numbers even_limit(const F& f, int digits) {
  constexpr int columns = 16;
  const Number tolerance = pow(Number(10), -digits - 1);
  std::vector<Numbers> row;
  for (int k = 0; k < columns; ++k) {
    std::vector<Numbers> next{f(Number(ldexp(Number(1), -5 - k)))};
    for (int j = 1; j <= k; ++j) {
      Numbers better = next.back();
      for (std::size_t i = 0; i < better.size(); ++i)
        better[i] += (better[i] - row[static_cast<std::size_t>(j - 1)][i]) / (ldexp(Number(1), 2 * j) - 1);
      next.push_back(std::move(better));
    }
    if (k > 2) {
      Number change = 0;
      for (std::size_t i = 0; i < next.back().size(); ++i)
        change = std::max<Number>(change, abs(next.back()[i] - row.back()[i]));
      if (change <= tolerance) return next.back();
    }
    row = std::move(next);
  }
  throw std::runtime_error("the extrapolation of a difference does not settle");
}

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

/// The angular velocity of a rotation R(t): what is skew in R(t + h) R(t - h)^T, over 2h, in the limit.
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
