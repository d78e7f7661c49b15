#pragma once

#include <string>
#include <vector>

#include "chapters/03_rigid_body_motion/35_moving_tip/models.hpp"
#include "chapters/exercise.hpp"

/// Exercise 3.35's methods and claims.
namespace oddity::ex03_35 {

using Top = heavy_top::Top<double>;

Quantity axis(const Top&, const Horizon&, const Reference&);
std::vector<Quantity> quantities(const Top&, const Reference&);

/// The frequency at which the axis of a top on a fixed tip nutates about its steady precession, relative to
/// the world, to within 1/64. The frequency of the axis' height if the top cannot precess steadily at its
/// tilt.
double nutation_frequency(const Top&);
/// "at about the frequency of nutation and precession together": names that frequency.
std::string at_nutation(const Top&);

/// The largest angle within ex03_33::duration between the top's axis and that of the same top with its tip
/// fixed. NaN if one of the two motions does not reach its end.
struct Deviation {
  double as_asked, twice_the_frequency, at_nutation;

  explicit Deviation(const Top&);
};

std::vector<Claim> claims(double seed, const Top&, const Deviation&);
Provables proofs();
std::vector<Root> roots(const Top&, const Deviation&);

}  // namespace oddity::ex03_35
