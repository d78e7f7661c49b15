#pragma once

#include "chapters/contents.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// A scene with events that is no exercise of the book, for the site alone: a bouncing ball.
const Entry& example();
/// Its trials, run here and now.
const ExerciseResult& example_result();

/// The scene of the lesson (lesson.hpp): a mass on a spring.
const Entry& lesson_scene();

/// The exercise of this number, or the example; null when there is none.
const Entry* entry_of(Number);

/// bouncing_ball.html, with data/bouncing_ball.js.
constexpr const char* example_name = "bouncing_ball";

}  // namespace oddity
