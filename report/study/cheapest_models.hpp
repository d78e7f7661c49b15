#pragma once

#include <optional>
#include <span>
#include <string>

#include "report/study/run.hpp"

/// The cheapest model that a scene needs, and the value of its hard parameter at which each simpler model
/// stops being enough.
namespace oddity {

/// The cheapest models of the task's scene; empty if it has no motion. Throws BadInput when no true motion is
/// known for the task's parameters.
std::optional<CheapestModels> cheapest_models(const Task&, const Reference&);

/// The results with the page of cheapest models of every task that has a scene, made in parallel.
Results with_cheapest_models(Results, std::span<const Task>, const Reference&, const Progress& progress = {});

}  // namespace oddity
