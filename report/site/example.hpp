#pragma once

#include "chapters/contents.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// A bouncing ball: a scene with events that is no exercise of the book, only for the site.
const Entry& example();
/// Its trials, run at the first call.
const ExerciseResult& example_result();

/// The scene of the lesson (lesson.hpp): a mass on a spring.
const Entry& lesson_scene();

/// The exercise of this number, or the example; null for any other number.
const Entry* entry_of(Number);

/// bouncing_ball.html, with data/bouncing_ball.js.
constexpr const char* example_name = "bouncing_ball";

}  // namespace oddity
