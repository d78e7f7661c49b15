#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex07_09 {

template <class T>
using Matrix4 = std::array<std::array<T, 4>, 4>;

/// 128-bit integers: exact for every 4 x 4 matrix with entries below 2^30.
__extension__ typedef __int128 Whole;

template <class T, class From>
Matrix4<T> cast(const Matrix4<From>& m, const auto& number) {
  Matrix4<T> all;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) all[i][j] = number(m[i][j]);
  return all;
}

inline Matrix4<Whole> random_matrix(Random& random, int size) {
  return cast<Whole>(Matrix4<Whole>{}, [&](Whole) { return Whole{random.below(2 * size + 1) - size}; });
}

/// A term as printed: its sign and the places (row, column) of its entries, from zero.
struct Term {
  bool negative;
  std::array<std::size_t, 4> rows, columns;
};

/// The printed table.
std::vector<Term> printed_terms();

template <class T>
T term_of(const Term& t, const Matrix4<T>& m) {
  return m[t.rows[0]][t.columns[0]] * m[t.rows[1]][t.columns[1]] * m[t.rows[2]][t.columns[2]] *
         m[t.rows[3]][t.columns[3]];
}

/// The minor of rows r and s and columns c and d.
template <class T>
T minor_2(const Matrix4<T>& m, std::size_t r, std::size_t s, std::size_t c, std::size_t d) {
  return m[r][c] * m[s][d] - m[r][d] * m[s][c];
}

/// Expands along the first row, and along the first rows of its minors.
template <class T>
T by_cofactors(const Matrix4<T>& m) {
  const auto minor_3 = [&](std::size_t c, std::size_t d, std::size_t e) {
    return m[1][c] * minor_2(m, 2, 3, d, e) - m[1][d] * minor_2(m, 2, 3, c, e) +
           m[1][e] * minor_2(m, 2, 3, c, d);
  };
  return m[0][0] * minor_3(1, 2, 3) - m[0][1] * minor_3(0, 2, 3) + m[0][2] * minor_3(0, 1, 3) -
         m[0][3] * minor_3(0, 1, 2);
}

std::vector<Claim> claims(const Random&);
Provables proofs();

}  // namespace oddity::ex07_09
