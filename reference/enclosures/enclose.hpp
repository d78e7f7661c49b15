#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/reference.hpp"

/// The tables' routes in balls (Arb), which hold the exact number.
namespace oddity {

/// How far the exact components at the inputs may be from these decimals: a bound each. Nothing where the
/// table says no route that encloses them. Throws std::runtime_error where that route does not come to balls
/// of a radius below 1e-20 of their size.
std::optional<std::vector<double>> distances_from_exact(std::string_view table,
                                                        const std::vector<double>& inputs,
                                                        const std::vector<std::string>& decimals);

/// The same of values made on the spot, to the digits asked for; `tick` is called between times.
Enclosed enclosed_on_demand(const ToEnclose&, const std::function<void(double done)>& tick);

}  // namespace oddity
