#pragma once

#include <cmath>
#include <cstring>
#include <type_traits>

#include "solvers/taylor/tape.hpp"

/// Computes coefficient k of an operation from those of its operands up to order k and its own of lower
/// order. The order is a compile-time constant, so every sum is straight-line code, added up in pairs; terms
/// with the newest coefficients are added last. T is double, or a counted number.
namespace oddity::taylor {

/// Two adjacent numbers.
using Two = double __attribute__((vector_size(16)));

/// Offset of coefficient k from the row's address, which is its eighth coefficient. So the first sixteen are
/// within the one-byte displacement of an instruction.
constexpr long place(int k) { return 2L * (k - 8); }

/// The coefficients of a number, or of two. Two numbers' rows are interleaved, so that both load at once.
template <class T>
struct Row {
  T* eighth = nullptr;
  static Row from(T* first) { return {first - place(0)}; }
  T& operator[](int k) const { return eighth[place(k)]; }
};
template <class T>
struct Pairs {
  T* eighth;
  static Pairs from(T* first) { return {first - place(0)}; }
  Two operator[](int k) const {
    Two x;
    std::memcpy(&x, __builtin_assume_aligned(eighth + place(k), sizeof x), sizeof x);
    return x;
  }
  void put(int k, Two x) const {
    std::memcpy(__builtin_assume_aligned(eighth + place(k), sizeof x), &x, sizeof x);
  }
};
using Both = Pairs<double>;
/// A number twice.
constexpr Two twice(double x) { return Two{x, x}; }
struct Twice {
  double* eighth;
  Two operator[](int k) const { return twice(eighth[place(k)]); }
};
/// A row whose coefficient k is in a register.
template <int k, class Row, class T>
struct Newest {
  Row row;
  T newest;
  T operator[](int j) const { return j == k ? newest : T(row[j]); }
};

/// The rows of coefficients that an operation uses.
template <class T, class A = Row<T>, class B = Row<T>>
struct Rows {
  A a;
  B b;
  Row<T> result;
  Row<T> second;  ///< for a sine, the cosine
  Row<T> spare;   ///< scratch memory
};

/// Sum of term(j) over n numbers j from `first` on.
template <int first, int n, class Term>
[[gnu::always_inline]] inline auto sum(const Term& term) {
  if constexpr (n == 1)
    return term(first);
  else
    return sum<first, n / 2>(term) + sum<first + n / 2, n - n / 2>(term);
}

/// Sum of the same terms, but every second one separately: those from `first` on, and those from the next.
template <int first, int n, class Term>
[[gnu::always_inline]] inline auto sum_by_parity(const Term& term) {
  constexpr int pairs = n / 2;
  if constexpr (pairs == 0) {
    return term(first);
  } else {
    const auto both = sum<0, pairs>([&](int i) { return term(first + 2 * i); }) +
                      sum<0, pairs>([&](int i) { return term(first + 2 * i + 1); });
    if constexpr (n % 2 == 0)
      return both;
    else
      return both + term(first + n - 1);
  }
}

/// Sum of a_j b_(k-j) over 0 < j < k.
template <int k, class A, class B>
[[gnu::always_inline]] inline auto inside(const A& a, const B& b) {
  return sum<1, k - 1>([=](int j) { return a[j] * b[k - j]; });
}

/// Sum of a_j a_(k-j) over 0 < j < k.
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

/// Coefficient k of a b, and of a a. The newest coefficient, b's, is added last: the other terms do not wait
/// for it.
template <int k, class A, class B>
[[gnu::always_inline]] inline auto product(const A& a, const B& b) {
  if constexpr (k == 0)
    return a[0] * b[0];
  else if constexpr (k == 1)
    return a[k] * b[0] + a[0] * b[k];
  else
    return (inside<k>(a, b) + a[k] * b[0]) + a[0] * b[k];
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

template <int k, class Rows>
[[gnu::always_inline]] inline auto multiply(const Node& node, const Rows& rows) {
  return node.a == node.b ? square<k>(rows.a) : product<k>(rows.a, rows.b);
}

/// r = a / b from a = r b.
template <int k, class Rows>
[[gnu::always_inline]] inline auto divide(const Node& node, const Rows& rows) {
  const auto& a = rows.a;
  const auto& b = rows.b;
  const auto& r = rows.result;
  using T = std::decay_t<decltype(r[k])>;
  T& reciprocal = rows.spare[0];
  if constexpr (k == 0) {
    reciprocal = T(1) / b[0];
    return (node.a >= 0 ? a[0] : T(node.gamma)) * reciprocal;
  } else {
    T known = r[0] * b[k];
    if constexpr (k > 1) known += inside<k>(r, b);
    return (node.a >= 0 ? a[k] - known : -known) * reciprocal;
  }
}

/// r = a^e with e = -3/2, from a r' = e r a': k a_0 r_k = sum over j = 1..k of (e j - (k - j)) a_j r_(k-j).
constexpr double inverse_cube_scale(int j, int k) { return -1.5 * j / k - (1 - 1.0 * j / k); }

template <int k, class Rows>
[[gnu::always_inline]] inline auto inverse_cube(const Node& node, const Rows& rows) {
  using std::sqrt;
  const auto& a = rows.a;
  const auto& r = rows.result;
  using T = std::decay_t<decltype(r[k])>;
  T& reciprocal = rows.spare[0];
  if constexpr (k == 0) {
    reciprocal = T(1) / a[0];
    return T(node.gamma) / (a[0] * sqrt(a[0]));
  } else {
    const auto term = [=](int j) { return T(inverse_cube_scale(j, k)) * a[j] * r[k - j]; };
    const T newest = T(-1.5) * r[0] * a[k];
    if constexpr (k == 1)
      return newest * reciprocal;
    else if constexpr (k == 2)
      return (term(1) + newest) * reciprocal;
    else
      return (sum_by_parity<2, k - 2>(term) + term(1) + newest) * reciprocal;
  }
}

/// r from r r = a.
template <int k, class Rows>
[[gnu::always_inline]] inline auto square_root(const Rows& rows) {
  using std::sqrt;
  const auto& a = rows.a;
  const auto& r = rows.result;
  using T = std::decay_t<decltype(r[k])>;
  T& reciprocal = rows.spare[0];
  if constexpr (k == 0) {
    const T root = sqrt(a[0]);
    reciprocal = T(0.5) / root;
    return root;
  } else if constexpr (k == 1) {
    return a[1] * reciprocal;
  } else {
    return (a[k] - inside<k>(r)) * reciprocal;
  }
}

/// s' = a' c and c' = -a' s; the spare row has the slope a', its order k - 1 at k.
template <int k, class Rows>
[[gnu::always_inline]] inline auto sine_and_cosine(const Rows& rows) {
  using std::cos, std::sin;
  const auto& a = rows.a;
  const auto& s = rows.result;
  const auto& c = rows.second;
  const auto& slope = rows.spare;
  using T = std::decay_t<decltype(s[k])>;
  if constexpr (k == 0) {
    c[0] = cos(a[0]);
    return T(sin(a[0]));
  } else {
    slope[k] = T(k) * a[k];
    T s_slope = slope[k] * c[0], c_slope = slope[k] * s[0];
    if constexpr (k > 1) s_slope += inside<k>(slope, c), c_slope += inside<k>(slope, s);
    c[k] = c_slope * T(-1.0 / k);
    return s_slope * T(1.0 / k);
  }
}

/// Sine and cosine of alpha t + gamma, which has no order above the first.
template <int k, class Rows>
[[gnu::always_inline]] inline auto turn(const Node& node, const Rows& rows) {
  using std::cos, std::sin;
  const auto& s = rows.result;
  const auto& c = rows.second;
  using T = std::decay_t<decltype(s[k])>;
  if constexpr (k == 0) {
    const T angle = T(node.alpha) * rows.a[0] + T(node.gamma);
    c[0] = cos(angle);
    return T(sin(angle));
  } else {
    const T s_slope = T(node.alpha) * c[k - 1], c_slope = T(node.alpha) * s[k - 1];
    c[k] = c_slope * T(-1.0 / k);
    return s_slope * T(1.0 / k);
  }
}

/// r' = a' r; the spare row as above.
template <int k, class Rows>
[[gnu::always_inline]] inline auto exponential(const Rows& rows) {
  using std::exp;
  const auto& a = rows.a;
  const auto& r = rows.result;
  const auto& slope = rows.spare;
  using T = std::decay_t<decltype(r[k])>;
  if constexpr (k == 0) {
    return T(exp(a[0]));
  } else {
    slope[k] = T(k) * a[k];
    T r_slope = slope[k] * r[0];
    if constexpr (k > 1) r_slope += inside<k>(slope, r);
    return r_slope * T(1.0 / k);
  }
}

/// Coefficient k of the operation, unless it is linear; also stored in its row.
template <int k, class Rows>
[[gnu::always_inline]] inline auto compute(Operation operation, const Node& node, const Rows& rows) {
  auto& result = rows.result[k];
  switch (operation) {
    case Operation::multiply:
      return result = multiply<k>(node, rows);
    case Operation::divide:
      return result = divide<k>(node, rows);
    case Operation::inverse_cube:
      return result = inverse_cube<k>(node, rows);
    case Operation::square_root:
      return result = square_root<k>(rows);
    case Operation::sine:
      return result = sine_and_cosine<k>(rows);
    case Operation::turning:
      return result = turn<k>(node, rows);
    case Operation::exponential:
      return result = exponential<k>(rows);
    case Operation::linear:
    case Operation::unknown:
    case Operation::cosine:
      break;
  }
  return result;
}

// ---- with pairs of numbers, bitwise the same as above ----------------------------------------------------

/// r = a^e as above, from rows of the pairs (a_(j-1), a_j) and (r_j, r_(j-1)).
template <int k, class Rows>
[[gnu::always_inline]] inline double inverse_cube_by_pairs(const Node& node, const Rows& rows,
                                                           const Both& rising, const Both& falling) {
  const auto& a = rows.a;
  const auto& r = rows.result;
  double newest = 0;
  if constexpr (k < 4) {
    newest = inverse_cube<k>(node, rows);
  } else {
    constexpr int pairs = (k - 2) / 2;
    const auto term = [=](int j) { return inverse_cube_scale(j, k) * a[j] * r[k - j]; };
    const Two both = sum<0, pairs>([=](int i) {
      const int j = 2 + 2 * i;
      return Two{inverse_cube_scale(j, k), inverse_cube_scale(j + 1, k)} * rising[j + 1] * falling[k - j];
    });
    double known = both[0] + both[1];
    if constexpr (k % 2 == 1) known += term(k - 1);
    newest = (known + term(1) + -1.5 * r[0] * a[k]) * rows.spare[0];
  }
  if constexpr (k > 0) rising.put(k, Two{a[k - 1], a[k]}), falling.put(k, Two{newest, r[k - 1]});
  return newest;
}

/// Sine and cosine, with interleaved rows; the spare row has the slope twice.
template <int k, class A>
[[gnu::always_inline]] inline Two sine_with_cosine(const A& a, const Both& both, const Both& slope) {
  using std::cos, std::sin;
  if constexpr (k == 0) {
    return Two{sin(a[0]), cos(a[0])};
  } else {
    const Two newest = twice(k * a[k]);
    slope.put(k, newest);
    Two slopes = newest * both[0];
    if constexpr (k > 1) slopes += inside<k>(slope, both);
    return Two{slopes[1], slopes[0]} * Two{1.0 / k, -1.0 / k};
  }
}

/// Sine and cosine of alpha t + gamma.
template <int k>
[[gnu::always_inline]] inline Two turn_both(const Node& node, const Row<double>& time, const Both& both) {
  using std::cos, std::sin;
  if constexpr (k == 0) {
    const double angle = node.alpha * time[0] + node.gamma;
    return Two{sin(angle), cos(angle)};
  } else {
    const Two slopes = twice(node.alpha) * both[k - 1];
    return Two{slopes[1], slopes[0]} * Two{1.0 / k, -1.0 / k};
  }
}

}  // namespace oddity::taylor
