#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "reference/limits.hpp"
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
/// threads. Over the scenes' own horizons, unless another is given.
Results with_stability(Results, std::span<const Task>, const Reference&, const Progress& progress = {},
                       std::optional<double> horizon = {});

/// Whether the method of a map's row ends so at the map's step `k` where the start differs by a few
/// roundings: then the last bits decide, in which one machine's sines differ from another's.
bool ends_so_within_roundings(const Task&, const MapRow&, std::size_t k, Outcome, const Reference&);

/// The reason of a limit that differs from theory's for none of the reasons that are computed.
inline constexpr std::string_view not_explained = "not explained";
/// The measured limit over theory's: 1 where both are zero or infinite, or where theory's lies above the
/// longest step tried and all are stable; 0 or infinity where only one of them is.
double agreement(const Limit&);

}  // namespace oddity
