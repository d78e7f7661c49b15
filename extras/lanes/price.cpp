#include "extras/lanes/price.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "solvers/ode/steps_in.hpp"

namespace oddity::lanes {

namespace {

/// A scene's model and algorithm in lanes.
struct InLanes {
  const SceneInLanes* scene;
  std::size_t model;
  Precision precision;
  std::optional<Fixed> fixed;  ///< none: variable steps
};

std::optional<InLanes> in_lanes(std::string_view number, std::string_view model, std::string_view algorithm) {
  for (const SceneInLanes& scene : scenes_in_lanes()) {
    if (scene.number != number) continue;
    const auto names = model_names(scene);
    const auto at = static_cast<std::size_t>(std::ranges::find(names, model) - names.begin());
    if (at == names.size()) return {};
    const Beginning& begun = scene.beginnings[at];
    if (begun.unknowns == 0 || begun.has_events || begun.has_own_time) return {};
    if (algorithm == own_steps_name) return InLanes{&scene, at, Precision::in_double, {}};
    for (Fixed fixed : {Fixed::runge_kutta_4, Fixed::velocity_verlet, Fixed::symplectic_euler}) {
      if (!scene.compiled[0][at].fixed[static_cast<int>(fixed)]) continue;
      if (algorithm == name_of(fixed)) return InLanes{&scene, at, Precision::in_double, fixed};
      if (algorithm == in_float(name_of(fixed))) return InLanes{&scene, at, Precision::in_float, fixed};
    }
  }
  return {};
}

/// Seconds per frame of all bodies, from the least disturbed of several frames.
Time time_a_frame(Batch& batch, const InLanes& method, double frame, double setting) {
  constexpr int frames = 9;
  std::vector<double> seconds;
  for (int i = 0; i < frames; ++i) {
    const double t = i * frame;
    const auto start = std::chrono::steady_clock::now();
    if (method.fixed) {
      const double steps = ode::steps_in(t, t + frame, setting);
      batch.steps(widest(), *method.fixed, t, frame / steps, static_cast<long>(steps));
    } else {
      batch.own_steps(widest(), t, t + frame, setting, frame);
    }
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  seconds.erase(seconds.begin());  // the first one brings the bodies into the caches
  std::ranges::sort(seconds);
  return {seconds[frames / 4], (seconds[frames / 2] - seconds.front()) / 2};
}

}  // namespace

const Needs needs_of_lanes{{}, {}, {"oddity_lanes"}};

std::optional<Registers> registers_of(std::string_view scene, std::string_view model,
                                      std::string_view algorithm) {
  return in_lanes(scene, model, algorithm) ? std::optional(widest()) : std::nullopt;
}

Price price_of_all(const Task& task, const Need& need) {
  return [task, need](const Method& asked, double setting) -> Time {
    const auto bodies = static_cast<double>(need.bodies);
    const std::optional<InLanes> method =
        in_lanes(to_string(task.entry->number), asked.model, asked.algorithm);
    if (!method) {
      const Time one = measured_price(asked, setting);
      return {bodies * one.seconds, bodies * one.spread};
    }
    std::vector<double> parameters;
    for (long i = 0; i < need.bodies; ++i)
      for (std::size_t k = 0; k < method->scene->parameters; ++k)
        parameters.push_back(task.parameters[task.parameters.declared()[k].name]);
    Batch batch(*method->scene, method->model, method->precision, std::move(parameters));
    const Time frame = time_a_frame(batch, *method, 1 / need.frames_per_second, setting);
    return {need.frames() * frame.seconds, need.frames() * frame.spread};
  };
}

ManyBodies bodies_in_lanes() {
  return {needs_of_lanes, price_of_all, [](const Choice& choice) {
            const auto registers =
                registers_of(choice.exercise, choice.chosen->model, choice.chosen->algorithm);
            return registers ? std::string(name_of(*registers)) : "";
          }};
}

}  // namespace oddity::lanes
