#pragma once

#include <string>

#include "report/study/results.hpp"
#include "report/text/screen.hpp"

namespace oddity {

/// "0.625", "at least 2.5", "every step", "none".
std::string shown_step(const Limit&);
/// How a method breaks just above its limit, with numbers; empty if nothing breaks it.
std::string how_it_breaks(const Limit&, const Stability&);
/// A trial within the need where the method breaks, with numbers.
std::string shown_cure(const Limit&, const std::string& unit);
/// Tables and maps for a terminal.
std::string stability_text(const ExerciseResult&, const Screen& = {});
/// The report's page, and its file of a scene's map.
std::string stability_page(const Results&);
std::string map_file(const ExerciseResult&);

}  // namespace oddity
