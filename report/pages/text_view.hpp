#pragma once

#include <string>

#include "report/pages/screen.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// An exercise's results as text for a terminal: claims with verdicts, then every trial of every quantity.
std::string text_view(const ExerciseResult&, const Screen& = {});
/// "Exercise 3.5: Pendulum from 30 degrees", as a heading.
std::string heading_of(const ExerciseResult&, const Screen&);
/// The outcome's name, in the colour of how good it is.
std::string shown(Outcome, const Screen&);

/// "2.26011409398565", "(0.1, 0.2, 0.3)", long values cut short.
std::string shown(const Value&, int digits = 9);
/// Decimal numbers of more than nine digits within a text, each rounded to six.
std::string with_short_numbers(const std::string& text);
/// "2.3e-14"; "0" for zero.
std::string shown_error(double error);
/// "12.3 us".
std::string shown_time(double seconds);
/// "step 0.001", "no knob".
std::string shown_knob(const TimedTrial&);

}  // namespace oddity
