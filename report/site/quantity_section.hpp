#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// What is computed: each quantity with its true value, the places of its chart and its table, where it
/// breaks and what cures it, and which methods are expected to fail.
std::string quantities_section(const ExerciseResult&);
/// Up to which step the methods of a scene are stable, in words, and the place of its map. Empty for what is
/// no scene.
std::string stability_section(const ExerciseResult&);

}  // namespace oddity
