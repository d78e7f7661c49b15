#pragma once

#include <string>

#include "report/charts/chart.hpp"
#include "report/study/results.hpp"

/// What is computed, as Markdown.
namespace oddity {

/// What a quantity is, its true value and how well it is needed.
std::string quantity_head(const QuantityResult&);

/// A quantity: its head, one chart if it is to have any, the cheapest methods within the need, what float
/// makes of it, and where it breaks.
std::string quantity_text(const ExerciseResult&, const QuantityResult&, bool charts);
/// Why methods are expected to fail at their finest setting, folded up: a line a reason.
std::string expected_failures(const ExerciseResult&);

/// Links to the charts by evaluations or setting, and by time.
std::string chart_links(const ExerciseResult&, const QuantityResult&);
/// A link to the drawn motion of a scene.
std::string motion_link(const ExerciseResult&, const QuantityResult&);
/// Every trial with all that the charts show of it.
std::string trials_table(const QuantityResult&);
/// The power laws that methods follow, and where.
std::string fits_table(const QuantityResult&);

/// "charts/3.5_swing.svg", "charts/3.5_swing_time.svg", "charts/3.5_swing_over_step.svg".
std::string chart_file(const ExerciseResult&, const QuantityResult&, Across);
/// "charts/3.5_swing_motion.svg".
std::string trajectory_file(const ExerciseResult&, const QuantityResult&);
/// "charts/3.25_chain_of_10_series.svg", for the first of a series.
std::string series_file(const ExerciseResult&, const QuantityResult& first);

}  // namespace oddity
