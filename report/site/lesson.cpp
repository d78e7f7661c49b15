#include "report/site/lesson.hpp"

#include <algorithm>
#include <cmath>

#include "chapters/scene.hpp"
#include "reference/text.hpp"
#include "report/site/example.hpp"
#include "report/site/page.hpp"
#include "report/site/play_link.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

constexpr const char* true_circle = "closed form";
constexpr const char* explicit_euler = "explicit Euler";
constexpr const char* symplectic_euler = "symplectic Euler";
constexpr const char* verlet = "velocity Verlet";
constexpr const char* runge_kutta = "Runge-Kutta 4";

double lesson_given(std::string_view name) { return Parameters(lesson_scene().exercise.parameters)[name]; }
double lesson_horizon() { return lesson_scene().exercise.scene->horizon; }

/// The factor of the energy in one step.
double energy_factor(const std::string& algorithm, double step) {
  const auto motion = lesson_motion(algorithm, step, 1);
  return lesson_energy(motion[1]) / lesson_energy(motion[0]);
}

std::string three_digits(double x) { return format_significant(x, 3); }

std::vector<LessonStep> make_steps() {
  constexpr double short_step = 0.25, in_view = 0.015, long_step = 0.4, longest = 0.6;
  return {
      {"circle", "The true motion is a circle",
       "A mass on a spring obeys $\\ddot x=-\\omega^2x$. Draw its place $x$ against its velocity over "
       "$\\omega$: the point goes round a circle, and the circle’s radius squared is the energy.",
       "Drag the mass and let it go. The circle changes its size, and the time once round stays.",
       true_circle, 0.05, 0},
      {"one-step", "One step of Euler leaves it",
       "Explicit Euler goes straight on, along the tangent, and so it ends outside of the circle. A step "
       "multiplies the energy by $1+h^2\\omega^2$, which for this step $h$ is " +
           three_digits(energy_factor(explicit_euler, short_step)) + ".",
       "Halve the step. The energy that a step adds falls to a quarter.", explicit_euler, short_step, 1},
      {"spiral", "Step after step it spirals out",
       "Each step multiplies the energy by that factor again, so it grows without end, for any step. A spring "
       "of twice the frequency $\\omega$ needs a quarter of the step for the same growth.",
       "Find a step with which the energy does not double before the end. How many steps does it take?",
       explicit_euler, in_view, 0},
      {"symplectic", "Symplectic Euler closes the curve",
       "Compute the new velocity first, and move the mass by the new one: the same work, and the points stay on "
       "an ellipse. The energy goes up and down, and the shadow energy $v^2+\\omega^2x^2-h\\omega^2xv$ does not "
       "change at all.",
       "Halve the step: the ellipse comes closer to the circle. Then make it longer than $2/\\omega$, and the "
       "curve opens.",
       symplectic_euler, long_step, 0},
      {"verlet", "Verlet sets the ellipse upright",
       "Velocity Verlet takes half of the kick before the move and half of it after. It keeps "
       "$v^2/(1-h^2\\omega^2/4)+\\omega^2x^2$, and its error falls to a quarter when the step is halved.",
       "Compare the wobble of the energy with that of symplectic Euler at the same step: go one step back, and "
       "forward again.",
       verlet, long_step, 0},
      {"runge-kutta", "Runge-Kutta 4 is accurate, and loses slowly",
       "Four evaluations a step follow the circle closely, but no shadow energy holds them there. A step "
       "multiplies the energy by $1-h^6\\omega^6/72+h^8\\omega^8/576$, here " +
           three_digits(energy_factor(runge_kutta, longest)) + ".",
       "Halve the step, and again: each time a step loses about 64 times less. Beyond $h\\omega=2\\sqrt2$ it gains.",
       runge_kutta, longest, 0}};
}

// ---- charts for paper -------------------------------------------------------------------------------------

/// Chart of the circle; its reach is in amplitudes.
constexpr double circle_side = 150, circle_middle = circle_side / 2, circle_reach = 2.1;
/// Chart of the energy.
constexpr double energy_left = 190, energy_right = 370, energy_bottom = 136, energy_top = 10;
constexpr double most_energy = 3;  ///< relative to the initial energy

std::string lesson_pixel(double x) {
  return format_significant(std::round(10 * std::clamp(x, -1e3, 1e3)) / 10, 5);
}
std::string lesson_point(double x, double y) { return lesson_pixel(x) + "," + lesson_pixel(y); }

std::string lesson_line(const std::string& kind, const std::string& points) {
  return "<polyline class=\"" + kind + "\" points=\"" + points + "\"/>";
}
std::string lesson_word(double x, double y, const std::string& text) {
  return element("text", " x=\"" + lesson_pixel(x) + "\" y=\"" + lesson_pixel(y) + "\"", text);
}

double amplitude() {
  return std::sqrt(2 * lesson_energy({lesson_given("x0"), lesson_given("v0")})) / lesson_given("w");
}

std::string circle_chart(const std::vector<PlaceAndVelocity>& motion) {
  const double radius = circle_middle / circle_reach;
  std::string way;
  for (const auto& [x, v] : motion) {
    const double across = x / amplitude(), up = v / lesson_given("w") / amplitude();
    way +=
        (way.empty() ? "" : " ") + lesson_point(circle_middle + radius * across, circle_middle - radius * up);
    if (std::hypot(across, up) > 2 * circle_reach) break;
  }
  return lesson_line("axis",
                     lesson_point(0, circle_middle) + " " + lesson_point(circle_side, circle_middle)) +
         lesson_line("axis",
                     lesson_point(circle_middle, 0) + " " + lesson_point(circle_middle, circle_side)) +
         lesson_word(circle_side - 10, circle_middle - 5, "x") + lesson_word(circle_middle + 5, 10, "v/ω") +
         "<circle class=\"true\" cx=\"" + lesson_pixel(circle_middle) + "\" cy=\"" +
         lesson_pixel(circle_middle) + "\" r=\"" + lesson_pixel(radius) + "\"/>" + lesson_line("way", way);
}

/// Values relative to the initial one, at each step.
std::string energy_curve(const std::string& kind, const std::vector<double>& values, double step) {
  std::string points;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double part = values[k] / values.front(), t = static_cast<double>(k) * step;
    points += (k == 0 ? "" : " ") +
              lesson_point(
                  energy_left + (energy_right - energy_left) * t / lesson_horizon(),
                  energy_bottom - (energy_bottom - energy_top) * std::min(part, most_energy) / most_energy);
    if (part > most_energy) break;
  }
  return lesson_line(kind, points);
}

std::string energy_chart(const LessonStep& told, const std::vector<PlaceAndVelocity>& motion) {
  std::vector<double> energies, shadows;
  for (const PlaceAndVelocity& s : motion) {
    energies.push_back(lesson_energy(s));
    shadows.push_back(shadow_energy(told.algorithm, told.step, s));
  }
  const double level = energy_bottom - (energy_bottom - energy_top) / most_energy;
  return lesson_line("axis", lesson_point(energy_left, energy_top) + " " +
                                 lesson_point(energy_left, energy_bottom) + " " +
                                 lesson_point(energy_right, energy_bottom)) +
         lesson_line("true", lesson_point(energy_left, level) + " " + lesson_point(energy_right, level)) +
         lesson_word(energy_left + 4, energy_top + 4, "energy") +
         lesson_word(energy_right - 26, energy_bottom + 11, three_digits(lesson_horizon()) + " s") +
         lesson_word(energy_left - 8, level + 3, "1") + lesson_word(energy_left - 8, energy_bottom + 3, "0") +
         lesson_word(energy_left - 8, energy_top + 4, three_digits(most_energy)) +
         (shadows != energies ? energy_curve("shadow", shadows, told.step) : "") +
         energy_curve("way", energies, told.step);
}

std::string still_of(const LessonStep& told) {
  const int count = told.shown > 0 ? told.shown : static_cast<int>(std::lround(lesson_horizon() / told.step));
  const auto motion = lesson_motion(told.algorithm, told.step, count);
  return "<figure class=\"still\"><svg viewBox=\"0 0 380 150\" role=\"img\" aria-label=\"" +
         in_xml(told.title + ": place and velocity with the circle, and the energy over time") + "\">" +
         circle_chart(motion) + energy_chart(told, motion) + "</svg><figcaption>" + in_xml(told.algorithm) +
         ", step " + three_digits(told.step) + " s</figcaption></figure>";
}

// ---- the page ---------------------------------------------------------------------------------------------

std::string step_text(const LessonStep& told) {
  return "<li data-name=\"" + told.name + "\" data-algorithm=\"" + told.algorithm + "\" data-step=\"" +
         format_shortest(told.step) + "\" data-shown=\"" + std::to_string(told.shown) + "\">\n<div>" +
         element("h2", "", in_xml(told.title)) + element("p", "", html::text(told.says)) +
         element("p", " class=\"tries\"", "<b>Try:</b> " + html::text(told.tries)) + "</div>\n" +
         still_of(told) + "</li>\n";
}

/// Links to players with these methods at a step per frame, if the model allows them.
std::string in_the_book(const Results& results) {
  constexpr std::array<std::pair<Number, const char*>, 4> scenes{
      {{{3, 5}, "a pendulum"}, {{3, 9}, "a stiff spring"}, {{3, 33}, "a top"}, {{3, 25}, "a chain of rods"}}};
  std::string items;
  for (const auto& [number, name] : scenes) {
    const auto e = std::ranges::find(results.exercises, number, &ExerciseResult::number);
    if (e == results.exercises.end()) continue;
    const std::string to = link_to_players(*e, {explicit_euler, symplectic_euler, runge_kutta}, 1. / 60);
    items += element("li", "", html::link(to, std::string(name)) + ", " + to_string(number));
  }
  return "<li data-name=\"book\" data-algorithm=\"" + std::string(explicit_euler) +
         "\" data-step=\"0.25\" data-shown=\"0\">\n<div>" + element("h2", "", "Consequences for a game") +
         element(
             "p", "",
             "A frame is a step of a sixtieth of a second, and explicit Euler adds energy in each. These players "
             "open with methods of this lesson and the true motion:") +
         element("ul", "", items) +
         element("p", " class=\"tries\"",
                 "<b>Try:</b> press “break it” in a player to find a step that breaks the motion.") +
         "</div></li>\n";
}

}  // namespace

std::span<const LessonStep> lesson_steps() {
  static const std::vector<LessonStep> steps = make_steps();
  return steps;
}

std::vector<PlaceAndVelocity> lesson_motion(const std::string& algorithm, double step, int count) {
  std::vector<PlaceAndVelocity> motion{{lesson_given("x0"), lesson_given("v0")}};
  if (count == 0) return motion;
  const Quantity both = lesson_scene().exercise.scene->motion(Parameters(lesson_scene().exercise.parameters),
                                                              {step * count, count}, Reference::nothing());
  const Value seen = std::ranges::find(both.methods, algorithm, &Method::algorithm)->run(step).value;
  for (std::size_t k = 0; k + 1 < seen.size(); k += 2) motion.push_back({seen[k], seen[k + 1]});
  return motion;
}

double lesson_energy(const PlaceAndVelocity& s) {
  const double w = lesson_given("w");
  return (s[1] * s[1] + w * w * s[0] * s[0]) / 2;
}

double shadow_energy(const std::string& algorithm, double step, const PlaceAndVelocity& s) {
  const double w = lesson_given("w"), y = step * w;
  if (algorithm == symplectic_euler) return lesson_energy(s) - y * w * s[0] * s[1] / 2;
  if (algorithm == verlet) return (s[1] * s[1] / (1 - y * y / 4) + w * w * s[0] * s[0]) / 2;
  return lesson_energy(s);
}

std::string lesson_page(const Results& results, const SiteParts& parts) {
  std::string steps;
  for (const LessonStep& told : lesson_steps()) steps += step_text(told);
  steps += in_the_book(results);
  return html::whole(
      {"Why does Euler fail? - oddity",
       "<header class=\"title\">\n<h1>Why does Euler fail?</h1>\n</header>\n<div class=\"lesson\">\n"
       "<ol class=\"told\">\n" +
           steps + "</ol>\n</div>\n",
       parts.models ? std::vector<std::string>{"assets/typed.js", "assets/engine.js", "assets/models.js",
                                               "assets/stage.js", "assets/scale.js", "assets/slider.js",
                                               "assets/plots.js", "assets/lesson.js"}
                    : std::vector<std::string>{},
       "teach"});
}

}  // namespace oddity
