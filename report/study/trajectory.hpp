#pragma once

#include <optional>

#include "report/study/results.hpp"

namespace oddity {

/// A scene's motion at many times by each model's most accurate method; its finest trial in `judged`, the
/// scene's quantity, gives the error. Needs no reference. Empty when no trial there is ok.
std::optional<Trajectory> trajectory(const Scene&, const Parameters&, const QuantityResult& judged);

}  // namespace oddity
