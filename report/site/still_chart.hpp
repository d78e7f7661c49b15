#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// What a reader without scripts sees of a quantity: its chart where it has one, and a table of the methods
/// that are worth seeing, as <noscript>.
std::string still_chart(const QuantityResult&);
/// The same of a map: each method's letters at each value of the parameter.
std::string still_map(const Stability&);

}  // namespace oddity
