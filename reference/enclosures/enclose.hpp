#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/reference.hpp"

/// The tables' routes in balls (Arb), which contain the exact number.
namespace oddity {

/// Bounds on the distance of the exact components at the inputs from these decimals, one each. Empty if the
/// table has no route that encloses them. Throws std::runtime_error if that route yields no balls of a radius
/// below 1e-20 of their size.
std::optional<std::vector<double>> distances_from_exact(std::string_view table,
                                                        const std::vector<double>& inputs,
                                                        const std::vector<std::string>& decimals);

/// Bounds for values computed on demand, to the requested digits; `tick` is called between times.
Enclosed enclosed_on_demand(const ToEnclose&, const std::function<void(double done)>& tick);

}  // namespace oddity
