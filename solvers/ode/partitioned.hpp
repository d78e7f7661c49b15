#pragma once

#include <array>
#include <utility>

#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode::detail {

/// The two halves of a state (q, v).
template <class State>
struct Halves {
  static constexpr std::size_t size = std::tuple_size_v<State> / 2;
  using Half = std::array<typename State::value_type, size>;
  Half q, v;

  // Copied number by number: std::copy moves them through integer registers, six cycles in the chain from
  // step to step.
  explicit Halves(const State& x) {
    for (std::size_t i = 0; i < size; ++i) q[i] = x[i], v[i] = x[size + i];
  }
  void put(State& x) const {
    for (std::size_t i = 0; i < size; ++i) x[i] = q[i], x[size + i] = v[i];
  }
};

}  // namespace oddity::ode::detail
