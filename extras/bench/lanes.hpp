#pragma once

#include "extras/bench/bench.hpp"
#include "extras/lanes/batch.hpp"

/// `oddity bench --lanes`: every model of every scene in lanes compared with the same model alone.
namespace oddity {

/// Peak arithmetic of a register, measured with operations that do not wait for each other.
struct ArithmeticResult {
  lanes::Registers registers;
  Precision precision;
  std::size_t width;
  /// Numbers computed at once, in the time of a single number's operation: the width, or less where an
  /// instruction on the whole register takes longer.
  Spread at_once[lanes::arithmetic_count];

  /// The largest of all operations, as a share of the width; at most 1.
  double ceiling() const;
};

/// One model by one algorithm on one kind of register, timed in turn with a single number.
struct LanesResult {
  std::string number, model, algorithm;
  Precision precision;
  lanes::Registers registers;
  std::size_t width;         ///< numbers in a register
  Spread alone, in_lanes;    ///< s a body a frame
  Spread share;              ///< speed-up of the lanes as a share of the width
  double at_least;           ///< required share
  std::size_t bodies, same;  ///< bodies whose results have the same bits as alone: `same`
  double ceiling = 1;        ///< peak of the machine's arithmetic, as a share of the width

  bool holds() const { return share.median - share.half_width >= at_least; }
  /// Relative to the numbers that the machine computes at once, instead of the width.
  bool holds_of_arithmetic() const { return share.median - share.half_width >= at_least * ceiling; }
  /// The limit is for AVX2 and wider. Registers of two doubles, which every processor has, are measured for
  /// comparison.
  bool is_asked() const { return registers >= lanes::Registers::avx2; }
  bool broken() const {
    return same < bodies || (is_asked() && share.median + share.half_width < at_least * ceiling);
  }
};

struct LanesBench {
  lanes::Registers taken;  ///< the widest of this machine
  std::vector<LanesResult> results;
  std::vector<ArithmeticResult> arithmetic = {};

  bool broken() const;
};

/// Runs all scenes, or those with these numbers.
LanesBench bench_lanes(const std::vector<std::string>& numbers = {}, int rounds = 11,
                       const Progress& progress = {});

std::string lanes_view(const LanesBench&, const Screen& = {});
Table lanes_table(const LanesBench&);

}  // namespace oddity
