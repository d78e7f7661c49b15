#pragma once

#include <vector>

#include "chapters/exercise.hpp"

/// How a trial is judged, step by step: for what reads trials and computes their outcomes again.
namespace oddity {

/// The last of `samples` equal parts.
Value last_of(const Value&, int samples);
/// The largest error; NaN when one is NaN.
double largest(const std::vector<double>& errors);
/// How an answer of this error ended.
Outcome judge(const Quantity&, const Answer&, double error, double in_needs);

}  // namespace oddity
