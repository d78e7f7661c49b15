#pragma once

#include "chapters/exercise.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// The method at one setting, over batches each as long as a tenth of a millisecond or one run; a run of more
/// than `once_from` seconds is timed once, and has no spread. To mean anything it has to run alone.
Time time(const Method&, double setting, double once_from = 0.05);

}  // namespace oddity
