#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode::detail {

/// A state (q, v) in its two halves.
template <class State>
struct Halves {
  static constexpr std::size_t size = std::tuple_size_v<State> / 2;
  using Half = std::array<typename State::value_type, size>;
  Half q, v;

  explicit Halves(const State& x) {
    std::copy_n(x.begin(), size, q.begin());
    std::copy_n(x.begin() + size, size, v.begin());
  }
  void put(State& x) const {
    std::copy_n(q.begin(), size, x.begin());
    std::copy_n(v.begin(), size, x.begin() + size);
  }
};

}  // namespace oddity::ode::detail
