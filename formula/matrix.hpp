#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "formula/unreadable.hpp"

namespace oddity::formula {

/// A number, a column, a row (as x^T) or a matrix. Operations throw NoValue if shapes do not fit.
template <class T>
struct Matrix {
  std::vector<T> entries;  ///< row by row
  std::size_t columns = 1;

  std::size_t rows() const { return entries.size() / columns; }
  bool is_number() const { return entries.size() == 1; }
};

/// A letter's numbers as a matrix: four or nine form a square one.
template <class T>
Matrix<T> of_letter(std::vector<T> entries) {
  const std::size_t n = entries.size();
  return {std::move(entries), n == 4 ? 2u : n == 9 ? 3u : 1u};
}

template <class T>
const T& number_of(const Matrix<T>& x) {
  if (!x.is_number()) throw NoValue("a number is expected where there are several");
  return x.entries[0];
}

template <class T>
Matrix<T> scaled(Matrix<T> x, const T& factor) {
  for (T& entry : x.entries) entry = entry * factor;
  return x;
}
template <class T>
Matrix<T> scaled_from_left(const T& factor, Matrix<T> x) {
  for (T& entry : x.entries) entry = factor * entry;
  return x;
}
template <class T>
Matrix<T> divided(Matrix<T> x, const T& divisor) {
  for (T& entry : x.entries) entry = entry / divisor;
  return x;
}
template <class T>
Matrix<T> negated(Matrix<T> x) {
  for (T& entry : x.entries) entry = -entry;
  return x;
}

/// Adds or subtracts matrices of the same shape.
template <class T>
Matrix<T> added(Matrix<T> a, const Matrix<T>& b, bool subtract) {
  if (a.entries.size() != b.entries.size()) throw NoValue("a sum of different shapes");
  a.columns = std::max(a.columns, b.columns);
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    a.entries[i] = subtract ? a.entries[i] - b.entries[i] : a.entries[i] + b.entries[i];
  return a;
}

template <class T>
Matrix<T> product_of(const Matrix<T>& a, const Matrix<T>& b) {
  if (a.is_number()) return scaled_from_left(a.entries[0], b);
  if (b.is_number()) return scaled(a, b.entries[0]);
  if (a.columns != b.rows()) throw NoValue("a product of matrices that do not fit");
  Matrix<T> y{{}, b.columns};
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (std::size_t j = 0; j < b.columns; ++j) {
      T total = a.entries[i * a.columns] * b.entries[j];
      for (std::size_t k = 1; k < a.columns; ++k)
        total = total + a.entries[i * a.columns + k] * b.entries[k * b.columns + j];
      y.entries.push_back(total);
    }
  return y;
}

template <class T>
Matrix<T> transposed(const Matrix<T>& x) {
  Matrix<T> y{x.entries, x.rows()};
  for (std::size_t i = 0; i < x.rows(); ++i)
    for (std::size_t j = 0; j < x.columns; ++j) y.entries[j * y.columns + i] = x.entries[i * x.columns + j];
  return y;
}

template <class T>
T dot_of(const Matrix<T>& a, const Matrix<T>& b) {
  if (a.entries.empty() || a.entries.size() != b.entries.size() || (a.columns > 1 && a.rows() > 1))
    throw NoValue("a dot product of vectors of different lengths, or of matrices");
  T total = a.entries[0] * b.entries[0];
  for (std::size_t i = 1; i < a.entries.size(); ++i) total = total + a.entries[i] * b.entries[i];
  return total;
}

template <class T>
Matrix<T> cross_of(const Matrix<T>& x, const Matrix<T>& y) {
  const std::vector<T>&a = x.entries, &b = y.entries;
  if (a.size() == 1 && b.size() == 1) return {{a[0] * b[0]}};
  if (a.size() != 3 || b.size() != 3)
    throw NoValue("a cross product of vectors that are not in three dimensions");
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

template <class T>
Matrix<T> joined(Matrix<T> a, const Matrix<T>& b) {
  a.entries.insert(a.entries.end(), b.entries.begin(), b.entries.end());
  a.columns = 1;
  return a;
}

template <class T>
Matrix<T> diagonal_of(const std::vector<T>& x) {
  if (x.size() > 12) throw NoValue("a diagonal matrix of more than twelve numbers");
  Matrix<T> y{std::vector<T>(x.size() * x.size(), T(0)), x.size()};
  for (std::size_t i = 0; i < x.size(); ++i) y.entries[i * (x.size() + 1)] = x[i];
  return y;
}

/// The matrix of the cross product with x.
template <class T>
Matrix<T> skew_of(const std::vector<T>& x) {
  if (x.size() != 3) throw NoValue("Skew of a vector that is not in three dimensions");
  return {{T(0), -x[2], x[1], x[2], T(0), -x[0], -x[1], x[0], T(0)}, 3};
}
template <class T>
Matrix<T> unskew_of(const Matrix<T>& x) {
  if (x.entries.size() != 9 || x.columns != 3) throw NoValue("Unskew of a matrix that is not three by three");
  return {{x.entries[7], x.entries[2], x.entries[3]}};
}

/// a above b.
template <class T>
Matrix<T> stacked(const Matrix<T>& a, const Matrix<T>& b) {
  if (a.columns != b.columns) throw NoValue("rows of different lengths");
  const std::size_t columns = a.columns;
  Matrix<T> y = joined(a, b);
  y.columns = columns;
  return y;
}
/// a and b side by side.
template <class T>
Matrix<T> abreast(const Matrix<T>& a, const Matrix<T>& b) {
  if (a.rows() != b.rows()) throw NoValue("columns of different lengths");
  return transposed(stacked(transposed(a), transposed(b)));
}

}  // namespace oddity::formula
