#pragma once

#include "report/cli/bench.hpp"
#include "report/lanes/batch.hpp"

/// `oddity bench --lanes`: every model of every scene in lanes beside the same model alone.
namespace oddity {

/// One model by one algorithm on one kind of register, beside a single number, in turn with it.
struct LanesResult {
  std::string number, model, algorithm;
  Precision precision;
  lanes::Registers registers;
  std::size_t width;         ///< numbers in a register
  Spread alone, in_lanes;    ///< s a body a frame
  Spread share;              ///< of the width that the lanes are faster
  double at_least;           ///< of it
  std::size_t bodies, same;  ///< those with the same bits

  bool holds() const { return share.median - share.half_width >= at_least; }
  bool broken() const { return share.median + share.half_width < at_least || same < bodies; }
};

struct LanesBench {
  lanes::Registers taken;  ///< the widest of this machine
  std::vector<LanesResult> results;

  bool broken() const;
};

/// Of all scenes, or of those of these numbers.
LanesBench bench_lanes(const std::vector<std::string>& numbers = {}, int rounds = 11,
                       const Progress& progress = {});

std::string lanes_view(const LanesBench&, const Screen& = {});
Table lanes_table(const LanesBench&);

}  // namespace oddity
