#pragma once

#include <optional>

#include "report/study/results.hpp"

namespace oddity {

/// What a scene does, seen at many times: each of its models by its most accurate method, whose finest trial
/// in `judged`, the scene's quantity, tells how true it is. No reference is asked for. None when no trial
/// there is ok.
std::optional<Trajectory> trajectory(const Scene&, const Parameters&, const QuantityResult& judged);

}  // namespace oddity
