#pragma once

#include <algorithm>
#include <cmath>

#include "extras/engines/adapters/simulation.hpp"

/// Checks for engines of the plane, as a world has three dimensions. In the plane a ball joint is a hinge,
/// and on a cylinder joint nothing turns: no force in the plane has a moment about an axis in it.
namespace oddity::engines {

/// Throws NotExpressible unless everything is in x and y, and turns about z.
inline void expect_in_plane(const World& world) {
  const auto flat = [](const Vector& v) { return v[2] == 0; };
  const auto upright = [](const Vector& v) { return v[0] == 0 && v[1] == 0; };
  const bool in_plane =
      flat(world.gravity) && flat(world.shaking) && flat(world.floor) && upright(world.turning) &&
      std::ranges::all_of(world.bodies,
                          [&](const Body& b) {
                            const State& s = b.start;
                            return flat(s.position) && flat(s.velocity) && upright(s.spin) &&
                                   upright({s.orientation[1], s.orientation[2], 0});
                          }) &&
      std::ranges::all_of(world.joints,
                          [&](const Joint& j) {
                            return flat(j.at) && (j.kind != Joint::hinge || upright(j.axis)) &&
                                   (j.kind != Joint::cylinder || flat(j.axis)) &&
                                   (j.kind != Joint::rod || flat(j.end));
                          }) &&
      std::ranges::all_of(world.springs, [&](const Spring& s) { return flat(s.at) && flat(s.end); });
  if (!in_plane) throw NotExpressible("the plane of x and y alone");
}

inline double angle(const Quaternion& q) { return 2 * std::atan2(q[3], q[0]); }
inline Quaternion about_z(double angle) { return {std::cos(angle / 2), 0, 0, std::sin(angle / 2)}; }

}  // namespace oddity::engines
