#pragma once

#include <string>

#include "report/study/results.hpp"

/// How a trial's numbers are written.
namespace oddity {

/// "2.26011409398565", "(0.1, 0.2, 0.3)", long values cut short.
std::string shown(const Value&, int digits = 9);
/// "2.3e-14"; "0" for zero.
std::string shown_error(double error);
/// "12.3 us".
std::string shown_time(double seconds);
/// "step 0.001", "no knob".
std::string shown_knob(const TimedTrial&);

// As cells of a table in Markdown.
std::string error_cell(double error);
std::string knob_cell(const TimedTrial& t);
std::string value_cell(const Value& value, int digits);

}  // namespace oddity
