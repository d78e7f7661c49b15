#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "chapters/kicks.hpp"
#include "chapters/scene.hpp"

namespace oddity {

template <std::size_t n>
struct KickedState {
  std::array<double, n> state;
  std::string_view why_none = {};  ///< empty: there is one
};

/// The state next to this one that is seen as the kicks have it, and that keeps the model's constraints as
/// they were.
template <std::size_t n>
KickedState<n> kicked(const ModelInterfaceOf<n>&, const std::array<double, n>& before, double t,
                      std::span<const Kick> at_once);

}  // namespace oddity
