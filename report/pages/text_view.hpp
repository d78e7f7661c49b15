#pragma once

#include <string>

#include "report/study/results.hpp"
#include "report/text/screen.hpp"

namespace oddity {

/// An exercise's results as text for a terminal: claims with verdicts, then every trial of every quantity.
std::string text_view(const ExerciseResult&, const Screen& = {});
/// "Exercise 3.5: Pendulum from 30 degrees", as a heading.
std::string heading_of(const ExerciseResult&, const Screen&);
/// How a verdict is shown.
Style style_of(Verdict);
/// The outcome's name, in the colour of how good it is.
std::string shown(Outcome, const Screen&);

/// A claim's words as a sentence: with a full stop, unless they end in one.
std::string as_sentence(std::string says);

/// Decimal numbers of more than nine digits within a text, each rounded to six.
std::string with_short_numbers(const std::string& text);

}  // namespace oddity
