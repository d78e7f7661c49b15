#pragma once

#include <dart/dynamics/BodyNode.hpp>
#include <dart/simulation/World.hpp>

#include "extras/engines/adapters/simulation.hpp"
#include "extras/engines/adapters/tree.hpp"

namespace oddity::engines {

inline Eigen::Vector3d vec(const Vector& a) { return {a[0], a[1], a[2]}; }

/// A world in DART's terms: one skeleton for each tree of bodies on joints.
class DartWorld {
 public:
  explicit DartWorld(const World&);
  dart::simulation::World& dart() const { return *dart_; }
  const std::vector<dart::dynamics::SkeletonPtr>& skeletons() const { return skeletons_; }
  dart::dynamics::BodyNode* operator[](int body) const { return bodies_[static_cast<std::size_t>(body)]; }

 private:
  void add(const Limb&, const World&);
  dart::dynamics::BodyNode* join(const Limb&, const Eigen::Isometry3d& body);
  void lay_floor(const World&);

  dart::simulation::WorldPtr dart_ = dart::simulation::World::create();
  std::vector<dart::dynamics::SkeletonPtr> skeletons_;
  std::vector<dart::dynamics::BodyNode*> bodies_;
};

}  // namespace oddity::engines
