#pragma once

#include <span>

#include "report/study/held_steps.hpp"
#include "report/study/results.hpp"
#include "report/text/screen.hpp"
#include "report/text/table_text.hpp"

/// Limits of stability, next to the longest steps that meet a need, if there is one.
namespace oddity {

std::string stability_text(const ExerciseResult&, const HeldSteps&, const Screen& = {});
/// One entry per exercise; an empty span if nothing was asked.
Table limits_table(const Results&, std::span<const HeldSteps>);

}  // namespace oddity
