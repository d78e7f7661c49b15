#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>

#include "solvers/taylor/tape.hpp"

/// How the coefficient of order k of an operation follows from those of its operands up to order k and its
/// own below. The order is a constant of the compiler's, and so every sum is straight code, added up in
/// pairs, and last what has the newest coefficients. T is double, or a number that counts.
namespace oddity::taylor {

/// Two numbers beside each other.
using Two = double __attribute__((vector_size(16)));

/// The coefficients of a number, or of two. Two numbers' rows are interleaved, so that both may be had at
/// once.
template <class T>
struct Row {
  T* first = nullptr;
  T& operator[](int k) const { return first[2L * k]; }
  bool operator==(const Row&) const = default;
};
struct Both {
  double* first;
  Two operator[](int k) const {
    Two x;
    std::memcpy(&x, first + 2L * k, sizeof x);
    return x;
  }
  void put(int k, Two x) const { std::memcpy(first + 2L * k, &x, sizeof x); }
  bool operator==(const Both&) const = default;
};
/// One number, twice.
struct Twice {
  double* first;
  Two operator[](int k) const { return Two{first[2L * k], first[2L * k]}; }
};

/// The rows of coefficients that an operation has to do with.
template <class T>
struct Rows {
  Row<T> a, b;  ///< null where there is none
  Row<T> result;
  Row<T> second;  ///< of a sine, its cosine
  Row<T> spare;   ///< to work in
};

/// The sum of term(j) over the n numbers j from `first` on.
template <int first, int n, class Term>
[[gnu::always_inline]] inline auto sum(const Term& term) {
  if constexpr (n == 1)
    return term(first);
  else
    return sum<first, n / 2>(term) + sum<first + n / 2, n - n / 2>(term);
}

/// The sum of a_j b_(k-j) over 0 < j < k.
template <int k, class A, class B>
[[gnu::always_inline]] inline auto inside(const A& a, const B& b) {
  return sum<1, k - 1>([=](int j) { return a[j] * b[k - j]; });
}

/// The same of a with itself.
template <int k, class A>
[[gnu::always_inline]] inline auto inside(const A& a) {
  if constexpr (k == 2) {
    return a[1] * a[1];
  } else {
    const auto once = sum<1, (k - 1) / 2>([=](int j) { return a[j] * a[k - j]; });
    if constexpr (k % 2 == 0)
      return once + once + a[k / 2] * a[k / 2];
    else
      return once + once;
  }
}

/// Coefficient k of a b, and of a a.
template <int k, class A, class B>
[[gnu::always_inline]] inline auto product(const A& a, const B& b) {
  if constexpr (k == 0)
    return a[0] * b[0];
  else if constexpr (const auto ends = a[0] * b[k] + a[k] * b[0]; k == 1)
    return ends;
  else
    return ends + inside<k>(a, b);
}
template <int k, class A>
[[gnu::always_inline]] inline auto square(const A& a) {
  if constexpr (k == 0)
    return a[0] * a[0];
  else if constexpr (const auto ends = (a[0] + a[0]) * a[k]; k == 1)
    return ends;
  else
    return ends + inside<k>(a);
}

template <int k, class T>
[[gnu::always_inline]] inline void linear(const Node& node, const Rows<T>& rows) {
  const auto times = [](double scale, const T& x) {
    return scale == 1 ? x : scale == -1 ? -x : T(scale) * x;
  };
  T sum = times(node.alpha, rows.a[k]);
  if (rows.b.first) sum = node.beta == -1 ? sum - rows.b[k] : sum + times(node.beta, rows.b[k]);
  if (k == 0 && node.gamma != 0) sum += T(node.gamma);
  rows.result[k] = sum;
}

template <int k, class T>
[[gnu::always_inline]] inline void multiply(const Rows<T>& rows) {
  rows.result[k] = rows.a == rows.b ? square<k>(rows.a) : product<k>(rows.a, rows.b);
}

/// r = a / b from a = r b.
template <int k, class T>
[[gnu::always_inline]] inline void divide(const Node& node, const Rows<T>& rows) {
  const Row<T> a = rows.a, b = rows.b, r = rows.result;
  T& reciprocal = rows.spare[0];
  if constexpr (k == 0) {
    reciprocal = T(1) / b[0];
    r[0] = (a.first ? a[0] : T(node.gamma)) * reciprocal;
  } else {
    T known = r[0] * b[k];
    if constexpr (k > 1) known += inside<k>(r, b);
    r[k] = (a.first ? a[k] - known : -known) * reciprocal;
  }
}

/// r = a^e with e = -3/2, from a r' = e r a': k a_0 r_k = sum over j = 1..k of (e j - (k - j)) a_j r_(k-j).
template <int k, class T>
[[gnu::always_inline]] inline void inverse_cube(const Node& node, const Rows<T>& rows) {
  using std::sqrt;
  const Row<T> a = rows.a, r = rows.result;
  T& reciprocal = rows.spare[0];
  if constexpr (k == 0) {
    r[0] = T(node.gamma) / (a[0] * sqrt(a[0]));
    reciprocal = T(1) / a[0];
  } else {
    const auto term = [=](int j) { return T(-1.5 * j / k - (1 - 1.0 * j / k)) * a[j] * r[k - j]; };
    const T newest = term(k);  // what the others do not wait for
    if constexpr (k == 1)
      r[k] = newest * reciprocal;
    else
      r[k] = (sum<1, k - 1>(term) + newest) * reciprocal;
  }
}

/// r from r r = a.
template <int k, class T>
[[gnu::always_inline]] inline void square_root(const Rows<T>& rows) {
  using std::sqrt;
  const Row<T> a = rows.a, r = rows.result;
  T& reciprocal = rows.spare[0];
  if constexpr (k == 0) {
    r[0] = sqrt(a[0]);
    reciprocal = T(0.5) / r[0];
  } else if constexpr (k == 1) {
    r[1] = a[1] * reciprocal;
  } else {
    r[k] = (a[k] - inside<k>(r)) * reciprocal;
  }
}

/// s' = a' c and c' = -a' s; the spare row has the slope a', its order k - 1 at k.
template <int k, class T>
[[gnu::always_inline]] inline void sine_and_cosine(const Rows<T>& rows) {
  using std::cos, std::sin;
  const Row<T> a = rows.a, s = rows.result, c = rows.second, slope = rows.spare;
  if constexpr (k == 0) {
    s[0] = sin(a[0]);
    c[0] = cos(a[0]);
  } else {
    slope[k] = T(k) * a[k];
    T s_slope = slope[k] * c[0], c_slope = slope[k] * s[0];
    if constexpr (k > 1) s_slope += inside<k>(slope, c), c_slope += inside<k>(slope, s);
    s[k] = s_slope * T(1.0 / k);
    c[k] = c_slope * T(-1.0 / k);
  }
}

/// The same with the rows of sine and cosine interleaved.
template <int k>
[[gnu::always_inline]] inline void sine_with_cosine(const Rows<double>& rows) {
  using std::cos, std::sin;
  const Row<double> a = rows.a, slope = rows.spare;
  const Both both{rows.result.first};
  if constexpr (k == 0) {
    both.put(0, Two{sin(a[0]), cos(a[0])});
  } else {
    const double newest = slope[k] = k * a[k];
    Two slopes = Two{newest, newest} * both[0];
    if constexpr (k > 1) slopes += inside<k>(Twice{slope.first}, both);
    both.put(k, Two{slopes[1], slopes[0]} * Two{1.0 / k, -1.0 / k});
  }
}

/// r' = a' r; the spare row as above.
template <int k, class T>
[[gnu::always_inline]] inline void exponential(const Rows<T>& rows) {
  using std::exp;
  const Row<T> a = rows.a, r = rows.result, slope = rows.spare;
  if constexpr (k == 0) {
    r[0] = exp(a[0]);
  } else {
    slope[k] = T(k) * a[k];
    T r_slope = slope[k] * r[0];
    if constexpr (k > 1) r_slope += inside<k>(slope, r);
    r[k] = r_slope * T(1.0 / k);
  }
}

/// Coefficient k of the operation.
template <int k, class T>
[[gnu::always_inline]] inline void compute(Operation operation, const Node& node, const Rows<T>& rows) {
  switch (operation) {
    case Operation::linear:
      return linear<k>(node, rows);
    case Operation::multiply:
      return multiply<k>(rows);
    case Operation::divide:
      return divide<k>(node, rows);
    case Operation::inverse_cube:
      return inverse_cube<k>(node, rows);
    case Operation::square_root:
      return square_root<k>(rows);
    case Operation::sine:
      return sine_and_cosine<k>(rows);
    case Operation::exponential:
      return exponential<k>(rows);
    case Operation::unknown:
    case Operation::cosine:
      return;
  }
}

}  // namespace oddity::taylor
