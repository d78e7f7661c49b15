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

/// The abscissa of a chart of errors.
enum class Across { evaluations, time, setting };

/// Which methods a chart shows: at most eight, or all of them.
enum class Curves { few, all };

/// Whether errors are worth a chart. If answers are just right or wrong, or each method has few points, a
/// table is enough.
bool has_chart(const QuantityResult&);
/// The charts of a quantity. If the work of most methods depends on their setting, they are against
/// evaluations and time, otherwise against the setting. A scene's motion has one against the step as well,
/// where methods of fixed step have their optimum.
std::vector<Across> charts_of(const QuantityResult&);

/// Indices of the methods to draw, in the quantity's order: all if there are at most eight. Otherwise eight
/// at most of these: some of the Pareto front, the best of each model, the best of each family of algorithms.
std::vector<std::size_t> worth_seeing(const QuantityResult&, Across);

/// The error against evaluations (a work-precision diagram), against time with its spread, or against the
/// setting that most methods have. Names and fitted orders are at the ends of the curves. Errors within the
/// need are shaded, and the Pareto front is a broad line beneath the curves. A trial that is ok has a full
/// mark; others have an open one, with the letter of the failure. Only charts against time contain times. For
/// a scene these also show the time of the type-erased calls alone, if one call takes `seam` [s].
std::string chart_svg(const QuantityResult&, const std::string& title, Across, Curves = Curves::few,
                      double seam = std::numeric_limits<double>::quiet_NaN());

/// A chart's finding, in a sentence for its title.
std::string finding(const QuantityResult&, Across);

/// The cheapest trial that is ok, or else the most accurate one.
const TimedTrial& best_of(const MethodResult&, Cost);
/// Whether best_of() prefers the first to the second.
bool preferable(const TimedTrial&, const TimedTrial&, Cost);

/// Quantities of one kind at growing sizes, such as "chain_of_10" and "chain_of_100", if there are at least
/// three and none has a chart. Each list starts with the smallest.
std::vector<std::vector<const QuantityResult*>> series_of(const ExerciseResult&);
/// Chart of each method's evaluations over the size.
std::string series_svg(const std::vector<const QuantityResult*>&, const std::string& title);
std::string series_finding(const std::vector<const QuantityResult*>&);

/// Chart of a quantity's trajectory: its observables over time, or "x" and "y" as a path. It shows the true
/// motion with the reference on it, and the motion of each model. For more than six observables it shows the
/// largest distance from the true motion over time.
std::string trajectory_svg(const QuantityResult&, const std::string& title);
/// How many models are good enough for a game, in a sentence for the title.
std::string motion_finding(const QuantityResult&);

}  // namespace oddity
