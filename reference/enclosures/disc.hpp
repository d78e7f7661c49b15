#pragma once

#include "reference/make/recorded.hpp"

/// The disc on which a motion is analytic, by Picard's operator in the complex plane.
namespace oddity::truth {

/// Limit for the sum of the terms beyond an order.
struct Limit {
  int order;
  double tolerance;
};

/// On the disc |t - t0| <= radius every motion that starts within `apart` of x0, also in complex numbers,
/// exists, is analytic, and stays within reach[i] of x0[i]. So no coefficient of its series of order k > 0
/// exceeds reach/radius^k (Cauchy).
struct Disc {
  double radius = 0;
  std::vector<double> reach;

  /// The longest step that satisfies all limits.
  double step(const std::vector<Limit>&) const;
  /// A bound on the sum of the terms beyond the order after the step h.
  double remainder(std::size_t unknown, double h, int order) const;
};

/// The disc that allows the longest step; the search begins at the radius `guess`. Throws Undecided if it
/// finds none.
Disc disc_about(const Recorded&, const Numbers& x0, const Number& t0, double apart,
                const std::vector<Limit>& limits, double guess);

}  // namespace oddity::truth
