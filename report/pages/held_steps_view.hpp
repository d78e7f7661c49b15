#pragma once

#include <span>

#include "report/study/held_steps.hpp"
#include "report/study/results.hpp"
#include "report/text/screen.hpp"
#include "report/text/table_text.hpp"

/// Limits of stability next to the steps up to which each method meets what was asked, where something was.
namespace oddity {

std::string stability_text(const ExerciseResult&, const HeldSteps&, const Screen& = {});
/// Those of each exercise in turn; none: nothing was asked.
Table limits_table(const Results&, std::span<const HeldSteps>);

}  // namespace oddity
