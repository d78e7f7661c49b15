#pragma once

#include <array>
#include <span>
#include <string>

#include "reference/limits.hpp"
#include "report/run.hpp"

/// Where methods of fixed step break: the largest stable step by bisection, beside the limit that linear
/// theory gives; how each breaks beyond it, and what cures it; and a map of outcomes over the step and over
/// the parameter that makes the scene hard.
namespace oddity {

/// A run is stable when it reaches its end and stays finite, its error is at most ten times the size of the
/// true motion, and a conserved quantity has changed by no more than itself.
bool stable(const Trial&);

/// The largest stable step of a method of fixed step. Each of the quantity's sample intervals, `interval` [s]
/// long, is cut into 1, 2, 3, 5, 8, ... steps, on to 4,096 steps in all and to a quarter of theory's limit; a
/// method that is still not stable is followed to 262,144 steps or 200,000 evaluations. The step is then
/// bisected to 1 % between the finest cut that is not stable and the next finer one, so that every finer step
/// tried is stable. No cure is looked for.
Limit limit_of(const Quantity&, const Method&, double interval);

/// The results with the stability of every task that has a scene, computed in parallel: the limits at the
/// task's parameters, the map at those with the scene's parameter varied. The reasons for differences between
/// theory and measurement are taken from those on record. Does not depend on the number of threads.
Results with_stability(Results, std::span<const Task>, const Reference&, const Limits& on_record,
                       const Progress& progress = {});

// ---- as text ----------------------------------------------------------------------------------------------

/// The outcomes in the order of a map's legend.
inline constexpr std::array outcomes_of_a_map{Outcome::ok,       Outcome::inaccurate, Outcome::drifted,
                                              Outcome::diverged, Outcome::non_finite, Outcome::stalled,
                                              Outcome::deceived, Outcome::raised};
/// An outcome's letter on a map.
char letter_of(Outcome);
/// The letters of a row's outcomes, from the coarsest step to the finest.
std::string letters(const MapRow&);
/// "0.625", "at least 2.5", "none above 0.0001".
std::string shown_step(const Limit&);
/// How a method breaks at the step just above its limit, with its numbers; empty when nothing breaks it.
std::string how_it_breaks(const Limit&, const std::string& unit);
/// What is close enough where the method breaks, with its numbers.
std::string shown_cure(const Limit&, const std::string& unit);
/// The outcome just above the limit, or "stable" when nothing breaks the method.
std::string beyond(const Limit&);
/// The quotient of the measured and the theoretical limit that is nearest to 1 within the bisected bracket;
/// NaN when one of them is not finite and positive and the other is.
double agreement(const Limit&);

/// Tables and maps for a terminal.
std::string stability_text(const ExerciseResult&);
/// The rows of limits.csv, and of stability_maps.csv, that would put these results on record.
std::string limit_rows(const Results&);
std::string limit_row(const ExerciseResult&, const Limit&);
std::string map_rows(const Results&);
std::string map_row(const ExerciseResult&, const MapRow&);

/// The report's page, and the file of a scene's map in it.
std::string stability_page(const Results&);
std::string map_file(const ExerciseResult&);
std::string map_title(const ExerciseResult&);
/// A gnuplot script that draws a scene's map as SVG into `file`: one panel per method, the scene's parameter
/// across, the step upwards, outcomes by colour and letter, theory's limit as a line.
std::string map_script(const ExerciseResult&, const std::string& file);

}  // namespace oddity
