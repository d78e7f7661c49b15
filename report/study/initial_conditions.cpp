#include "report/study/initial_conditions.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <span>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/in_long_double.hpp"
#include "reference/text.hpp"
#include "reference/truth.hpp"
#include "report/study/parallel.hpp"

namespace oddity {

namespace {

constexpr double nearby = 0.1;

std::vector<Start> known(std::span<std::optional<Start>> made) {
  std::vector<Start> all;
  for (auto& one : made)
    if (one) all.push_back(std::move(*one));
  return all;
}

std::optional<Start> where_known(const std::function<Start()>& make) {
  try {
    return make();
  } catch (const OutOfTime&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {  // no reference there
    return {};
  }
}

Quantity with_need(Quantity motion, const Need& need) {
  motion.needs = needs_of(need, motion);
  motion.need = {*std::ranges::min_element(motion.needs), "asked for"};
  return motion;
}

}  // namespace

const Start& Sharper::start() {
  std::call_once(made_, [this] { start_ = make_(); });
  return *start_;
}

bool is_known_well(const Quantity& motion) {
  constexpr double part = 1e-6;
  return motion.reference_error <= part * *std::ranges::min_element(motion.needs);
}

int digits_for(const Need& need) {
  const double least = need.relative ? need.error : std::min(need.error_in("m"), need.error_in("rad"));
  return std::clamp(12 + static_cast<int>(std::ceil(-std::log10(least))), digits_in_long_double + 1,
                    truth::spot_digits);
}

Need game_need() {
  Need need{degree};
  need.errors = {{"m", centimeter}};
  return need;
}

double game_error(std::string_view unit) { return unit == "m" ? centimeter : degree; }

std::vector<double> needs_of(const Need& need, const Quantity& motion) {
  const double scale = need.relative ? size_of(motion.reference.value) : 1;
  std::vector<double> needs;
  for (std::string_view unit : motion.units()) needs.push_back(need.error_in(unit) * scale);
  return needs;
}

Quantity known_motion(const Scene& scene, const Parameters& p, const Horizon& horizon, const Need& need,
                      const Reference& truth) {
  const auto made = [&](const Reference& known) { return with_need(motion(scene, p, horizon, known), need); };
  if (need.thorough) return made(truth);
  for (int digits : {digits_in_long_double, digits_for(need)}) {
    Quantity seen = made(truth.to_digits(digits));
    if (is_known_well(seen)) return seen;
  }
  return made(truth);
}

InitialConditions::InitialConditions(const Task& task, const Need& need, const Reference& truth)
    : task_(task), need_(need), truth_(truth) {
  if (!task.entry->exercise.scene)
    throw BadInput("exercise " + to_string(task.entry->number) + " has no motion to choose a method for");
  for (const auto& [name, value] :
       {std::pair("error", need.error), std::pair("horizon", need.horizon),
        std::pair("frame rate", need.frames_per_second), std::pair("budget", need.budget)})
    if (!(value > 0))
      throw BadInput("the " + std::string(name) + " must be positive, and is " + format_shortest(value));
  if (need.horizon * need.frames_per_second < 1) throw BadInput("the horizon is shorter than a frame");
}

std::string InitialConditions::says(const Parameters& p) const {
  std::string says;
  for (std::string_view name : scene().perturbed_parameters)
    says += (says.empty() ? "" : ", ") + std::string(name) + " = " + format_significant(p[name], 4);
  return says;
}

Start InitialConditions::well_known(const Parameters& p) const {
  return {says(p), known_motion(scene(), p, horizon(), need_, truth_)};
}

/// By a path alone more digits can decide: of what is conserved, or does not explode, the truth says nothing.
Start InitialConditions::start(const Parameters& p) const {
  if (need_.thorough || need_.criterion == Criterion::period) return well_known(p);
  const auto known_by = [this, p](const Reference& truth) {
    return Start{says(p), with_need(motion(scene(), p, horizon(), truth), need_)};
  };
  Start start = known_by(truth_.to_digits(digits_in_long_double));
  if (need_.criterion != Criterion::path || is_known_well(start.motion)) return start;
  start.sharper = std::make_shared<Sharper>([this, p, known_by] {
    Start repeated = known_by(truth_.repeated());
    repeated.sharper = std::make_shared<Sharper>([this, p, as_well_as_can_be = repeated] {
      return where_known([&] { return well_known(p); }).value_or(as_well_as_can_be);
    });
    return repeated;
  });
  return start;
}

Start InitialConditions::required(Start start) const {
  const bool by_motion = need_.criterion == Criterion::path || need_.criterion == Criterion::period;
  if (by_motion && start.motion.need.allowed < start.motion.reference_error)
    throw BadInput("the true motion is known to " + format_significant(start.motion.reference_error, 2) +
                   ", and the error asked for is smaller");
  return start;
}

Start InitialConditions::asked() const { return required(well_known(task_.parameters)); }

Start InitialConditions::asked_to_choose() const {
  constexpr double well_enough = 0.1;  // of the need: what fails by more is told to a digit
  Start asked = start(task_.parameters);
  while (asked.sharper && asked.motion.reference_error > well_enough * asked.motion.need.allowed)
    asked = Start(asked.sharper->start());
  return required(std::move(asked));
}

Parameters InitialConditions::draw() {
  Parameters p = task_.parameters;
  for (std::string_view name : scene().perturbed_parameters) {
    const auto declared = std::ranges::find(p.declared(), name, &Parameter::name);
    const double value = p[name], size = value == 0 ? 1 : std::abs(value);
    p.set(name, std::clamp(value + size * random_.between(-nearby, nearby), declared->least, declared->most));
  }
  return p;
}

Quantity InitialConditions::disturbed(double part) const {
  Parameters p = task_.parameters;
  const std::string_view name = scene().perturbed_parameters.front();
  const double value = p[name], change = part * (value == 0 ? 1 : std::abs(value));
  const auto declared = std::ranges::find(p.declared(), name, &Parameter::name);
  p.set(name, value + change <= declared->most ? value + change : value - change);
  return motion(scene(), p, horizon(), Reference::nothing());
}

Quantity InitialConditions::one_frame() const {
  const Horizon frame{1 / need_.frames_per_second, 1, need_.frames_per_second};
  return motion(scene(), task_.parameters, frame, Reference::nothing());
}

std::vector<Start> InitialConditions::beside(int count) {
  std::vector<Parameters> drawn;
  for (int i = 0; i < count; ++i) drawn.push_back(draw());
  std::vector<std::optional<Start>> made(drawn.size());
  in_parallel(drawn.size(), [&](std::size_t i) { made[i] = where_known([&] { return start(drawn[i]); }); });
  return known(made);
}

InitialConditions::First InitialConditions::first(int seen, int unseen,
                                                  const std::function<void()>& one_made) {
  std::vector<Parameters> drawn;
  for (int i = 0; i < seen + unseen; ++i) drawn.push_back(draw());
  std::optional<Start> at_asked;
  std::vector<std::optional<Start>> made(drawn.size());
  in_parallel(1 + drawn.size(), [&](std::size_t i) {
    if (i == 0)
      at_asked = asked_to_choose();
    else
      made[i - 1] = where_known([&] { return start(drawn[i - 1]); });
    one_made();
  });
  const std::span all(made);
  const auto first = static_cast<std::size_t>(seen);
  return {std::move(*at_asked), known(all.first(first)), known(all.subspan(first))};
}

}  // namespace oddity
