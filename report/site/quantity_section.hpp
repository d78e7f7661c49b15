#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// Each computed quantity with its true value, the places of its chart and its table, where it breaks, a
/// cure, and the methods expected to fail.
std::string quantities_section(const ExerciseResult&);
/// Stability limits of a scene's methods in words, and the place of its map. Empty if there is no scene.
std::string stability_section(const ExerciseResult&);

}  // namespace oddity
