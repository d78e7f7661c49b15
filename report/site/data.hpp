#pragma once

#include <span>
#include <string>

#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/charts/chart_style.hpp"
#include "report/study/engines.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// data/3.5.js: oddity.exercise({...}), all data of an exercise for the page's scripts. The head of data.cpp
/// describes the layout. `recorded`: includes all recorded motions of the scene, for a page without models;
/// otherwise only third-party engines' results, if kept.
std::string exercise_data(const ExerciseResult&, const Reference&, const Styles&, bool recorded,
                          std::span<const EngineContest> = {});

/// Data of the example that is no exercise (example.hpp).
std::string example_data(const ExerciseResult&, bool recorded);

/// data/scenes.js: oddity.scenes([...]), data of all scenes for the chooser.
std::string scenes_data(const Results&, const Styles&);

}  // namespace oddity
