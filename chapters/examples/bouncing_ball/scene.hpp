#pragma once

#include "chapters/examples/bouncing_ball/drawing.hpp"
#include "chapters/examples/bouncing_ball/models.hpp"
#include "chapters/own_reference.hpp"
#include "chapters/scene.hpp"

/// A scene with events; README.md explains them.
namespace oddity::bouncing_ball {

inline constexpr Parameter parameters[] = {{"y0", 1, "m", "height at release", 0.1, 10},
                                           {"g", 9.81, "m/s^2", "gravity", 1, 100},
                                           {"e", 0.7, "", "part of the speed that is returned", 0, 1}};

inline Quantity height(const Parameters& p, const Horizon& horizon, const Reference&) {
  const Given<double> given{p["y0"], p["g"], p["e"]};
  const Value truth = observe_closed_form(Flights<double>{given}, horizon).value;
  Quantity y = quantity("height", "m", "height at " + times_up_to(horizon), closed_form(truth, 1e-14),
                        {1e-6, "a micrometre"});
  SceneMethods(y, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("flights", Flights<double>{given})
      .by_engine_integrators("ball", Ball<double>{given})
      .by_remaining_integrators("ball", Ball<double>{given})
      .by_engine_integrators("ball, at rest below 1 cm/s", ComingToRest<double>{{given}});
  return y;
}

inline Scene scene(double horizon) {
  return {.motion = height,
          .horizon = horizon,
          .game_tolerance = centimeter,
          .sweep_parameter = "e",
          .sweep_values = {0.25, 0.5},
          .perturbed_parameters = {"y0"},
          .axes = {{"y"}, "s", {{"m", {0}}}},
          .listing = {{"chapters/examples/bouncing_ball/models.hpp"},
                      {{"flights", "bouncing_ball::Flights<double>{{y0, g, e}}"}},
                      {{"ball", "which needs a search for events"},
                       {"ball, at rest below 1 cm/s", "which needs a search for events"}},
                      {{"ball", "bouncing_ball::Ball<double>{{y0, g, e}}"},
                       {"ball, at rest below 1 cm/s", "bouncing_ball::ComingToRest<double>{{{y0, g, e}}}"}}},
          .draw = draw<Parameters>};
}

}  // namespace oddity::bouncing_ball
