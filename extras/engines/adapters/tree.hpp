#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "extras/engines/adapters/simulation.hpp"
#include "solvers/turns.hpp"

/// A world for engines with reduced coordinates: every body hangs on the ground or on another body by one
/// joint.
namespace oddity::engines {

struct Limb {
  int body;
  int parent = ground;
  std::optional<Joint> joint = {};  ///< a is the parent, b the body; none: the body is free
};

/// Depth first, parents before their children.
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

/// Two axes across a rod and each other. Turning about the first, which is z for a rod in the plane, and then
/// about the second reaches every direction. The two angles are singular where the rod is along the first
/// axis.
struct Universal {
  Vector along, first, second;
  explicit Universal(const Joint& rod) {
    const auto unit = [](const Vector& a) { return 1 / std::hypot(a[0], a[1], a[2]) * a; };
    along = unit(rod.end - rod.at);
    second = unit(cross(along, std::abs(along[2]) < 0.9 ? Vector{0, 0, 1} : Vector{1, 0, 0}));
    first = -1.0 * cross(along, second);
  }
};

}  // namespace oddity::engines
