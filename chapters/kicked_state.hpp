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

/// The nearest state with the observables that the kicks ask for, and the model's constraints as before.
template <std::size_t n>
KickedState<n> kicked(const ModelInterfaceOf<n>&, const std::array<double, n>& before, double t,
                      std::span<const Kick> at_once);

}  // namespace oddity
