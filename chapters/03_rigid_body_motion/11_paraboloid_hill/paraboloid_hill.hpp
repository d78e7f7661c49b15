#pragma once

// The quantities of exercise 3.11.

#include <string>

#include "chapters/03_rigid_body_motion/11_paraboloid_hill/models.hpp"
#include "chapters/03_rigid_body_motion/shared/height_field.hpp"
#include "chapters/scene.hpp"

namespace oddity::paraboloid_hill {

inline Case<double> beside(Case<double> c, double offset) {
  c.p = {0, offset};
  return c;
}

inline const std::string line = "straight line", plane = "height field", space = "Cartesian with constraint";

inline Quantity path(const std::string& name, const std::string& says, const Case<double>& c, bool straight,
                     const Horizon& horizon, const Reference& truth) {
  Quantity position = quantity(
      name, "m", says,
      trajectory(truth, "03_11_hill", {c.hill.a1, c.hill.a2, c.g, c.p[0], c.p[1], c.v[0], c.v[1]}, horizon),
      {});
  position.need = {1e-8 * size_of(position.reference.value), "eight digits of the farthest coordinate"};
  Ladder ladder(position, horizon, halving("step", 0.125, 9), tolerances(3, 11));
  if (straight)
    ladder.closed_form(line, StraightLine<double>{c});
  else
    ladder.closed_form(line, StraightLine<double>{c}, Outcome::inaccurate,
                       "the hill pushes, and not along the line");
  ladder.by_common(plane, in_plane(c), straight ? Outcome::ok : Outcome::inaccurate)
      .by_common(space, InSpace<double>{c})
      .by_few("momenta", in_momenta(c));
  return position;
}

}  // namespace oddity::paraboloid_hill
