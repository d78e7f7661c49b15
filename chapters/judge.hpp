#pragma once

#include <vector>

#include "chapters/exercise.hpp"

/// The steps of judging a trial, for code that reads trials and recomputes their outcomes.
namespace oddity {

/// The last of `samples` equal parts.
Value last_of(const Value&, int samples);
/// The largest error; NaN if one is NaN.
double largest(const std::vector<double>& errors);
/// The outcome of an answer with this error.
Outcome judge(const Quantity&, const Answer&, double error, double in_needs);

}  // namespace oddity
