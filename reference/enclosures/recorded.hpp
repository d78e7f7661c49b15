#pragma once

#include "reference/make/tape.hpp"

namespace oddity::truth {

/// A right-hand side on its tape, and the nodes of its unknowns, of their derivatives and of the time.
struct Recorded {
  Tape tape;
  std::vector<int> unknowns, derivatives;
  int time = -1;

  Jet variable() { return {&tape, tape.put({Tape::Op::variable})}; }
  /// Fills the tape with the series about (x, t) up to the order.
  void expand(const Numbers& x, const Number& t, int order);
  /// The unknowns' series.
  std::vector<Numbers> series() const;
};

}  // namespace oddity::truth
