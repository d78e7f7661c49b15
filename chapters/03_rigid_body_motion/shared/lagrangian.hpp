#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "chapters/claims.hpp"
#include "chapters/lost_bar.hpp"
#include "solvers/dual.hpp"

/// One degree of freedom q with v = q', and formulas about it. A function f(q, v, t) is generic in its number
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

template <class Sample>
using Version = Formula<Sample>;

/// The same over 200 random samples, made by Sample(Random&); where() tells a sample's letters.
template <class Sample>
Check compare(std::string quantity, const Version<Sample>& left, const Version<Sample>& right, double seed) {
  return compare(std::move(quantity), left, right, draw<Sample>(200, seed));
}

/// The claim that `what` is as printed, judged by the version `truth`, with versions that must not be.
template <class Sample>
Claim formula_claim(std::string id, int line, const std::string& what, double seed,
                    const Version<Sample>& printed, const Version<Sample>& truth,
                    const std::vector<Version<Sample>>& near_misses) {
  Claim claim{std::move(id), line, what};
  claim.printed = {printed.text, {compare(what, printed, truth, seed)}};
  for (const Version<Sample>& near : near_misses)
    claim.near_misses.push_back({near.text, {compare(what, near, truth, seed)}});
  return claim;
}

/// A formula claim whose fraction bars the text at hand has lost. `says` states it as it stands.
template <class Sample>
void bars_lost(Claim& claim, std::string says, double seed, const Version<Sample>& as_it_stands,
               const Version<Sample>& truth, std::string why) {
  const std::string quantity = claim.printed.checks[0].quantity;
  claim = lost_bar(std::move(claim), {as_it_stands.text, {compare(quantity, as_it_stands, truth, seed)}},
                   std::move(why));
  claim.says = std::move(says);
}

}  // namespace oddity
