#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex07_09 {

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

std::vector<Claim> claims(const Random&);

}  // namespace oddity::ex07_09
