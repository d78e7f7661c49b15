#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reference/reference.hpp"

/// Motions by the two routes of their tables in long double, some hundred times as fast as with 60 digits.
namespace oddity {

/// Digits asked of both routes.
constexpr int digits_in_long_double = 14;

/// What bounds the error of a motion.
enum class BoundedBy {
  routes,   ///< what the two disagree by, their roundings included
  repeats,  ///< by how much the first parts from itself with other steps; as far as both tell one motion
};

/// As Reference::motion, `tick` called in between and the second route compared at so many of the times.
/// Nothing where the table has no such motion, or a route does not come to its end in these numbers.
std::optional<Known> motion_in_long_double(std::string_view table, const std::vector<double>& inputs_but_time,
                                           std::span<const double> times, std::size_t compared,
                                           const std::function<void(double)>& tick,
                                           BoundedBy = BoundedBy::routes);

}  // namespace oddity
