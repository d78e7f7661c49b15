#pragma once

#include <span>
#include <string>

#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/charts/chart_style.hpp"
#include "report/study/engines.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// data/3.5.js: oddity.exercise({...}), everything that the page's scripts show of an exercise. Its layout
/// stands at the head of data.cpp. `recorded`: with all motions of the scene that were recorded, for a page
/// without models; else with what other people's engines made of it, where that was kept.
std::string exercise_data(const ExerciseResult&, const Reference&, const Styles&, bool recorded,
                          std::span<const EngineContest> = {});

/// The same of the example that is no exercise (example.hpp).
std::string example_data(const ExerciseResult&, bool recorded);

/// data/scenes.js: oddity.scenes([...]), what the chooser has to know of all scenes.
std::string scenes_data(const Results&, const Styles&);

}  // namespace oddity
