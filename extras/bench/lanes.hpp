#pragma once

#include "extras/bench/bench.hpp"
#include "extras/lanes/batch.hpp"

/// `oddity bench --lanes`: every model of every scene in lanes beside the same model alone.
namespace oddity {

/// What a register's arithmetic does at most, by operations that do not wait for each other.
struct ArithmeticResult {
  lanes::Registers registers;
  Precision precision;
  std::size_t width;
  /// How many numbers at once, where a single number's operation takes as long as it takes here: the width,
  /// or less, where an instruction on the whole register takes longer.
  Spread at_once[lanes::arithmetic_count];

  /// The most of all operations, as a share of the width; no more than 1.
  double ceiling() const;
};

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
  double ceiling = 1;        ///< the share of the width that the machine's arithmetic has

  bool holds() const { return share.median - share.half_width >= at_least; }
  /// Not of the width, but of the numbers that the machine's arithmetic has at once.
  bool holds_of_arithmetic() const { return share.median - share.half_width >= at_least * ceiling; }
  /// Of AVX2 and what is wider. A register of two doubles, as every processor has it, is measured beside
  /// them.
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

/// Of all scenes, or of those of these numbers.
LanesBench bench_lanes(const std::vector<std::string>& numbers = {}, int rounds = 11,
                       const Progress& progress = {});

std::string lanes_view(const LanesBench&, const Screen& = {});
Table lanes_table(const LanesBench&);

}  // namespace oddity
