#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "reference/limits.hpp"
#include "report/pages/screen.hpp"
#include "report/study/run.hpp"

/// Where methods of fixed step break: the first step, from below, at which small disturbances of the motion
/// grow that do not grow in truth, measured beside linear theory; how each method breaks beyond it, and what
/// cures it; and a map of outcomes over the step and over the parameter that makes the scene hard.
namespace oddity {

/// The first loss of stability from below: steps are tried one after the other, each 3 % longer than the
/// last, from a quarter of theory's limit (or the finest that is told from none) to the longest, which is
/// `interval` [s], the time between two looks at the motion, or what the measurement allows. Beside it the
/// trials at and beyond the limit, whose steps divide the interval, and the largest step within the
/// quantity's need, both at the times of its reference. No cure is looked for.
Limit limit_of(const Quantity&, const Method&, double interval);

/// The same without any trial.
Limit measured_limit(const Method&, double interval, const ode::Criteria& = {});

/// The results with the stability of every task that has a scene, computed in parallel: the limits at the
/// task's parameters, the map at those with the scene's parameter varied. Does not depend on the number of
/// threads.
Results with_stability(Results, std::span<const Task>, const Reference&, const Progress& progress = {});

/// Whether the method of a map's row ends so at the map's step `k` where the start differs by a few
/// roundings: then the last bits decide, in which one machine's sines differ from another's.
bool ends_so_within_roundings(const Task&, const MapRow&, std::size_t k, Outcome, const Reference&);

// ---- as text ----------------------------------------------------------------------------------------------

/// The reason of a limit that differs from theory's for none of the reasons that are computed.
inline constexpr std::string_view not_explained = "not explained";
/// The outcomes in the order of a map's legend.
inline constexpr std::array outcomes_of_a_map{
    Outcome::ok,      Outcome::inaccurate, Outcome::drifted, Outcome::diverged,   Outcome::non_finite,
    Outcome::stalled, Outcome::deceived,   Outcome::raised,  Outcome::chattering, Outcome::grazing};
/// An outcome's letter on a map.
char letter_of(Outcome);
/// The outcome of a letter; nothing where it is none.
std::optional<Outcome> outcome_of(char letter);
/// The letters of a row's outcomes, from the coarsest step to the finest.
std::string letters(const MapRow&);
/// "..*.........": a star for each of a row's outcomes that a few roundings at the start decide; empty: none.
std::string fragile_cells(const MapRow&);
/// "0.625", "at least 2.5", "every step", "none".
std::string shown_step(const Limit&);
/// "0.464 to 0.555, from 0.882 on".
std::string shown_tongues(const Limit&);
/// How a method breaks just above its limit, with its numbers; empty when nothing breaks it.
std::string how_it_breaks(const Limit&, const Stability&);
/// What is within the need where the method breaks, with its numbers.
std::string shown_cure(const Limit&, const std::string& unit);
/// How the motion ends just above the limit, or "stable" when nothing breaks the method.
std::string beyond(const Limit&);
/// The measured limit over theory's: 1 where both are zero or infinite, or where theory's lies above the
/// longest step tried and all are stable; 0 or infinity where only one of them is.
double agreement(const Limit&);

/// Tables and maps for a terminal.
std::string stability_text(const ExerciseResult&, const Screen& = {});
/// The rows of limits.csv, and of stability_maps.csv, that would put these results on record.
std::string limit_rows(const Results&);
std::string limit_row(const ExerciseResult&, const Limit&);
std::string map_rows(const Results&);
std::string map_row(const ExerciseResult&, const MapRow&);

/// The report's page, and the file of a scene's map in it.
std::string stability_page(const Results&);
std::string map_file(const ExerciseResult&);
std::string map_title(const ExerciseResult&);
/// A scene's map as SVG text: one panel per method, the scene's parameter across, the step upwards, outcomes
/// by colour and letter, theory's limit as a line.
std::string map_svg(const ExerciseResult&);
/// What the map says, in a sentence for its title.
std::string map_finding(const ExerciseResult&);

}  // namespace oddity
