#pragma once

#include "chapters/exercise.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// The method at one setting, over five batches each as long as a tenth of a millisecond or one run, or three
/// of more than a millisecond; a run of more than `once_from` seconds is timed once, and has no spread. To
/// mean anything it has to run alone.
Time time(const Method&, double setting, double once_from = 0.01);

/// s, what a call of a right-hand side takes through the seam between algorithms and models, which are
/// compiled apart: one that computes nothing, over batches of a hundred thousand. What the compiler could
/// have saved by seeing both at once comes on top (`oddity bench`).
double seam();

}  // namespace oddity
