// Exercise 3.31: a box slides and rotates on a rough plane. The solution is two sentences about a program
// that is not available, so they are not checked. The exercise's motion is computed:
//   F = -mu p int n dA,  moment = -mu p int rho x n dA,  n = (V + w k x rho)/|V + w k x rho|, p = m g/(4ab).
// The integrals have closed forms about the instantaneous center. At rest n is undefined: kinetic friction
// alone leaves the box creeping. The pressure is assumed to be uniform; the box is too low to be tilted by
// its friction.

#include "chapters/03_rigid_body_motion/31_rough_box/drawing.hpp"
#include "chapters/03_rigid_body_motion/31_rough_box/rough_box.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"
#include "chapters/scene.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace ex03_31 {

constexpr Parameter parameters[] = {
    {"a", 0.3, "m", "half the box's length", 1e-3, 1e2},
    {"b", 0.2, "m", "half the box's width", 1e-3, 1e2},
    {"mu", 0.3, "", "coefficient of friction", 1e-3, 10},
    {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e3},
    {"u0", 2, "m/s", "velocity at the start, along the length", 1e-3, 100},
    {"v0", 0.5, "m/s", "velocity at the start, across", 0, 100},
    {"w0", 10, "rad/s", "angular velocity at the start", 0, 1000},
};

Box asked(const Parameters& p) { return {{p["a"], p["b"]}, p["mu"], p["g"], p["u0"], p["v0"], p["w0"]}; }

Quantity slide_of(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(
      slide(asked(p), horizon, truth), horizon, asked(p),
      {"sliding and spinning apart", "friction regularized at 1 cm/s", "friction at full speed only", "", ""},
      Outcome::ok);
}

/// A flat box.
engines::Staging staging(const Parameters& p) {
  using namespace engines;
  const double a = p["a"], b = p["b"], h = b / 10;
  Body box{1, {(b * b + h * h) / 3, (a * a + h * h) / 3, (a * a + b * b) / 3}};
  box.start = {.position = {0, 0, h}, .velocity = {p["u0"], p["v0"], 0}, .spin = {0, 0, p["w0"]}};
  box.shape = {Shape::box, {a, b, h}};
  return {
      {.gravity = {0, 0, -p["g"]}, .bodies = {box}, .floor = {0, 0, 1}, .friction = p["mu"]},
      [](std::span<const State> seen, double) {
        const auto [w, x, y, z] = seen[0].orientation;
        return std::vector{seen[0].position[0], seen[0].position[1], 2 * std::atan2(z, w)};
      },
      "Engines apply this box's friction at its four corners, or all of it in their middle with a moment "
      "about that; the scene applies it under the whole foot. At the corners its lever is longer, and the "
      "box turns less. The scene \"box on corners\" judges engines by four corners."};
}

Energy energy(const Parameters& p, std::span<const double> x) {
  const double J = (p["a"] * p["a"] + p["b"] * p["b"]) / 3;
  return energy_seen(half_square(x.subspan(3, 2)) + J * half_square(x.subspan(5)), 0);
}

Scene scene() {
  return {
      .motion = slide_of,
      .horizon = 1.25,
      .game_tolerance = centimeter,
      .sweep_parameter = "mu",
      .sweep_values = {0.2, 0.3, 0.5, 0.7, 1},
      .perturbed_parameters = {"u0", "v0", "w0"},
      .axes = {{"x", "y", "theta"}, "s", {{"m", {0, 1}}, {"rad", {2}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/31_rough_box/models.hpp"},
           {{"sliding and spinning apart", "rough_box::Uncoupled<double>{{{a, b}, mu, g, u0, v0, w0}}"},
            {"friction at full speed only", "rough_box::InTime<double>{{{a, b}, mu, g, u0, v0, w0}}"},
            {"friction regularized at 1 cm/s",
             "rough_box::InTime<double>{{{a, b}, mu, g, u0, v0, w0}, double(0.01)}"}},
           {{"stopped by event", "which needs a search for events"},
            {"time stretched by the speed", "which needs Newton's method for the time of every frame"}},
           {{"stopped by event", "rough_box::UntilRest<double>{{{{a, b}, mu, g, u0, v0, w0}}}"}},
           {{"steps with a stick test, explicit midpoint",
             "rough_box::WithStickTest<double>({{a, b}, mu, g, u0, v0, w0}, true)"},
            {"steps with a stick test, semi-implicit Euler",
             "rough_box::WithStickTest<double>({{a, b}, mu, g, u0, v0, w0}, false)"}}},
      .draw = rough_box::draw<Parameters>,
      .staging = staging,
      .laws = {energy},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  Findings found{claims(), at_rest(asked(p), truth)};
  found.quantities.push_back(motion(scene(), p, truth));
  return found;
}

}  // namespace ex03_31

Exercise exercise_3_31() {
  using namespace ex03_31;
  return {"Box on a rough plane",
          "A box slides and turns on a plane of friction $\\mu$. Where does it come to rest, and what does "
          "friction do at rest?",
          parameters, scene(), study};
}

}  // namespace oddity
