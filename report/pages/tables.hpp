#pragma once

#include <span>

#include "reference/verdicts.hpp"
#include "report/study/run.hpp"
#include "report/text/table_text.hpp"

/// What the program finds, as tables for other programs.
namespace oddity {

/// A row for each parameter; one without a name where an exercise has none.
Table parameters_table(std::span<const Task>);
/// A row for each claim, with its verdict on record.
Table claims_table(const Results&, const Verdicts& on_record);
/// A row for each trial of each method, in double and in float. A value of several components is a text with
/// blanks between them.
Table trials_table(const Results&);
/// A row for each method of fixed step, of exercises with a motion.
Table limits_table(const Results&);

}  // namespace oddity
