#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// A quantity for readers without scripts, as <noscript>: its chart, if it has one, and a table of the
/// methods worth showing.
std::string still_chart(const QuantityResult&);
/// A map for readers without scripts: each method's letters at each value of the parameter.
std::string still_map(const Stability&);

}  // namespace oddity
