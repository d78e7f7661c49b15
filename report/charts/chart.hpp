#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "report/charts/chart_style.hpp"
#include "report/study/fit.hpp"
#include "report/study/results.hpp"

/// Charts as SVG text, each a function of the results alone.
namespace oddity {

/// What a chart shows the error against.
enum class Across { evaluations, time, setting };

/// Which methods a chart shows: at most eight, or all of them.
enum class Curves { few, all };

/// A chart is drawn where the errors of some method's trials tell a story: not of answers that are right or
/// wrong, nor where each method has one point. Those stand in a table.
bool has_chart(const QuantityResult&);
/// The charts of a quantity: against evaluations and time where the work of most methods depends on their
/// setting, else against the setting; and for a scene's motion against the step as well, where methods of
/// fixed step have their optimum.
std::vector<Across> charts_of(const QuantityResult&);

/// The places of the methods that are worth seeing, in the quantity's order: all where there are at most
/// eight, else some of the Pareto front, the best of each model and the best of each family of algorithms,
/// in this order as far as there is room for eight.
std::vector<std::size_t> worth_seeing(const QuantityResult&, Across);

/// The error against evaluations (a work-precision diagram), against time with its spread, or against the
/// setting that most methods have. The names stand at the ends of the curves, with fitted orders; what is
/// within the need is shaded, and the Pareto front lies broad beneath the curves. A trial that is ok has a
/// full mark, another an open one, with the letter of its failure. Holds times only when drawn against them:
/// then a line shows for a scene what of them is the seam's, where a call through it takes `seam` [s].
std::string chart_svg(const QuantityResult&, const std::string& title, Across, Curves = Curves::few,
                      double seam = std::numeric_limits<double>::quiet_NaN());

/// What a chart says, in a sentence for its title.
std::string finding(const QuantityResult&, Across);

/// The cheapest trial that is ok, or else the most accurate one.
const TimedTrial& best_of(const MethodResult&, Cost);
/// Whether the first is to be preferred so.
bool preferable(const TimedTrial&, const TimedTrial&, Cost);

/// The quantities of one kind at growing sizes, "chain_of_10" and "chain_of_100", when there are three or
/// more and none has a chart; each list starts with the smallest.
std::vector<std::vector<const QuantityResult*>> series_of(const ExerciseResult&);
/// The evaluations of each method over the size.
std::string series_svg(const std::vector<const QuantityResult*>&, const std::string& title);
std::string series_finding(const std::vector<const QuantityResult*>&);

/// The motion of a quantity that has a trajectory: its observables over time, or "x" and "y" as a path; the
/// true motion with the reference on it, and what each model makes of it. Of more than six observables, the
/// largest distance from the true motion over time.
std::string trajectory_svg(const QuantityResult&, const std::string& title);
/// How many models a game could use, in a sentence for the title.
std::string motion_finding(const QuantityResult&);

}  // namespace oddity
