// Exercise 3.9: a ball in the plane on a spring of constant c with viscous friction a: when does it reach the
// origin?
//   m x'' + a x' + c x = 0 in each coordinate; with h = a/(2m), d = h^2 - c/m.
//   x = exp(-h t) (p C + (v + h p) S),   C, S = cosh and sinh/w, or cos and sin/w, or 1 and t, w = sqrt|d|.

#include <cmath>

#include "chapters/03_rigid_body_motion/09_damped_ball/damped_ball.hpp"
#include "chapters/03_rigid_body_motion/09_damped_ball/drawing.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"

namespace oddity {

namespace ex03_09 {

constexpr Parameter parameters[] = {
    {"m", 1, "kg", "mass", 1e-6, 1e6},
    {"c", 4, "N/m", "spring constant", 1e-6, 1e7},
    {"a", 0.4, "N s/m", "viscous friction", 0, 1e5},
    {"p1", 1, "m", "position at the start", -1e6, 1e6},
    {"p2", 0.5, "m", "position at the start", -1e6, 1e6},
    {"v1", 0, "m/s", "velocity at the start", -1e5, 1e5},
    {"v2", 1.5, "m/s", "velocity at the start", -1e5, 1e5},
    {"seed", 39, "", "seed of the random samples", 0, 1e9, whole_number},
};

Ball asked(const Parameters& p) { return {p["m"], p["c"], p["a"], p["p1"], p["p2"], p["v1"], p["v2"]}; }

Quantity position(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  return with_float(path("path", "position at " + times_up_to(horizon), asked(p), horizon, truth), horizon,
                    asked(p), {"closed form, one for all regimes", "plane", "plane, with the work"});
}

Energy energy(const Parameters& p, std::span<const double> x) {
  return energy_seen(p["m"] * half_square(x.subspan(2)), p["c"] * half_square(x.first(2)));
}

Scene scene() {
  return {
      .motion = position,
      .horizon = 5,
      .game_tolerance = centimeter,
      .sweep_parameter = "a",
      .sweep_values = {0.4, 4, 40, 200, 1000},
      .perturbed_parameters = {"p1", "p2", "v2"},
      .axes = {{"x", "y"}, "s", {{"m", {0, 1}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/09_damped_ball/models.hpp"},
           {{"closed form, one for all regimes", "damped_ball::OneForm<double>{{m, c, a, p1, p2, v1, v2}}"},
            {"two exponentials", "damped_ball::TwoExponentials<double>{{m, c, a, p1, p2, v1, v2}}"},
            {"plane", "damped_ball::Plane<double>{{m, c, a, p1, p2, v1, v2}}"},
            {"plane, with the work", "damped_ball::PlaneWithWork<double>{{m, c, a, p1, p2, v1, v2}}"}}},
      .draw = damped_ball::draw<Parameters>,
      .laws = {energy},
      .is_linear = true,
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Ball ball = asked(p);
  Ball near_critical = ball, stiff = ball;
  constexpr double times_critical = 10;
  const double critical = 2 * std::sqrt(ball.m * ball.c);
  near_critical.a = critical * (1 + above_critical);
  stiff.a = times_critical * critical;
  Quantity fast = path("stiff", filled("position with @2 times the critical friction", {times_critical}),
                       stiff, horizon, truth);
  const double fast_root = -(stiff.a + std::sqrt(stiff.a * stiff.a - 4 * stiff.m * stiff.c)) / (2 * stiff.m);
  fast.add(
      Breakdown{"The fast root is @2 per second: explicit Euler diverges for steps above @1 s, though the "
                "motion that is left is slow. Rosenbrock's method takes its steps from the motion.",
                "plane, explicit Euler",
                0.125,
                Outcome::diverged,
                "plane, Rosenbrock 4",
                1e-11,
                {fast_root, -2 / fast_root}});
  std::vector<Quantity> quantities{motion(scene(), p, truth),
                                   near_critical_path(near_critical, horizon, truth), fast,
                                   stability_limit(stiff)};
  if (ball.a < 0.9 * critical && (ball.p1 != 0 || ball.p2 != 0))
    quantities.push_back(first_arrival({ball.m, ball.c, ball.a, ball.p1, ball.p2, 0, 0}));
  return {
      claims(p["seed"]), quantities, roots(),
      R"(The motion with complex roots is right; {{the arctangent's branch|the time of arrival can come out negative}}, {{a fast throw|a fast throw arrives with real roots too}}, {{too much friction|more friction can make the ball later}}, {{a ball that turns back|a ball that is thrown away from the origin can arrive}}, and {{rest}} are cases left out.)"};
}

}  // namespace ex03_09

Exercise exercise_3_9() {
  using namespace ex03_09;
  return {"Ball on a spring with friction",
          "A ball in the plane is held by a spring of constant $c$ to the origin and slowed by viscous "
          "friction $a$. Solve for its motion; when does "
          "it reach the origin?",
          parameters,
          scene(),
          study,
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
