#pragma once

#include "solvers/dual.hpp"

/// Lagrange's equation of one degree of freedom q with v = q'. A function f(q, v, t) is generic in its number
/// type; its derivatives are taken by dual numbers.
namespace oddity {

template <class F>
double d_dq(const F& f, double q, double v, double t = 0) {
  return f(Dual<double>(q, 1), Dual<double>(v), Dual<double>(t)).slope;
}

template <class F>
double d_dv(const F& f, double q, double v, double t = 0) {
  return f(Dual<double>(q), Dual<double>(v, 1), Dual<double>(t)).slope;
}

/// d/dt of df/dv along a motion with q' = v, v' = a.
template <class F>
double momentum_rate(const F& f, double q, double v, double a, double t = 0) {
  using Along = Dual<double>;
  using Outer = Dual<Along>;
  return f(Outer(Along(q, v)), Outer(Along(v, a), Along(1)), Outer(Along(t, 1))).slope.slope;
}

/// v' by Lagrange's equation d/dt dL/dv = dL/dq.
template <class L>
double lagrange_acceleration(const L& lagrangian, double q, double v, double t = 0) {
  using Along = Dual<double>;
  using Outer = Dual<Along>;
  const double mass = lagrangian(Outer(Along(q)), Outer(Along(v, 1), Along(1)), Outer(Along(t))).slope.slope;
  return (d_dq(lagrangian, q, v, t) - momentum_rate(lagrangian, q, v, 0, t)) / mass;
}

}  // namespace oddity
