#pragma once

#include <cmath>
#include <span>

#include "chapters/energies.hpp"

/// Laws of a top whose axis is observed.
namespace oddity::heavy_top {

/// The energy without that of the spin, which no force changes.
template <class Parameters>
Energy energy(const Parameters& p, std::span<const double> x) {
  return energy_seen(p["mu1"] * half_square(x.subspan(3)), p["m"] * p["g"] * p["l"] * x[2]);
}

/// Deviation of the center of mass from the distance l to the tip.
template <class Parameters>
double off(const Parameters& p, std::span<const double> x, double) {
  return p["l"] * std::abs(std::hypot(x[0], x[1], x[2]) - 1);
}

}  // namespace oddity::heavy_top
