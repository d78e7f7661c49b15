#pragma once

#include <string>

#include "report/study/results.hpp"

/// Formats of a trial's numbers.
namespace oddity {

/// "2.26011409", "(0.1, 0.2, 0.3)"; of more than four components, only the first four.
std::string shown(const Value&, int digits = 9);
/// "2.3e-14"; "0" for zero.
std::string shown_error(double error);
/// "12.3 us".
std::string shown_time(double seconds);
/// "step 0.001"; "-" for a method without a setting.
std::string shown_resolution(const TimedTrial&);

// Cells of a Markdown table.
std::string error_cell(double error);
std::string resolution_cell(const TimedTrial& t);
std::string value_cell(const Value& value, int digits);

}  // namespace oddity
