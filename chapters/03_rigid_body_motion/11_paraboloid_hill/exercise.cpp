// Exercise 3.11: when does a particle that slides without friction on a paraboloid hill follow (v1 t, v2 t)?
//   hill       x3 = -x1^2/a1^2 - x2^2/a2^2 (lengths in metres), K = v1^2/a1^2 + v2^2/a2^2.
//   equations  x_i'' + (4 x_i/a_i^2) ((x1 x1'' + x1'^2)/a1^2 + (x2 x2'' + x2'^2)/a2^2) - 2 g x_i/a_i^2 = 0.
// Along a straight path x3'' = -2K. For K = g/2 it is a free fall, and the hill's push g - 2K is zero.

#include <string>

#include "chapters/03_rigid_body_motion/11_paraboloid_hill/drawing.hpp"
#include "chapters/03_rigid_body_motion/11_paraboloid_hill/paraboloid_hill.hpp"
#include "chapters/energies.hpp"
#include "chapters/in_float.hpp"

namespace oddity {

namespace ex03_11 {

using namespace paraboloid_hill;

constexpr Parameter parameters[] = {
    {"a1", 1, "m", "half axis of the section one metre below the top", 1e-2, 1e5},
    {"a2", 2, "m", "the other half axis", 1e-2, 1e5},
    {"g", 10, "m/s^2", "gravity", 1e-3, 1e4},
    {"v1", 2, "m/s", "direction of the straight path; its speed follows from the condition", 1e-2, 1e3},
    {"v2", 2, "m/s", "direction of the straight path", 1e-2, 1e3},
    {"factor", 0.75, "", "speed of the neighbouring path over that of the straight one", 1e-3, 0.999},
    {"offset", 0.25, "m", "distance from the top at which another neighbour starts", 1e-3, 1e3},
    {"seed", 311, "", "seed of the random samples", 0, 1e9, whole_number},
};

// ---- the motions ------------------------------------------------------------------------------------------

Case<double> beside(Case<double> c, double offset) {
  c.p = {0, offset};
  return c;
}

const std::string line = "straight line", plane = "height field", space = "Cartesian with constraint";

Quantity path(const std::string& name, const std::string& says, const Case<double>& c, bool straight,
              const Horizon& horizon, const Reference& truth) {
  Quantity position = quantity(
      name, "m", says,
      trajectory(truth, "03_11_hill", {c.hill.a1, c.hill.a2, c.g, c.p[0], c.p[1], c.v[0], c.v[1]}, horizon),
      {});
  position.need = {1e-8 * size_of(position.reference.value), "eight digits of the farthest coordinate"};
  SceneMethods methods(position, horizon, halving("step", 0.125, 9), tolerances(3, 11));
  if (straight)
    methods.closed_form(line, StraightLine<double>{c});
  else
    methods.closed_form(line, StraightLine<double>{c}, Outcome::inaccurate,
                        "the hill pushes, so that the motion is not uniform");
  methods.by_engine_integrators(plane, in_plane(c), straight ? Outcome::ok : Outcome::inaccurate)
      .by_engine_integrators(space, InSpace<double>{c})
      .by_core_integrators("momenta", in_momenta(c));
  return position;
}

/// From the top at this fraction of the straight path's speed.
Case<double> asked(const Parameters& p, double factor) {
  return from_the_top<double>({p["a1"], p["a2"], p["g"], p["v1"], p["v2"], factor});
}

constexpr auto low_order = "its order is too low for this need at this step";

Quantity slower(const Parameters& p, const Horizon& horizon, const Reference& truth) {
  const Case<double> c = asked(p, p["factor"]);
  Quantity position =
      path("slower",
           "position at " + times_up_to(horizon) + ", from the top at a part of the straight path's speed", c,
           false, horizon, truth);
  SceneMethods(position, horizon, halving("step", 0.125, 9), tolerances(3, 11))
      .by_remaining_integrators(plane, in_plane(c),
                                {{"modified midpoint", Outcome::inaccurate, low_order},
                                 {"linearly implicit Euler", Outcome::inaccurate, low_order}});
  return with_float(std::move(position), horizon,
                    Given<double>{p["a1"], p["a2"], p["g"], p["v1"], p["v2"], p["factor"]},
                    {line, plane, "momenta", space});
}

Energy energy(const Parameters& p, std::span<const double> x) { return point_energy(p["g"], x); }

/// Vertical distance from the hill.
double off(const Parameters& p, std::span<const double> x, double) {
  return std::abs(x[2] - paraboloid_hill::Hill<double>{p["a1"], p["a2"]}.height(x[0], x[1]));
}

Scene scene() {
  return {
      .motion = slower,
      .horizon = 2,
      .game_tolerance = centimeter,
      .sweep_parameter = "factor",
      .sweep_values = {0.99, 0.9, 0.75, 0.5, 0.2},
      .perturbed_parameters = {"v1", "v2"},
      .axes = {{"x1", "x2", "x3"}, "s", {{"m", {0, 1, 2}}}},
      .listing =
          {{"chapters/03_rigid_body_motion/11_paraboloid_hill/models.hpp"},
           {{"straight line",
             "paraboloid_hill::StraightLine<double>{paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor})}"},
            {"height field",
             "paraboloid_hill::in_plane(paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor}))"},
            {"Cartesian with constraint",
             "paraboloid_hill::InSpace<double>{paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor})}"},
            {"momenta",
             "paraboloid_hill::in_momenta(paraboloid_hill::from_the_top<double>({a1, a2, g, v1, v2, factor}))"}}},
      .draw = paraboloid_hill::draw<Parameters>,
      .laws = {energy, off},
  };
}

Findings study(const Parameters& p, const Reference& truth) {
  const Horizon horizon{scene().horizon};
  const Case<double> right = asked(p, 1);
  Quantity bent = motion(scene(), p, truth);
  bent.add(
      Breakdown{"At @3 times the straight path's speed the hill pushes, and the motion is not uniform: the "
                "closed form is off by up to @2 m within @2 s. The two equations of motion follow the path.",
                line + ", closed form",
                0,
                Outcome::inaccurate,
                plane + ", Runge-Kutta 4",
                0.0009765625,
                {p["factor"], error_of(Side::broken), horizon.end}});
  return {
      claims(p["seed"]),
      {path("straight", "position at " + times_up_to(horizon) + ", at the speed of the straight path", right,
            true, horizon, truth),
       bent,
       path("faster",
            filled("position at @3 times the straight path's speed, the hill holding the particle back",
                   {3 - 2 * p["factor"]}),
            asked(p, 3 - 2 * p["factor"]), false, horizon, truth),
       path("beside", "position in the same free fall from a start next to the top: straight as well",
            beside(right, p["offset"]), true, horizon, truth)},
      roots(),
      R"(The condition on the speed is right; {{straight at any speed|along an axis, and on a round hill, a path is straight at any speed}}, and {{a particle at rest|a particle at rest is left out}}.)"};
}

}  // namespace ex03_11

Exercise exercise_3_11() {
  using namespace ex03_11;
  return {"Straight paths on a paraboloid hill",
          "A particle slides without friction from the top of the hill $x_3 = -x_1^2/a_1^2 - x_2^2/a_2^2$. "
          "For which velocities is its motion over the plane $(v_1t, v_2t)$?",
          parameters,
          scene(),
          study,
          proofs,
          Expected::in_whole_ranges};
}

}  // namespace oddity
