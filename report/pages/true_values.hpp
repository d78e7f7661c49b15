#pragma once

#include <string>

#include "report/study/trust.hpp"

namespace oddity {

/// What bounds the errors of the reference tables, in Markdown: how many values are enclosed, and how
/// narrowly, and which are not. Empty where there are no tables.
std::string true_values(const Bounds&);

}  // namespace oddity
