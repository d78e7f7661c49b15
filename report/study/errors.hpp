#pragma once

#include <string>
#include <vector>

#include "reference/errors.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// Errors of an exercise's methods, breakdowns and wrong readings, and tolerances of its correct ones: every
/// row that errors.csv must have for it. An error below 1e-10 of the computed value counts as none.
std::vector<ErrorsOnRecord> errors_of(const ExerciseResult&);

/// Whether a run matches the approved row: errors within 2 %, evaluations exactly, unless the last bits
/// decide.
bool agree(const ErrorsOnRecord& run, const ErrorsOnRecord& on_record);

/// Whether the last bits decide the whole row, and even whether it exists.
bool is_left_to_last_bits(const ErrorsOnRecord&);

/// The row of errors.csv, without the line's end.
std::string text_of(const ErrorsOnRecord&);

/// The rows that approve the exercise. A row of `on_record` that agrees stays as it is; one that does not
/// keeps its values where the last bits decide.
std::vector<std::string> error_rows(const ExerciseResult&, const std::vector<ErrorsOnRecord>& on_record);

}  // namespace oddity
