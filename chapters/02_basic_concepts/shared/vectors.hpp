#pragma once

#include <array>
#include <cmath>
#include <string>

#include "chapters/numbers.hpp"
#include "reference/text.hpp"

/// Vectors of three numbers; sums and multiples of any number.
namespace oddity::basic_vectors {

using Vector = std::array<double, 3>;

template <std::size_t n>
std::array<double, n> operator+(std::array<double, n> a, const std::array<double, n>& b) {
  for (std::size_t k = 0; k < n; ++k) a[k] += b[k];
  return a;
}
template <std::size_t n>
std::array<double, n> operator-(std::array<double, n> a, const std::array<double, n>& b) {
  for (std::size_t k = 0; k < n; ++k) a[k] -= b[k];
  return a;
}
template <std::size_t n>
std::array<double, n> operator*(double s, std::array<double, n> a) {
  for (double& each : a) each *= s;
  return a;
}
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

inline std::string shown(const Vector& a) {
  return "(" + format_significant(a[0], 4) + ", " + format_significant(a[1], 4) + ", " +
         format_significant(a[2], 4) + ")";
}

}  // namespace oddity::basic_vectors
