#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "report/site/parts.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// lesson.html: why explicit Euler fails, step by step on a mass and a spring. The page's script runs the
/// compiled model; in print, and without scripts, each step has its charts.
std::string lesson_page(const Results&, const SiteParts&);

/// One step of the lesson.
struct LessonStep {
  std::string name, title, says, tries;
  std::string algorithm;
  double step;  ///< s
  int shown;    ///< steps of the algorithm; 0: to the end
};
std::span<const LessonStep> lesson_steps();

/// Position and velocity of the lesson's mass at the start and after each of `count` steps.
using PlaceAndVelocity = std::array<double, 2>;
std::vector<PlaceAndVelocity> lesson_motion(const std::string& algorithm, double step, int count);
double lesson_energy(const PlaceAndVelocity&);
/// The quantity that the algorithm conserves instead of the energy at this step; otherwise the energy.
double shadow_energy(const std::string& algorithm, double step, const PlaceAndVelocity&);

}  // namespace oddity
