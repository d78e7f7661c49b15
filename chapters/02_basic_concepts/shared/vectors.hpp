#pragma once

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "chapters/numbers.hpp"
#include "reference/text.hpp"

/// Vectors of three numbers; sums and multiples for any number type.
namespace oddity::basic_vectors {

using Vector = std::array<double, 3>;

template <class T, std::size_t n>
std::array<T, n> operator+(std::array<T, n> a, const std::array<T, n>& b) {
  for (std::size_t k = 0; k < n; ++k) a[k] += b[k];
  return a;
}
template <class T, std::size_t n>
std::array<T, n> operator-(std::array<T, n> a, const std::array<T, n>& b) {
  for (std::size_t k = 0; k < n; ++k) a[k] -= b[k];
  return a;
}
template <class T, std::size_t n>
std::array<T, n> operator*(const std::type_identity_t<T>& s, std::array<T, n> a) {
  for (T& each : a) each = s * each;
  return a;
}
template <class T>
T length(const std::array<T, 3>& a) {
  return sqrt(dot(a, a));
}
inline double length(const Vector& a) { return length<double>(a); }

inline std::string shown(const Vector& a) {
  return "(" + format_significant(a[0], 4) + ", " + format_significant(a[1], 4) + ", " +
         format_significant(a[2], 4) + ")";
}

}  // namespace oddity::basic_vectors
