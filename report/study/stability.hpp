#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "reference/limits.hpp"
#include "report/study/run.hpp"

/// Finds where methods of fixed step break: the first step, from below, at which small disturbances grow that
/// do not grow in the true motion. Compares it with linear theory. Shows how each method breaks beyond it, a
/// cure, and a map of outcomes over the step and the parameter that makes the scene hard.
namespace oddity {

/// Measures the first loss of stability from below. Tries steps that grow by 3 %, from a quarter of theory's
/// limit (or the finest that differs from none) to the longest. This is `interval` [s], the time between two
/// judged times, or the most that the measurement allows. Adds the trials at and beyond the limit, whose
/// steps divide the interval, and the largest step within the quantity's need, at the times of its reference.
/// Looks for no cure.
Limit limit_of(const Quantity&, const Method&, double interval);

/// The limit alone, without any trial.
Limit measured_limit(const Method&, double interval, const ode::Criteria& = {});

/// Adds the stability of every task that has a scene, computed in parallel: the limits at the task's
/// parameters, and the map over the scene's parameter. Does not depend on the number of threads. Uses the
/// scenes' own horizons, unless another is given. To be compared with `records`, a limit is first looked for
/// where it is expected, and the map has its outcomes alone.
Results with_stability(Results, std::span<const Task>, const Reference&, const Progress& progress = {},
                       std::optional<double> horizon = {}, const Limits* records = nullptr);

/// Whether the method of a map's row has this outcome at the map's step `k` from a start that differs by a
/// few roundings. If so, the last bits decide, in which sines differ between machines.
bool ends_so_within_roundings(const Task&, const MapRow&, std::size_t k, Outcome, const Reference&);

/// The reason given for a limit that differs from theory's without a computed reason.
inline constexpr std::string_view not_explained = "not explained";
/// The measured limit over theory's. It is 1 if both are zero or infinite, or if theory's is above the
/// longest step tried and all are stable. It is 0 or infinity if only one of them is.
double agreement(const Limit&);

}  // namespace oddity
