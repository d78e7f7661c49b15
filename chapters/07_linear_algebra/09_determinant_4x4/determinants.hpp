#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>

#include "chapters/07_linear_algebra/shared/double_double.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

/// Determinants of 4 x 4 matrices, generic in the number type.
namespace oddity::determinants {

template <class T>
using Matrix4 = std::array<std::array<T, 4>, 4>;

/// Whole numbers of 128 bits: exact for every 4 x 4 matrix with entries below 2^30.
__extension__ typedef __int128 Whole;

template <class T, class From>
Matrix4<T> cast(const Matrix4<From>& m, const auto& number) {
  Matrix4<T> all;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) all[i][j] = number(m[i][j]);
  return all;
}

/// Rows r and s, columns c and d.
template <class T>
T minor_2(const Matrix4<T>& m, std::size_t r, std::size_t s, std::size_t c, std::size_t d) {
  return m[r][c] * m[s][d] - m[r][d] * m[s][c];
}

/// Along the first row, and along the first rows of its minors.
template <class T>
T by_cofactors(const Matrix4<T>& m) {
  const auto minor_3 = [&](std::size_t c, std::size_t d, std::size_t e) {
    return m[1][c] * minor_2(m, 2, 3, d, e) - m[1][d] * minor_2(m, 2, 3, c, e) +
           m[1][e] * minor_2(m, 2, 3, c, d);
  };
  return m[0][0] * minor_3(1, 2, 3) - m[0][1] * minor_3(0, 2, 3) + m[0][2] * minor_3(0, 1, 3) -
         m[0][3] * minor_3(0, 1, 2);
}

/// Minors of the upper two rows times those of the lower two (Laplace).
template <class T>
T by_minors(const Matrix4<T>& m) {
  const auto pair = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return minor_2(m, 0, 1, a, b) * minor_2(m, 2, 3, c, d);
  };
  return pair(0, 1, 2, 3) - pair(0, 2, 1, 3) + pair(0, 3, 1, 2) + pair(1, 2, 0, 3) - pair(1, 3, 0, 2) +
         pair(2, 3, 0, 1);
}

/// Fraction-free elimination with exchange of rows (Bareiss 1968): every division leaves no remainder. For
/// whole numbers with entries below 2000.
inline Whole by_bareiss(Matrix4<Whole> m) {
  Whole previous = 1, sign = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    while (pivot < 4 && m[pivot][k] == 0) ++pivot;
    if (pivot == 4) return 0;
    if (pivot != k) std::swap(m[pivot], m[k]), sign = -sign;
    for (std::size_t i = k + 1; i < 4; ++i)
      for (std::size_t j = k + 1; j < 4; ++j) m[i][j] = (m[k][k] * m[i][j] - m[i][k] * m[k][j]) / previous;
    previous = m[k][k];
  }
  return sign * m[3][3];
}

inline double number(Whole x) { return static_cast<double>(x); }

inline Matrix4<Whole> random_matrix(Random& random, int size) {
  return cast<Whole>(Matrix4<Whole>{}, [&](Whole) { return Whole{random.below(2 * size + 1) - size}; });
}

inline Matrix4<Whole> product(const Matrix4<Whole>& a, const Matrix4<Whole>& b) {
  Matrix4<Whole> m{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) m[i][j] += a[i][k] * b[k][j];
  return m;
}

/// Triangular, of whole numbers, with ones on the diagonal.
inline Matrix4<Whole> triangular(Random& random, int size, bool upper) {
  Matrix4<Whole> m = random_matrix(random, size);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (i == j || (j > i) != upper) m[i][j] = i == j;
  return m;
}

/// An expansion in numbers of 24, 53 or 106 bits; its multiplications counted beforehand.
inline Method expansion(std::string algorithm, const Matrix4<double>& m, const auto& determinant,
                        std::string why = {}) {
  const auto numbers = cast<Counted<double>>(m, [](double x) { return x; });
  const long work = operations_of([&] { return determinant(numbers); }).all_but_additions();
  const auto single = cast<float>(m, [](double x) { return static_cast<float>(x); });
  const auto twice = cast<DoubleDouble>(m, [](double x) { return DoubleDouble(x); });
  return {"expansion",
          std::move(algorithm),
          {"significant bits", {24, 53, 106}},
          [=](double bits) {
            return Answer{bits == 24   ? double{determinant(single)}
                          : bits == 53 ? determinant(m)
                                       : static_cast<double>(determinant(twice)),
                          work};
          },
          Outcome::ok,
          std::move(why)};
}

/// Every expansion, `terms` among them, and elimination.
inline void add_methods(Quantity& q, const Matrix4<double>& m, const auto& terms, Outcome elimination,
                        const std::string& why) {
  q.add(expansion("24 terms", m, terms));
  q.add(expansion("cofactors of the first row", m, [](const auto& a) { return by_cofactors(a); }));
  q.add(expansion("2 x 2 minors", m, [](const auto& a) { return by_minors(a); }));
  Eigen::MatrixXd dense(4, 4);
  for (int i = 0; i < 16; ++i)
    dense(i / 4, i % 4) = m[static_cast<std::size_t>(i / 4)][static_cast<std::size_t>(i % 4)];
  q.add({"elimination", "LU, rows exchanged", no_knob(), [=](double) { return answer(determinant(dense)); },
         elimination, why});
}

}  // namespace oddity::determinants
