#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "chapters/numbers.hpp"
#include "solvers/dual.hpp"

/// Lagrange's equations for n coordinates q with v = q'. A function f(q, v), or f(q, v, t), is generic in its
/// number type; its derivatives are by dual numbers.
namespace oddity {

template <class T>
using Two = std::array<T, 2>;
using Pair = Two<double>;

/// x with a slope of one in its i-th component.
template <class T, std::size_t n>
std::array<Dual<T>, n> toward(const std::array<T, n>& x, std::size_t i) {
  std::array<Dual<T>, n> y;
  for (std::size_t k = 0; k < n; ++k) y[k] = Dual<T>(x[k], T(k == i ? 1.0 : 0.0));
  return y;
}
template <class T, std::size_t n>
std::array<Dual<T>, n> still(const std::array<T, n>& x) {
  return toward(x, n);
}
/// x moving at the rate v.
template <class T, std::size_t n>
std::array<Dual<T>, n> moving(const std::array<T, n>& x, const std::array<T, n>& v) {
  std::array<Dual<T>, n> y;
  for (std::size_t k = 0; k < n; ++k) y[k] = {x[k], v[k]};
  return y;
}

namespace detail {

template <class F, class X, std::size_t n>
X value_of(const F& f, const std::array<X, n>& q, const std::array<X, n>& v, const X& t) {
  if constexpr (requires { f(q, v, t); })
    return f(q, v, t);
  else
    return f(q, v);
}

/// The solution x of m x = b for symmetric m, by Cramer's rule.
template <class T>
std::array<T, 1> solved(const std::array<std::array<T, 1>, 1>& m, const std::array<T, 1>& b) {
  return {b[0] / m[0][0]};
}
template <class T>
Two<T> solved(const std::array<Two<T>, 2>& m, const Two<T>& b) {
  const T determinant = m[0][0] * m[1][1] - m[0][1] * m[0][1];
  return {(m[1][1] * b[0] - m[0][1] * b[1]) / determinant, (m[0][0] * b[1] - m[0][1] * b[0]) / determinant};
}
template <class T>
std::array<T, 3> solved(const std::array<std::array<T, 3>, 3>& m, const std::array<T, 3>& b) {
  const T determinant = dot(m[0], cross(m[1], m[2]));
  return {dot(b, cross(m[1], m[2])) / determinant, dot(m[0], cross(b, m[2])) / determinant,
          dot(m[0], cross(m[1], b)) / determinant};
}

}  // namespace detail

template <class F, class T, std::size_t n>
std::array<T, n> df_dq(const F& f, const std::array<T, n>& q, const std::type_identity_t<std::array<T, n>>& v,
                       std::type_identity_t<T> t = 0) {
  std::array<T, n> slopes;
  for (std::size_t i = 0; i < n; ++i)
    slopes[i] = detail::value_of(f, toward(q, i), still(v), Dual<T>(t)).slope;
  return slopes;
}

template <class F, class T, std::size_t n>
std::array<T, n> df_dv(const F& f, const std::array<T, n>& q, const std::type_identity_t<std::array<T, n>>& v,
                       std::type_identity_t<T> t = 0) {
  std::array<T, n> slopes;
  for (std::size_t i = 0; i < n; ++i)
    slopes[i] = detail::value_of(f, still(q), toward(v, i), Dual<T>(t)).slope;
  return slopes;
}

/// d/dt of df/dv along a motion with q' = v, v' = a.
template <class F, class T, std::size_t n>
std::array<T, n> rate_of_df_dv(const F& f, const std::array<T, n>& q,
                               const std::type_identity_t<std::array<T, n>>& v,
                               const std::type_identity_t<std::array<T, n>>& a,
                               std::type_identity_t<T> t = 0) {
  const auto along_q = moving(q, v), along_v = moving(v, a);
  std::array<T, n> rates;
  for (std::size_t i = 0; i < n; ++i)
    rates[i] =
        detail::value_of(f, still(along_q), toward(along_v, i), Dual<Dual<T>>(Dual<T>(t, T(1)))).slope.slope;
  return rates;
}

/// d/dt df/dv - df/dq, the left side of Lagrange's equations.
template <class F, class T, std::size_t n>
std::array<T, n> lagrange_left_side(const F& lagrangian, const std::array<T, n>& q,
                                    const std::type_identity_t<std::array<T, n>>& v,
                                    const std::type_identity_t<std::array<T, n>>& a,
                                    std::type_identity_t<T> t = 0) {
  auto left = rate_of_df_dv(lagrangian, q, v, a, t);
  const auto slope = df_dq(lagrangian, q, v, t);
  for (std::size_t i = 0; i < n; ++i) left[i] -= slope[i];
  return left;
}

/// v' by Lagrange's equations d/dt df/dv = df/dq + force.
template <class F, class T, std::size_t n>
std::array<T, n> lagrange_accelerations(const F& lagrangian, const std::array<T, n>& q,
                                        const std::type_identity_t<std::array<T, n>>& v,
                                        const std::type_identity_t<std::array<T, n>>& force = {},
                                        std::type_identity_t<T> t = 0) {
  const auto rate = rate_of_df_dv(lagrangian, q, v, {}, t);
  auto unbalanced = df_dq(lagrangian, q, v, t);
  std::array<std::array<T, n>, n> mass;
  for (std::size_t i = 0; i < n; ++i) {
    unbalanced[i] = unbalanced[i] + force[i] - rate[i];
    for (std::size_t j = i; j < n; ++j)
      mass[i][j] = mass[j][i] =
          detail::value_of(lagrangian, still(still(q)), toward(toward(v, i), j), Dual<Dual<T>>(Dual<T>(t)))
              .slope.slope;
  }
  return detail::solved(mass, unbalanced);
}

// ---- one coordinate, a function f(q, v, t) of numbers -----------------------------------------------------

namespace detail {

template <class F>
auto of_one(const F& f) {
  return [&f](const auto& q, const auto& v, const auto& t) { return f(q[0], v[0], t); };
}

}  // namespace detail

template <class F, class T>
T df_dq(const F& f, const T& q, const std::type_identity_t<T>& v, std::type_identity_t<T> t = 0) {
  return df_dq(detail::of_one(f), std::array{q}, {v}, t)[0];
}
template <class F, class T>
T df_dv(const F& f, const T& q, const std::type_identity_t<T>& v, std::type_identity_t<T> t = 0) {
  return df_dv(detail::of_one(f), std::array{q}, {v}, t)[0];
}
template <class F, class T>
T rate_of_df_dv(const F& f, const T& q, const std::type_identity_t<T>& v, const std::type_identity_t<T>& a,
                std::type_identity_t<T> t = 0) {
  return rate_of_df_dv(detail::of_one(f), std::array{q}, {v}, {a}, t)[0];
}
template <class F, class T>
T lagrange_acceleration(const F& lagrangian, const T& q, const std::type_identity_t<T>& v,
                        std::type_identity_t<T> t = 0) {
  return lagrange_accelerations(detail::of_one(lagrangian), std::array{q}, {v}, {}, t)[0];
}

}  // namespace oddity
