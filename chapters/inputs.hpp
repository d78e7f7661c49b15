#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "chapters/exercise.hpp"

/// User's points and matrices as parameters of an exercise. Each number has a name, such as "v0x". The
/// command line can also set all those with the same beginning at once: v0=1,2,-1.
namespace oddity {

/// Parameters that differ only in name and value, each from -size to size.
template <std::size_t n>
constexpr std::array<Parameter, n> numbers(const std::array<std::string_view, n>& names,
                                           const std::array<double, n>& values, std::string_view unit,
                                           std::string_view says, double size) {
  std::array<Parameter, n> all{};
  for (std::size_t i = 0; i < n; ++i) all[i] = {names[i], values[i], unit, says, -size, size};
  return all;
}

/// Concatenates lists of parameters.
template <std::size_t... n>
constexpr auto together(const std::array<Parameter, n>&... parts) {
  std::array<Parameter, (n + ...)> all{};
  std::size_t i = 0;
  const auto add = [&](const auto& part) {
    for (const Parameter& p : part) all[i++] = p;
  };
  (add(parts), ...);
  return all;
}

/// The values of the parameters prefix + "x", "y" and "z".
inline std::array<double, 3> point_of(const Parameters& p, const std::string& prefix) {
  return {p[prefix + "x"], p[prefix + "y"], p[prefix + "z"]};
}

}  // namespace oddity
