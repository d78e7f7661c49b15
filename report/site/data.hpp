#pragma once

#include <string>

#include "chapters/contents.hpp"
#include "reference/reference.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// data/3.5.js: oddity.exercise({...}), everything that the page's scripts show of an exercise. Its layout
/// stands at the head of data.cpp.
std::string exercise_data(const ExerciseResult&, const Reference&);

}  // namespace oddity
