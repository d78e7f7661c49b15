#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "reference/reference.hpp"

/// Motions by the two routes of their tables in long double, some hundred times as fast as with 60 digits,
/// and in double, another five times as fast.
namespace oddity {

/// Digits requested from both routes.
constexpr int digits_in_long_double = 14, digits_in_double = 8;

/// Source of a motion's error bound.
enum class BoundedBy {
  routes,   ///< the routes' disagreement, including their roundings
  repeats,  ///< the first route's spread over other steps, for times at which both routes agree on the motion
};

/// Like Reference::motion, with calls of `tick` in between and the second route compared at `compared` of the
/// times. Empty if the table has no such motion, or a route fails in these numbers.
std::optional<Known> motion_in_long_double(std::string_view table, const std::vector<double>& inputs_but_time,
                                           std::span<const double> times, std::size_t compared,
                                           const std::function<void(double)>& tick,
                                           BoundedBy = BoundedBy::routes);
/// As `motion_in_long_double`, in double.
std::optional<Known> motion_in_double(std::string_view table, const std::vector<double>& inputs_but_time,
                                      std::span<const double> times, std::size_t compared,
                                      const std::function<void(double)>& tick, BoundedBy = BoundedBy::routes);

}  // namespace oddity
