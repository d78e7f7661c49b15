#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// What a reader without scripts sees of a quantity: its chart where it has one, and a table of the methods
/// that are worth seeing, as <noscript>.
std::string still_chart(const QuantityResult&);

}  // namespace oddity
