// DART 6.12 [dartsim.github.io]: reduced coordinates, contacts held by velocities, in double.

#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/UniversalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "solvers/engines/tree.hpp"

namespace oddity::engines {

namespace {

using namespace dart::dynamics;
using Eigen::Isometry3d;
using Eigen::Vector3d;

Vector3d vec(const Vector& a) { return {a[0], a[1], a[2]}; }
Vector vector(const Vector3d& a) { return {a[0], a[1], a[2]}; }
Isometry3d moved(const Vector& to) { return Isometry3d(Eigen::Translation3d(vec(to))); }
Isometry3d pose(const State& s) {
  const auto& q = s.orientation;
  return moved(s.position) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
}

class InDart final : public Simulation {
 public:
  InDart(const World& world, const std::string& variant)
      : world_(dart::simulation::World::create()), bodies_(world.bodies.size()) {
    set_gravity(world.gravity);
    if (variant == "native collision detector")
      world_->getConstraintSolver()->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
    for (const Limb& limb : tree(world)) {
      if (limb.parent == ground) skeletons_.push_back(Skeleton::create());
      add(limb, world);
    }
    if (world.floor != Vector{}) lay_floor(world);
    for (const SkeletonPtr& s : skeletons_) world_->addSkeleton(s);
    start(world);
  }

  void set_gravity(const Vector& g) override { world_->setGravity(vec(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    of(body)->addExtForce(vec(force), vec(at), false, false);
  }
  void step(double seconds) override {
    world_->setTimeStep(seconds);
    world_->step();
  }
  State state(int body) const override {
    const BodyNode& b = *of(body);
    const Eigen::Quaterniond q(b.getTransform().linear());
    return {vector(b.getTransform().translation()),
            {q.w(), q.x(), q.y(), q.z()},
            vector(b.getLinearVelocity()),
            vector(b.getAngularVelocity())};
  }
  bool save() override {
    saved_.clear();
    for (const SkeletonPtr& s : skeletons_) saved_.push_back(s->getConfiguration());
    return true;
  }
  void restore() override {
    for (std::size_t i = 0; i < saved_.size(); ++i) skeletons_[i]->setConfiguration(saved_[i]);
  }

 private:
  BodyNode* of(int body) const { return body == ground ? nullptr : bodies_[static_cast<std::size_t>(body)]; }

  /// A joint whose frame is, at the start, in one place in the world as seen from both.
  template <class Kind>
  std::pair<Kind*, BodyNode*> add(BodyNode* parent, const Isometry3d& at, const Isometry3d& body) {
    const auto [joint, node] = skeletons_.back()->createJointAndBodyNodePair<Kind>(parent);
    if (parent)
      joint->setTransformFromParentBodyNode(parent->getTransform().inverse() * at);
    else
      joint->setTransformFromParentBodyNode(at);
    joint->setTransformFromChildBodyNode(body.inverse() * at);
    return {joint, node};
  }
  /// There is no cylinder joint and no rod: a link without mass is between two joints.
  void add(const Limb& limb, const World& world) {
    const Body& b = world.bodies[static_cast<std::size_t>(limb.body)];
    const Isometry3d body = pose(b.start);
    BodyNode *parent = of(limb.parent), *node;
    if (!limb.joint) {
      node = add<FreeJoint>(parent, body, body).second;
    } else if (const Joint& j = *limb.joint; j.kind == Joint::ball) {
      node = add<BallJoint>(parent, moved(j.at), body).second;
    } else if (j.kind == Joint::rod) {
      const Universal across(j);
      const auto [link, middle] = add<UniversalJoint>(parent, moved(j.at), moved(j.at));
      link->setAxis1(vec(across.first));
      link->setAxis2(vec(across.second));
      middle->setInertia(Inertia(0, Vector3d::Zero(), Eigen::Matrix3d::Zero()));
      node = add<BallJoint>(middle, moved(j.end), body).second;
    } else {
      if (j.kind == Joint::cylinder) {
        const auto [slide, middle] = add<PrismaticJoint>(parent, moved(j.at), moved(j.at));
        slide->setAxis(vec(j.axis));
        middle->setInertia(Inertia(0, Vector3d::Zero(), Eigen::Matrix3d::Zero()));
        parent = middle;
      }
      const auto [hinge, turning] = add<RevoluteJoint>(parent, moved(j.at), body);
      hinge->setAxis(vec(j.axis));
      node = turning;
    }
    node->setInertia(Inertia(b.mass, Vector3d::Zero(), vec(b.inertia).asDiagonal()));
    bodies_[static_cast<std::size_t>(limb.body)] = node;
    const Vector3d half = vec(b.shape.half);
    if (b.shape.kind == Shape::ball) give(node, std::make_shared<SphereShape>(half[0]), world);
    if (b.shape.kind == Shape::box) give(node, std::make_shared<BoxShape>(2 * half), world);
  }
  /// The lesser friction of two counts, and the product of their restitutions.
  static void give(BodyNode* node, const ShapePtr& shape, const World& world) {
    auto* const surface =
        node->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape)->getDynamicsAspect();
    surface->setFrictionCoeff(world.friction);
    surface->setRestitutionCoeff(std::sqrt(world.restitution));
  }
  void lay_floor(const World& world) {
    constexpr double wide = 200, thick = 2;
    const Vector3d up = vec(world.floor).normalized();
    const SkeletonPtr floor = Skeleton::create("floor");
    const auto [joint, node] = floor->createJointAndBodyNodePair<WeldJoint>();
    joint->setTransformFromParentBodyNode(
        Eigen::Translation3d(-thick / 2 * up) *
        Isometry3d(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), up)));
    give(node, std::make_shared<BoxShape>(Vector3d(wide, wide, thick)), world);
    floor->setMobile(false);
    world_->addSkeleton(floor);
  }
  /// The joints' velocities are those that the bodies' momenta give.
  void start(const World& world) {
    for (const SkeletonPtr& s : skeletons_) {
      Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s->getNumDofs()));
      for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (bodies_[i]->getSkeleton() != s) continue;
        const Body& b = world.bodies[i];
        const Eigen::Matrix3d R = bodies_[i]->getTransform().linear();
        Eigen::Vector6d momentum;
        momentum << R * vec(b.inertia).cwiseProduct(R.transpose() * vec(b.start.spin)),
            b.mass * vec(b.start.velocity);
        p += s->getWorldJacobian(bodies_[i]).transpose() * momentum;
      }
      if (p.size()) s->setVelocities(s->getMassMatrix().ldlt().solve(p));
    }
  }

  dart::simulation::WorldPtr world_;
  std::vector<SkeletonPtr> skeletons_;
  std::vector<BodyNode*> bodies_;
  std::vector<Skeleton::Configuration> saved_;
};

}  // namespace

Engine engine() { return {"DART", DART_VERSION, "double", false, make<InDart>}; }

}  // namespace oddity::engines
