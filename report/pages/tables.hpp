#pragma once

#include <span>

#include "reference/verdicts.hpp"
#include "report/study/run.hpp"
#include "report/text/table_text.hpp"

/// Results as tables for other programs.
namespace oddity {

/// A row per parameter; for an exercise without parameters, one row without a name.
Table parameters_table(std::span<const Task>);
/// A row per claim, with its approved verdict.
Table claims_table(const Results&, const Verdicts& on_record);
/// A row per trial, in double and in float. Components of a value are separated by blanks.
Table trials_table(const Results&);
/// A row per method of fixed step, for exercises with a motion.
Table limits_table(const Results&);

}  // namespace oddity
