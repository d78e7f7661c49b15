// DART's skeletons of bodies and joints, and their shapes [dartsim.github.io].

#include "extras/engines/adapters/dart_world.hpp"

#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/UniversalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>

namespace oddity::engines {

using namespace dart::dynamics;
using Eigen::Isometry3d;
using Eigen::Vector3d;

namespace {

Isometry3d moved(const Vector& to) { return Isometry3d(Eigen::Translation3d(vec(to))); }
Isometry3d pose(const State& s) {
  const auto& q = s.orientation;
  return moved(s.position) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}

/// A joint whose frames in both bodies coincide in the world at the start.
template <class Kind>
std::pair<Kind*, BodyNode*> hang(const SkeletonPtr& skeleton, BodyNode* parent, const Isometry3d& at,
                                 const Isometry3d& body) {
  const auto [joint, node] = skeleton->createJointAndBodyNodePair<Kind>(parent);
  if (parent)
    joint->setTransformFromParentBodyNode(parent->getTransform().inverse() * at);
  else
    joint->setTransformFromParentBodyNode(at);
  joint->setTransformFromChildBodyNode(body.inverse() * at);
  return {joint, node};
}
BodyNode* without_mass(BodyNode* link) {
  link->setInertia(Inertia(0, Vector3d::Zero(), Eigen::Matrix3d::Zero()));
  return link;
}

/// DART takes the smaller friction of two bodies, and the product of their restitutions.
void give(BodyNode* node, const ShapePtr& shape, const World& world) {
  auto* const surface =
      node->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape)->getDynamicsAspect();
  surface->setFrictionCoeff(world.friction);
  surface->setRestitutionCoeff(std::sqrt(world.restitution));
}

}  // namespace

DartWorld::DartWorld(const World& world) : bodies_(world.bodies.size()) {
  for (const Limb& limb : tree(world)) {
    if (limb.parent == ground) skeletons_.push_back(Skeleton::create());
    add(limb, world);
  }
  if (world.floor != Vector{}) lay_floor(world);
  for (const SkeletonPtr& s : skeletons_) dart_->addSkeleton(s);
}

void DartWorld::add(const Limb& limb, const World& world) {
  const Body& b = body_of(world, limb.body);
  BodyNode* const node = join(limb, pose(b.start));
  node->setInertia(Inertia(b.mass, Vector3d::Zero(), vec(b.inertia).asDiagonal()));
  bodies_[static_cast<std::size_t>(limb.body)] = node;
  const Vector3d half = vec(b.shape.half);
  if (b.shape.kind == Shape::ball) give(node, std::make_shared<SphereShape>(half[0]), world);
  if (b.shape.kind == Shape::box) give(node, std::make_shared<BoxShape>(2 * half), world);
}

/// DART has no cylinder joint and no rod: each is two joints with a massless link between them.
BodyNode* DartWorld::join(const Limb& limb, const Isometry3d& body) {
  const SkeletonPtr& skeleton = skeletons_.back();
  BodyNode* parent = limb.parent == ground ? nullptr : (*this)[limb.parent];
  if (!limb.joint) return hang<FreeJoint>(skeleton, parent, body, body).second;
  const Joint& j = *limb.joint;
  const Isometry3d at = moved(j.at);
  if (j.kind == Joint::ball) return hang<BallJoint>(skeleton, parent, at, body).second;
  if (j.kind == Joint::rod) {
    const Universal across(j);
    const auto [turns, link] = hang<UniversalJoint>(skeleton, parent, at, at);
    turns->setAxis1(vec(across.first));
    turns->setAxis2(vec(across.second));
    return hang<BallJoint>(skeleton, without_mass(link), moved(j.end), body).second;
  }
  if (j.kind == Joint::cylinder) {
    const auto [slide, link] = hang<PrismaticJoint>(skeleton, parent, at, at);
    slide->setAxis(vec(j.axis));
    parent = without_mass(link);
  }
  const auto [hinge, node] = hang<RevoluteJoint>(skeleton, parent, at, body);
  hinge->setAxis(vec(j.axis));
  return node;
}

void DartWorld::lay_floor(const World& world) {
  constexpr double wide = 200, thick = 2;
  const Vector3d up = vec(world.floor).normalized();
  const SkeletonPtr floor = Skeleton::create("floor");
  const auto [joint, node] = floor->createJointAndBodyNodePair<WeldJoint>();
  joint->setTransformFromParentBodyNode(
      Eigen::Translation3d(-thick / 2 * up) *
      Isometry3d(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), up)));
  give(node, std::make_shared<BoxShape>(Vector3d(wide, wide, thick)), world);
  floor->setMobile(false);
  dart_->addSkeleton(floor);
}

}  // namespace oddity::engines
