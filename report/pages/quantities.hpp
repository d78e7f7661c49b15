#pragma once

#include <string>

#include "report/charts/chart.hpp"
#include "report/study/results.hpp"

/// Computed quantities, as Markdown.
namespace oddity {

/// A quantity's description, true value and need.
std::string quantity_head(const QuantityResult&);

/// A quantity: head, a chart if `charts`, the cheapest methods within the need, results in float, breakdowns.
std::string quantity_text(const ExerciseResult&, const QuantityResult&, bool charts);
/// Reasons why methods are expected to fail at their finest setting, folded up, one per line.
std::string expected_failures(const ExerciseResult&);

/// Links to all charts of the quantity.
std::string chart_links(const ExerciseResult&, const QuantityResult&);
/// A link to the picture of the motion.
std::string motion_link(const ExerciseResult&, const QuantityResult&);
/// A row per trial, with all values that the charts show.
std::string trials_table(const QuantityResult&);
/// Fitted power laws of the methods, and their ranges.
std::string fits_table(const QuantityResult&);

/// "charts/3.5_swing.svg", "charts/3.5_swing_time.svg", "charts/3.5_swing_over_step.svg".
std::string chart_file(const ExerciseResult&, const QuantityResult&, Across);
/// "charts/3.5_swing_motion.svg".
std::string trajectory_file(const ExerciseResult&, const QuantityResult&);
/// "charts/3.25_chain_of_10_series.svg", for the first of a series.
std::string series_file(const ExerciseResult&, const QuantityResult& first);

}  // namespace oddity
