#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/charts/chart_style.hpp"
#include "report/study/fit.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// What a chart shows the error against.
enum class Across { evaluations, time, setting };

/// A chart is drawn where the errors of some method's trials tell a story: not of answers that are right or
/// wrong, nor where each method has one point. Those stand in a table.
bool has_chart(const QuantityResult&);
/// The charts of a quantity: against evaluations and time where the work of most methods depends on their
/// setting, else against the setting; and for a scene's motion against the step as well, where methods of
/// fixed step have their optimum.
std::vector<Across> charts_of(const QuantityResult&);

/// A gnuplot script that draws the error against evaluations (a work-precision diagram), against time with
/// its spread, or against the setting that most methods have, as SVG into `file`. Models by colour,
/// algorithms by mark, fitted orders in the legend; the Pareto front; each failure under its letter, those
/// without a number in a strip above the frame. Of more than eight methods, those on the front and the best
/// of each model and of each family of algorithms are drawn in colour. Holds times only when drawn against
/// them.
std::string chart_script(const QuantityResult&, const std::string& title, Across,
                         const std::filesystem::path& file, const Styles&);

/// What a chart says, in a sentence for its title.
std::string finding(const QuantityResult&, Across);

/// The quantities of one kind at growing sizes, "chain_of_10" and "chain_of_100", when there are three or
/// more and none has a chart; each list starts with the smallest.
std::vector<std::vector<const QuantityResult*>> series_of(const ExerciseResult&);
/// A gnuplot script that draws the evaluations of each method over the size.
std::string series_script(const std::vector<const QuantityResult*>&, const std::string& title,
                          const std::filesystem::path& file, const Styles&);

/// A gnuplot script that draws the motion of a quantity that has a trajectory: its observables over time, or
/// "x" and "y" as a path; the true motion with the reference on it, and what each model makes of it. Of more
/// than six observables, the largest distance from the true motion over time.
std::string trajectory_script(const QuantityResult&, const std::string& title,
                              const std::filesystem::path& file, const Styles&);
/// How many models a game could use, in a sentence for the title.
std::string motion_finding(const QuantityResult&);

}  // namespace oddity
