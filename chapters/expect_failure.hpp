#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "chapters/exercise.hpp"

namespace oddity {

/// Sets the expected outcome at the finest setting, and its reason, of the method with this model and
/// algorithm. For a single method of a group, such as SceneMethods::by_engine_integrators adds. Throws
/// std::logic_error if there is no such method.
inline void expect_failure(Quantity& quantity, std::string_view model, std::string_view algorithm,
                           Outcome expected, std::string why) {
  const auto found = std::ranges::find_if(
      quantity.methods, [&](const Method& m) { return m.model == model && m.algorithm == algorithm; });
  if (found == quantity.methods.end())
    throw std::logic_error(quantity.name + " has no method '" + std::string(model) + ", " +
                           std::string(algorithm) + "' that could be expected to fail");
  found->expected = expected;
  found->why = std::move(why);
}

}  // namespace oddity
