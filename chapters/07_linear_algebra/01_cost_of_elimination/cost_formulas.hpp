#pragma once

/// The formulas of 7.1 for the cost of elimination with n unknowns, generic in their number type: evaluated
/// by the claims, and recorded for their proofs.
namespace oddity::ex07_01 {

/// Cost as counts of multiplications, additions (and subtractions) and divisions.
template <class T>
struct CostOf {
  T mu = 0, alpha = 0, delta = 0;

  friend constexpr CostOf operator+(const CostOf& a, const CostOf& b) {
    return {a.mu + b.mu, a.alpha + b.alpha, a.delta + b.delta};
  }
  friend constexpr CostOf operator*(const T& x, const CostOf& a) {
    return {x * a.mu, x * a.alpha, x * a.delta};
  }
  friend constexpr CostOf operator-(const CostOf& a, const CostOf& b) { return a + T(-1) * b; }
};

/// m multiplications, a additions and d divisions.
template <class T>
constexpr CostOf<T> cost(int m, int a, int d) {
  return {T(m), T(a), T(d)};
}
/// Cost of clearing one entry of a row crosswise.
template <class T>
constexpr CostOf<T> entry_cost() {
  return cost<T>(2, 1, 0);
}
template <class T>
CostOf<T> diagonals(const T& n) {
  return n * (n - 1) / 2 * cost<T>(1, 0, 0);
}

template <class T>
CostOf<T> printed_second_row(const T& n) {
  return (n - 1) * (n - 1) * entry_cost<T>();
}
template <class T>
CostOf<T> printed_full(const T& n) {
  return (n - 1) * n * (n + 1) / 2 * entry_cost<T>();
}
template <class T>
CostOf<T> printed_total(const T& n) {
  return printed_full(n) + n * cost<T>(0, 0, 1);
}
template <class T>
CostOf<T> corrected_total(const T& n) {
  return printed_total(n) + diagonals(n);
}
template <class T>
CostOf<T> printed_original(const T& n) {
  return (n - 1) * n * (n + 1) / 3 * entry_cost<T>() + n * (n - 1) / 2 * cost<T>(1, 1, 0) +
         n * cost<T>(0, 0, 1);
}
template <class T>
CostOf<T> printed_difference(const T& n) {
  return (n - 1) * n * (n + 1) / 6 * entry_cost<T>() - n * (n - 1) / 2 * cost<T>(1, 1, 0);
}

/// The difference of the totals, factored: as printed, of the printed totals, and of the counts. The
/// numerator is a whole number.
inline constexpr const char *printed_factored = R"($n(n-1)[(2\mu+\alpha)n-\mu]/6$)",
                            *factored_of_totals = R"($n(n-1)[(2\mu+\alpha)n-\mu-2\alpha]/6$)",
                            *factored_of_counts = R"($n(n-1)[(2\mu+\alpha)n+2\mu-2\alpha]/6$)";

}  // namespace oddity::ex07_01
