#pragma once

#include "chapters/exercise.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// Times the method at one setting, over five batches each as long as a tenth of a millisecond or one run, or
/// three of more than a millisecond. A run of more than `once_from` seconds is timed once, without a spread.
/// Nothing else may run meanwhile.
Time time(const Method&, double setting, double once_from = 0.01);

/// s, time of a call of a right-hand side through the type-erased interface between algorithms and models,
/// which are compiled apart. Measured with one that computes nothing, over batches of a hundred thousand.
/// Excludes optimizations that the compiler could do if it saw both (`oddity bench`).
double seam();

}  // namespace oddity
