// Links and joints of btMultiBody, with their initial speeds.

#include "extras/engines/adapters/bullet_tree.hpp"

namespace oddity::engines {

namespace {

btVector3 local(const Link& link, const btVector3& v) {
  return quatRotate(link.place.getRotation().inverse(), v);
}

struct Offsets {
  btQuaternion turn;
  btVector3 to_pivot, to_center;
};
Offsets offsets(const Link& a, const Link& b, const btVector3& pivot) {
  return {b.place.getRotation().inverse() * a.place.getRotation(), a.place.inverse() * pivot,
          local(b, b.place.getOrigin() - pivot)};
}

int links_for(const Joint& j) { return j.kind == Joint::rod ? 3 : j.kind == Joint::cylinder ? 2 : 1; }

}  // namespace

std::vector<std::vector<Limb>> trees(const World& world) {
  std::vector<std::vector<Limb>> trees;
  for (const Limb& limb : tree(world)) {
    if (trees.empty() || !limb.joint) trees.emplace_back();
    trees.back().push_back(limb);
  }
  return trees;
}

BulletTree::BulletTree(const World& world, const std::vector<Limb>& limbs) {
  const bool fixed = limbs[0].joint.has_value();
  if (!fixed) base_ = Link(body_of(world, limbs[0].body));
  int count = 0;
  for (const Limb& limb : limbs)
    if (limb.joint) count += links_for(*limb.joint);
  body_ = std::make_unique<btMultiBody>(count, base_.mass, base_.inertia, fixed, false);
  links_[ground] = Link();
  for (const Limb& limb : limbs) {
    Link& link = links_[limb.body] = Link(body_of(world, limb.body));
    if (limb.joint) add(*limb.joint, links_[limb.parent], link);
  }
}

void BulletTree::add(const Joint& j, const Link& a, Link& b) {
  const btVector3 at = vector(j.at), axis = vector(j.axis);
  if (j.kind == Joint::hinge) {
    revolute(a, b, at, axis);
  } else if (j.kind == Joint::ball) {
    spherical(a, b, at);
  } else if (j.kind == Joint::cylinder) {
    Link slide = a.between(at, {0, 0, 0});
    const auto [turn, to_pivot, to_center] = offsets(a, slide, at);
    body_->setupPrismatic(next_, 0, slide.inertia, a.index, turn, local(slide, axis), to_pivot, to_center,
                          true);
    started(slide, {axis.dot(b.velocity_at(at) - a.velocity_at(at)), 0, 0});
    revolute(slide, b, at, axis);
  } else {  // turns about two axes across the rod, and its end in a ball joint
    const Universal turns(j);
    const btVector3 end = vector(j.end), first = vector(turns.first), second = vector(turns.second);
    const btVector3 along = end - at, moves = b.velocity_at(end) - a.velocity_at(at);
    const btVector3 spin = along.cross(moves) / along.length2() - a.spin;
    Link knee = a.between(at, first * first.dot(spin)), rod = knee.between(end, second * second.dot(spin));
    revolute(a, knee, at, first);
    revolute(knee, rod, at, second);
    spherical(rod, b, end);
  }
}

std::unique_ptr<btMultiBody> BulletTree::finished() {
  body_->setBasePos(base_.place.getOrigin());
  body_->setWorldToBaseRot(base_.place.getRotation().inverse());
  body_->finalizeMultiDof();
  body_->setBaseVel(base_.velocity);
  body_->setBaseOmega(base_.spin);
  for (int i = 0; i < next_; ++i) body_->setJointVelMultiDof(i, &speeds_[i][0]);
  return std::move(body_);
}

void BulletTree::revolute(const Link& a, Link& b, const btVector3& at, const btVector3& axis) {
  const auto [turn, to_pivot, to_center] = offsets(a, b, at);
  body_->setupRevolute(next_, b.mass, b.inertia, a.index, turn, local(b, axis), to_pivot, to_center, true);
  started(b, {axis.dot(b.spin - a.spin), 0, 0});
}

void BulletTree::spherical(const Link& a, Link& b, const btVector3& at) {
  const auto [turn, to_pivot, to_center] = offsets(a, b, at);
  body_->setupSpherical(next_, b.mass, b.inertia, a.index, turn, to_pivot, to_center, true);
  started(b, local(b, b.spin - a.spin));
}

void BulletTree::started(Link& link, const btVector3& speed) {
  link.index = next_++;
  speeds_.push_back(speed);
}

}  // namespace oddity::engines
