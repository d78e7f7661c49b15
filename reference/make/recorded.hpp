#pragma once

#include <vector>

#include "reference/make/tape.hpp"

namespace oddity::truth {

/// A right-hand side on its tape, and the nodes of its unknowns, their derivatives and the time.
struct Recorded {
  Tape tape;
  std::vector<int> unknowns, derivatives;
  int time = -1;

  /// rhs(x, t) returns the derivatives of x.
  template <class Rhs>
  void record(const Rhs& rhs, std::size_t dimension) {
    std::vector<Jet> x;
    for (std::size_t i = 0; i < dimension; ++i) x.push_back(variable());
    const Jet t = variable();
    const std::vector<Jet> dxdt = rhs(x, t);
    for (std::size_t i = 0; i < dimension; ++i) {
      unknowns.push_back(x[i].node);
      derivatives.push_back(dxdt[i].node);
    }
    time = t.node;
  }
  Jet variable() { return {&tape, tape.put({Tape::Op::variable})}; }
  /// Fills the tape with the series about (x, t) up to the order.
  void expand(const Numbers& x, const Number& t, int order);
  /// The unknowns' series.
  std::vector<Numbers> series() const;
};

}  // namespace oddity::truth
