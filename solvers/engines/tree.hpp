#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "solvers/engines/simulation.hpp"

/// A world for engines of reduced coordinates: every body hangs on the ground or on another by one joint.
namespace oddity::engines {

struct Limb {
  int body;
  int parent = ground;
  std::optional<Joint> joint = {};  ///< a is the parent, b the body; none: the body is free
};

/// Depth first, parents before what hangs on them.
inline std::vector<Limb> tree(const World& world) {
  std::vector<Limb> limbs;
  std::vector<bool> used(world.joints.size());
  const auto has = [&](int body) { return std::ranges::find(limbs, body, &Limb::body) != limbs.end(); };
  const auto grow = [&](auto& self, int parent) -> void {
    for (std::size_t i = 0; i < used.size(); ++i) {
      Joint j = world.joints[i];
      if (used[i] || (j.a != parent && j.b != parent)) continue;
      used[i] = true;
      if (j.b == parent) std::swap(j.a, j.b), std::swap(j.at, j.end);
      if (j.kind != Joint::rod) j.at = j.end = world.joints[i].at;
      if (j.b == ground || has(j.b))
        throw NotExpressible("a loop of joints: in reduced coordinates they are a tree");
      limbs.push_back({j.b, parent, j});
      self(self, j.b);
    }
  };
  grow(grow, ground);
  for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
    if (!has(i)) limbs.push_back({i}), grow(grow, i);
  return limbs;
}

/// Two axes across a rod and each other: about the first, which is z for a rod in the plane, and then about
/// the second it turns to every direction; the two angles are singular where it lies along the first.
struct Universal {
  Vector along, first, second;
  explicit Universal(const Joint& rod) {
    const Vector u{rod.end[0] - rod.at[0], rod.end[1] - rod.at[1], rod.end[2] - rod.at[2]};
    along = scaled(u, 1 / std::hypot(u[0], u[1], u[2]));
    first = std::abs(along[2]) < 0.9 ? cross({0, 0, 1}) : cross({1, 0, 0});
    first = scaled(first, 1 / std::hypot(first[0], first[1], first[2]));
    second = first;
    first = scaled(cross(first), -1);
  }

 private:
  static Vector scaled(const Vector& a, double s) { return {s * a[0], s * a[1], s * a[2]}; }
  /// The rod's direction times b.
  Vector cross(const Vector& b) const {
    const Vector& a = along;
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
};

}  // namespace oddity::engines
