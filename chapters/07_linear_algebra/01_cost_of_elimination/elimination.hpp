#pragma once

#include <cstddef>
#include <vector>

#include "solvers/counted.hpp"

/// Row reduction of an augmented n x (n+1) matrix without exchange of rows, generic in its number type: the
/// same code solves and is counted.
namespace oddity::elimination {

/// What operations cost: so many multiplications, additions (and subtractions), divisions.
struct Cost {
  double mu = 0, alpha = 0, delta = 0;

  constexpr Cost() = default;
  constexpr Cost(double m, double a, double d) : mu(m), alpha(a), delta(d) {}
  Cost(const Operations& counted)
      : mu(static_cast<double>(counted.multiplications)),
        alpha(static_cast<double>(counted.additions)),
        delta(static_cast<double>(counted.divisions)) {}

  friend constexpr Cost operator+(Cost a, Cost b) {
    return {a.mu + b.mu, a.alpha + b.alpha, a.delta + b.delta};
  }
  friend constexpr Cost operator*(double x, Cost a) { return {x * a.mu, x * a.alpha, x * a.delta}; }
  friend constexpr Cost operator-(Cost a, Cost b) { return a + -1.0 * b; }
};

template <class T>
using Rows = std::vector<std::vector<T>>;

template <class Number>
auto random_rows(std::size_t n, const Number& number) {
  Rows<decltype(number())> m(n);
  for (auto& row : m)
    for (std::size_t j = 0; j <= n; ++j) row.push_back(number());
  return m;
}

/// How a row is cleared: crosswise, pivot row - entry pivot_row, or by ratio, row - (entry/pivot) pivot_row.
enum class Clearing { crosswise, by_ratio };

/// When a crosswise clearing multiplies the diagonal entry of a row above its pivot.
enum class Diagonal { row_by_row, at_the_end, never };

template <class T>
void clear(Rows<T>& m, std::size_t row, std::size_t k, Clearing clearing) {
  const T pivot = m[k][k], entry = m[row][k];
  if (clearing == Clearing::crosswise) {
    for (std::size_t j = k + 1; j < m[k].size(); ++j) m[row][j] = pivot * m[row][j] - entry * m[k][j];
  } else {
    const T ratio = entry / pivot;
    for (std::size_t j = k + 1; j < m[k].size(); ++j) m[row][j] = m[row][j] - ratio * m[k][j];
  }
  m[row][k] = T{};
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

/// What the parts of crosswise elimination cost a system of n unknowns, by running them on counted numbers.
struct Counts {
  double n = 0;
  Cost first_row = {}, forward_second = {}, full_second = {};  ///< one column cleared
  Cost full = {}, division = {};                               ///< all columns cleared; then the division
  Cost forward_and_back = {};
};

inline Counts count(std::size_t n) {
  using Number = Counted<double>;
  const Rows<Number> start(n, std::vector<Number>(n + 1, 1.0));
  Counts counts{static_cast<double>(n)};
  auto rows = start;
  counts.first_row = operations_of([&] { full_step(rows, 0); });
  if (n > 1) {
    auto forward = rows;
    counts.forward_second = operations_of([&] { forward_step(forward, 1); });
    counts.full_second = operations_of([&] { full_step(rows, 1); });
  }
  rows = start;
  counts.full = operations_of([&] {
    for (std::size_t k = 0; k < n; ++k) full_step(rows, k);
  });
  counts.division = operations_of([&] { return divide(rows); });
  counts.forward_and_back = operations_of([&] { return solve_forward(start, Clearing::crosswise); });
  return counts;
}

}  // namespace oddity::elimination
