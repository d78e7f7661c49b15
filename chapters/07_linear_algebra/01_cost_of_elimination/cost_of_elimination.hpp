#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

/// Row reduction of an augmented n x (n+1) matrix without row exchange, generic in its number type. The same
/// code solves and counts.
namespace oddity::ex07_01 {

template <class T>
using Rows = std::vector<std::vector<T>>;

template <class Number>
auto random_rows(std::size_t n, const Number& number) {
  Rows<decltype(number())> m(n);
  for (auto& row : m)
    for (std::size_t j = 0; j <= n; ++j) row.push_back(number());
  return m;
}

/// Clears a row crosswise, pivot * row - entry * pivot_row, or by ratio, row - (entry/pivot) * pivot_row.
enum class Clearing { crosswise, by_ratio };

/// When a crosswise clearing multiplies the diagonal entry of a row above its pivot.
enum class Diagonal { row_by_row, at_the_end, never };

/// Clears column k of a row, without writing the zero itself, as nothing reads it.
template <class T>
void clear(Rows<T>& m, std::size_t row, std::size_t k, Clearing clearing) {
  const T pivot = m[k][k], entry = m[row][k];
  if (clearing == Clearing::crosswise) {
    for (std::size_t j = k + 1; j < m[k].size(); ++j) m[row][j] = pivot * m[row][j] - entry * m[k][j];
  } else {
    const T ratio = entry / pivot;
    for (std::size_t j = k + 1; j < m[k].size(); ++j) m[row][j] = m[row][j] - ratio * m[k][j];
  }
}

/// Clears column k below row k.
template <class T>
void forward_step(Rows<T>& m, std::size_t k, Clearing clearing = Clearing::crosswise) {
  for (std::size_t row = k + 1; row < m.size(); ++row) clear(m, row, k, clearing);
}

/// Clears column k below and above row k.
template <class T>
void full_step(Rows<T>& m, std::size_t k, Clearing clearing = Clearing::crosswise,
               Diagonal diagonal = Diagonal::row_by_row) {
  for (std::size_t row = 0; row < k; ++row) {
    if (clearing == Clearing::crosswise && diagonal == Diagonal::row_by_row)
      m[row][row] = m[k][k] * m[row][row];
    clear(m, row, k, clearing);
  }
  forward_step(m, k, clearing);
}

/// The solution of a diagonal system.
template <class T>
std::vector<T> divide(const Rows<T>& m) {
  std::vector<T> x;
  for (std::size_t i = 0; i < m.size(); ++i) x.push_back(m[i].back() / m[i][i]);
  return x;
}

/// The solution of an upper triangular system.
template <class T>
std::vector<T> back_substitution(const Rows<T>& m) {
  std::vector<T> x(m.size());
  for (std::size_t i = m.size(); i-- > 0;) {
    T sum = m[i].back();
    for (std::size_t j = i + 1; j < m.size(); ++j) sum = sum - m[i][j] * x[j];
    x[i] = sum / m[i][i];
  }
  return x;
}

template <class T>
std::vector<T> solve_forward(Rows<T> m, Clearing clearing) {
  for (std::size_t k = 0; k < m.size(); ++k) forward_step(m, k, clearing);
  return back_substitution(m);
}

template <class T>
std::vector<T> solve_full(Rows<T> m, Clearing clearing, Diagonal diagonal) {
  for (std::size_t k = 0; k < m.size(); ++k) full_step(m, k, clearing, diagonal);
  if (diagonal == Diagonal::at_the_end)
    for (std::size_t i = m.size() - 1; i-- > 0;) m[i][i] = m[i][i] * m[i + 1][i + 1];
  return divide(m);
}

std::vector<Claim> claims(const Random&);
Provables proofs();
std::vector<Root> roots();

/// A random system of n equations, solved by every elimination. In a `large` one the numbers of crosswise
/// clearing underflow.
Quantity solution(const std::string& name, std::size_t n, bool large, const Random&);

/// The entries of the user's system, with the right-hand side in the last column.
inline constexpr std::array<std::string_view, 12> entries_of_own{"a11", "a12", "a13", "a14", "a21", "a22",
                                                                 "a23", "a24", "a31", "a32", "a33", "a34"};

/// The solution of the user's system by every elimination. Throws BadInput unless there is exactly one.
Quantity own_solution(const Parameters&, const Reference&);

}  // namespace oddity::ex07_01
