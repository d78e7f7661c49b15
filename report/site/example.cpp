#include "report/site/example.hpp"

#include <algorithm>

#include "chapters/examples/bouncing_ball/scene.hpp"
#include "chapters/examples/oscillator/scene.hpp"
#include "report/study/run.hpp"

namespace oddity {

namespace {

Scene scene() { return bouncing_ball::scene(4); }  // it comes to rest after 2.6 s

}  // namespace

const Entry& example() {
  static const Entry entry{
      {0, 1},
      "",
      {"Bouncing ball",
       "A ball falls from $y_0$ to a floor that returns the part $e$ of its speed. Its flights shrink in "
       "proportion, so that infinitely many of them are over after $\\sqrt{2y_0/g}\\,(1+e)/(1-e)$. What "
       "becomes of a method that has to find each landing?",
       bouncing_ball::parameters, scene(), [](const Parameters& p, const Reference& truth) {
         return Findings{{}, {motion(scene(), p, truth)}};
       }}};
  return entry;
}

const ExerciseResult& example_result() {
  static const ExerciseResult result = [] {
    const Task task(example());
    return run(std::span(&task, 1), Reference::nothing(), false).exercises.front();
  }();
  return result;
}

const Entry& lesson_scene() {
  static const Entry entry{
      {0, 2},
      "",
      {"Mass on a spring", "What does each method make of a circle?", oscillator::parameters,
       oscillator::scene(), [](const Parameters& p, const Reference& truth) {
         return Findings{{}, {motion(oscillator::scene(), p, truth)}};
       }}};
  return entry;
}

const Entry* entry_of(Number number) {
  if (number == example().number) return &example();
  const auto found = std::ranges::find(registry(), number, &Entry::number);
  return found == registry().end() ? nullptr : &*found;
}

}  // namespace oddity
