#pragma once

#include "chapters/examples/oscillator/drawing.hpp"
#include "chapters/examples/oscillator/models.hpp"
#include "chapters/own_reference.hpp"
#include "chapters/scene.hpp"

/// The scene of the site's lesson: how each method maps the circle of an oscillator.
namespace oddity::oscillator {

inline constexpr Parameter parameters[] = {{"w", 2, "1/s", "frequency of the spring", 0.5, 8},
                                           {"x0", 1, "m", "place at the start", -1.5, 1.5},
                                           {"v0", 0, "m/s", "velocity at the start", -12, 12}};

inline Quantity place_and_velocity(const Parameters& p, const Horizon& horizon, const Reference&) {
  const Given<double> given{p["w"], p["x0"], p["v0"]};
  const Value truth = observe_closed_form(Circle<double>{given}, horizon).value;
  Quantity both = quantity("motion", "m", "place and velocity at " + times_up_to(horizon),
                           closed_form(truth, 1e-14), {1e-6, "a micrometre"});
  SceneMethods(both, horizon, halving("step", 0.5, 8), tolerances())
      .closed_form("circle", Circle<double>{given})
      .by_engine_integrators("spring", Spring<double>{given});
  return both;
}

inline Scene scene() {
  return {.motion = place_and_velocity,
          .horizon = 20,
          .game_tolerance = centimeter,
          .sweep_parameter = "w",
          .sweep_values = {2, 4},
          .perturbed_parameters = {"x0"},
          .axes = {{"x", "v"}, "s", {{"m", {0}}, {"m/s", {1}}}},
          .listing = {{"chapters/examples/oscillator/models.hpp"},
                      {{"circle", "oscillator::Circle<double>{{w, x0, v0}}"},
                       {"spring", "oscillator::Spring<double>{{w, x0, v0}}"}}},
          .draw = draw<Parameters>,
          .is_linear = true};
}

}  // namespace oddity::oscillator
