#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// Pictures of what engines do, as SVG text.
namespace oddity {

/// The error of each engine's defaults over its steps a second, and that of our own models. Engines that err
/// alike share a curve; of more than eight curves those stand that err least at their finest step.
std::string engine_rates_svg(const EngineContest&, const std::vector<OwnSteps>&);

/// The error over the time that a frame takes, of the native engines and the model that `choose` takes; holds
/// times. What runs behind WebAssembly has a picture of its own.
std::string engine_times_svg(const EngineContest&, bool webassembly);

/// How each variant ends in each scene, from one step a frame on the left to the finest on the right.
std::string engine_map_svg(const std::vector<EngineContest>&);

}  // namespace oddity
