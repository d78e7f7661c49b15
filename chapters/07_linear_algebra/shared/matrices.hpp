#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

/// Square matrices, generic in their entries, and their products with sums in a given order.
namespace oddity::matrices {

__extension__ typedef __int128 Whole;

/// Quaternions, whose products do not commute.
struct Quaternion {
  double w = 0, x = 0, y = 0, z = 0;
  friend Quaternion operator+(const Quaternion& a, const Quaternion& b) {
    return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
};

template <class T>
struct Matrix {
  int n;
  std::vector<T> entries = std::vector<T>(static_cast<std::size_t>(n * n));
  T& operator()(int r, int c) { return entries[static_cast<std::size_t>(r * n + c)]; }
  const T& operator()(int r, int c) const { return entries[static_cast<std::size_t>(r * n + c)]; }
};

template <class T>
Matrix<T> filled(int n, const auto& entry) {
  Matrix<T> m{n};
  for (int r = 0; r < n; ++r)
    for (int c = 0; c < n; ++c) m(r, c) = entry(r, c);
  return m;
}

template <class T>
Matrix<T> transposed(const Matrix<T>& m) {
  return filled<T>(m.n, [&](int r, int c) { return m(c, r); });
}

template <class T>
std::vector<T> applied(const Matrix<T>& m, const std::vector<T>& x) {
  std::vector<T> y(x.size());
  for (int r = 0; r < m.n; ++r)
    for (int c = 0; c < m.n; ++c)
      y[static_cast<std::size_t>(r)] =
          y[static_cast<std::size_t>(r)] + m(r, c) * x[static_cast<std::size_t>(c)];
  return y;
}

/// The determinant by fraction-free elimination with row exchange (Bareiss 1968): no division leaves a
/// remainder. All intermediate numbers are minors of the matrix.
inline Whole bareiss(Matrix<Whole> m) {
  Whole previous = 1, sign = 1;
  for (int k = 0; k + 1 < m.n; ++k) {
    int pivot = k;
    while (pivot < m.n && m(pivot, k) == 0) ++pivot;
    if (pivot == m.n) return 0;
    if (pivot != k) {
      for (int j = k; j < m.n; ++j) std::swap(m(k, j), m(pivot, j));
      sign = -sign;
    }
    for (int i = k + 1; i < m.n; ++i)
      for (int j = k + 1; j < m.n; ++j) m(i, j) = (m(k, k) * m(i, j) - m(i, k) * m(k, j)) / previous;
    previous = m(k, k);
  }
  return m.n == 0 ? 1 : sign * m(m.n - 1, m.n - 1);
}

enum class Order { ascending, descending, pairwise, fused };

template <class T>
T sum_of_products(const auto& left, const auto& right, int from, int to, Order order) {
  if (order == Order::pairwise && to - from > 1) {
    const int middle = (from + to) / 2;
    return sum_of_products<T>(left, right, from, middle, order) +
           sum_of_products<T>(left, right, middle, to, order);
  }
  T sum{};
  for (int i = from; i < to; ++i) {
    const int k = order == Order::descending ? from + to - 1 - i : i;
    if constexpr (std::same_as<T, double>)
      sum = order == Order::fused ? std::fma(left(k), right(k), sum) : sum + left(k) * right(k);
    else
      sum = sum + left(k) * right(k);
  }
  return sum;
}

template <class T>
Matrix<T> product(const Matrix<T>& a, const Matrix<T>& b, Order order) {
  return filled<T>(a.n, [&](int r, int c) {
    return sum_of_products<T>([&](int k) { return a(r, k); }, [&](int k) { return b(k, c); }, 0, a.n, order);
  });
}

}  // namespace oddity::matrices
