#pragma once

#include <string>
#include <vector>

#include "reference/errors.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// How far off an exercise's methods, breakdowns and wrong readings are, and how far off what is right may
/// be: each row that errors.csv has to have of it. An error of 1e-10 of what is computed is as good as none.
std::vector<ErrorsOnRecord> errors_of(const ExerciseResult&);

/// Whether a run has what is on record: errors within 2 %, evaluations exactly, save where the last bits
/// decide.
bool agree(const ErrorsOnRecord& run, const ErrorsOnRecord& on_record);

/// Whether the last bits decide all of it, even whether there is such a row.
bool is_left_to_last_bits(const ErrorsOnRecord&);

/// The row of errors.csv, without the line's end.
std::string text_of(const ErrorsOnRecord&);

/// The rows that put the exercise on record. One of `on_record` that agrees stays as it is; in one that does
/// not, what the last bits decide stays so.
std::vector<std::string> error_rows(const ExerciseResult&, const std::vector<ErrorsOnRecord>& on_record);

}  // namespace oddity
