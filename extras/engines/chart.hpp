#pragma once

#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// Charts of the engines' results, as SVG text.
namespace oddity {

/// The error of each engine's defaults over its steps a second, and of our models. Engines with similar
/// errors share a curve. Of more than eight curves those with the smallest error at their finest step are
/// drawn.
std::string engine_rates_svg(const EngineContest&, const std::vector<OwnSteps>&);

/// The error over the time per frame, of the native engines and the model that `choose` takes; contains
/// times. Engines in WebAssembly have a separate chart.
std::string engine_times_svg(const EngineContest&, bool webassembly);

/// The outcome of each variant in each scene, from one step a frame on the left to the finest on the right.
std::string engine_map_svg(const std::vector<EngineContest>&);

}  // namespace oddity
