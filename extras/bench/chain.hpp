#pragma once

#include <vector>

#include "report/study/run.hpp"

/// Chains of up to 10,000 links: cost of their accelerations by the rods' tensions and by the dense matrix.
/// Also the largest stable step of Runge-Kutta 4, next to the theoretical one.
namespace oddity {

/// A chain with this number of links.
struct ChainResult {
  int links;
  double tensions, dense;  ///< s, of the accelerations; NaN: not timed
  double bytes;            ///< held by the accelerations from the tensions
  double stable, theory;   ///< s, the largest step; links of 1 m, g = 9.81 m/s^2
};

struct ChainBench {
  std::vector<ChainResult> chains;
  std::vector<double> slopes;  ///< slope of log(time) by the tensions over log(links), for each round
};

ChainBench bench_chains(const Progress& progress = {});

}  // namespace oddity
