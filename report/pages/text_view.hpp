#pragma once

#include <string>

#include "report/study/results.hpp"
#include "report/text/screen.hpp"

namespace oddity {

/// An exercise's results as text for a terminal: claims with verdicts, then every trial of every quantity.
std::string text_view(const ExerciseResult&, const Screen& = {});
/// "Exercise 3.5: Pendulum from 30 degrees", as a heading.
std::string heading_of(const ExerciseResult&, const Screen&);
/// Colour of a verdict.
Style style_of(Verdict);
/// The outcome's name, coloured by how good it is.
std::string shown(Outcome, const Screen&);

/// A claim's text with a full stop at the end.
std::string as_sentence(std::string says);

/// Rounds decimal numbers of more than nine digits in a text to six.
std::string with_short_numbers(const std::string& text);

}  // namespace oddity
