#pragma once

#include "reference/make/recorded.hpp"

/// How far a motion is analytic, by Picard's operator in the complex plane.
namespace oddity::truth {

/// What the terms beyond an order may come to.
struct Limit {
  int order;
  double tolerance;
};

/// On the disc |t - t0| <= radius every motion that starts within `apart` of x0, in complex numbers too,
/// exists, is analytic, and keeps within reach[i] of x0[i]. So no coefficient of its series of the order k >
/// 0 is larger than reach/radius^k (Cauchy).
struct Disc {
  double radius = 0;
  std::vector<double> reach;

  /// The step after which all limits hold.
  double step(const std::vector<Limit>&) const;
  /// A bound on what the terms beyond the order come to after the step h.
  double remainder(std::size_t unknown, double h, int order) const;
};

/// The disc that allows the longest step; begins to look for it at the radius `guess`. Throws Undecided where
/// none is found.
Disc disc_about(const Recorded&, const Numbers& x0, const Number& t0, double apart,
                const std::vector<Limit>& limits, double guess);

}  // namespace oddity::truth
