#pragma once

#include <array>
#include <cstddef>
#include <tuple>

namespace oddity::plain {

/// A state (q, v), split into its halves.
template <class State>
struct Halves {
  static constexpr std::size_t size = std::tuple_size_v<State> / 2;
  using Half = std::array<typename State::value_type, size>;
  Half q{}, v{};

  explicit Halves(const State& x) {
    for (std::size_t i = 0; i < size; ++i) q[i] = x[i], v[i] = x[size + i];
  }
  void put(State& x) const {
    for (std::size_t i = 0; i < size; ++i) x[i] = q[i], x[size + i] = v[i];
  }
};

}  // namespace oddity::plain
