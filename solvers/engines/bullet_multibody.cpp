// Bullet 3.24's btMultiBody [Featherstone's articulated bodies: BulletDynamics/Featherstone of its
// repository]: joints hold exactly, by reduced coordinates, and bodies on joints are trees.

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <map>

#include "solvers/engines/tree.hpp"

namespace oddity::engines {

namespace {

btVector3 vector(const Vector& v) { return {btScalar(v[0]), btScalar(v[1]), btScalar(v[2])}; }
Vector vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// A link as it is at the start. Those between two bodies' are without mass.
struct Link {
  btTransform place = btTransform::getIdentity();
  btVector3 velocity{0, 0, 0}, spin{0, 0, 0};
  btScalar mass = 0;
  btVector3 inertia{0, 0, 0};
  int index = -1;

  Link() = default;
  explicit Link(const Body& b)
      : velocity(vector(b.start.velocity)),
        spin(vector(b.start.spin)),
        mass(btScalar(b.mass)),
        inertia(vector(b.inertia)) {
    const auto& [w, x, y, z] = b.start.orientation;
    place = btTransform(btQuaternion(btScalar(x), btScalar(y), btScalar(z), btScalar(w)),
                        vector(b.start.position));
  }
  Link between(const btVector3& at, const btVector3& added_spin) const {
    Link link = *this;
    link.place.setOrigin(at), link.mass = 0, link.inertia.setZero();
    link.spin += added_spin;
    return link;
  }
  btVector3 velocity_at(const btVector3& at) const { return velocity + spin.cross(at - place.getOrigin()); }
};

/// A multibody that is being made.
class Tree {
 public:
  Tree(const Link& base, bool fixed, int links)
      : body_(std::make_unique<btMultiBody>(links, base.mass, base.inertia, fixed, false)), base_(base) {}

  void add(const Joint& j, const Link& a, Link& b) {
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
  std::unique_ptr<btMultiBody> finished() {
    body_->setBasePos(base_.place.getOrigin());
    body_->setWorldToBaseRot(base_.place.getRotation().inverse());
    body_->finalizeMultiDof();
    body_->setBaseVel(base_.velocity);
    body_->setBaseOmega(base_.spin);
    for (int i = 0; i < next_; ++i) body_->setJointVelMultiDof(i, &speeds_[i][0]);
    return std::move(body_);
  }

 private:
  struct Offsets {
    btQuaternion turn;
    btVector3 to_pivot, to_center;
  };
  static Offsets offsets(const Link& a, const Link& b, const btVector3& pivot) {
    return {b.place.getRotation().inverse() * a.place.getRotation(), a.place.inverse() * pivot,
            local(b, b.place.getOrigin() - pivot)};
  }
  static btVector3 local(const Link& link, const btVector3& v) {
    return quatRotate(link.place.getRotation().inverse(), v);
  }

  void revolute(const Link& a, Link& b, const btVector3& at, const btVector3& axis) {
    const auto [turn, to_pivot, to_center] = offsets(a, b, at);
    body_->setupRevolute(next_, b.mass, b.inertia, a.index, turn, local(b, axis), to_pivot, to_center, true);
    started(b, {axis.dot(b.spin - a.spin), 0, 0});
  }
  void spherical(const Link& a, Link& b, const btVector3& at) {
    const auto [turn, to_pivot, to_center] = offsets(a, b, at);
    body_->setupSpherical(next_, b.mass, b.inertia, a.index, turn, to_pivot, to_center, true);
    started(b, local(b, b.spin - a.spin));
  }
  void started(Link& link, const btVector3& speed) {
    link.index = next_++;
    speeds_.push_back(speed);
  }

  std::unique_ptr<btMultiBody> body_;
  Link base_;
  int next_ = 0;
  std::vector<btVector3> speeds_;
};

class InBullet final : public Simulation {
 public:
  InBullet(const World& world, const std::string& variant) : variant_(variant) {
    set_gravity(world.gravity);
    if (variant != "defaults") {
      world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
      world_.getSolverInfo().m_erp2 = 0;
    }
    std::vector<std::vector<Limb>> trees;
    for (const Limb& limb : tree(world)) {
      if (trees.empty() || !limb.joint) trees.emplace_back();
      trees.back().push_back(limb);
    }
    links_.resize(world.bodies.size());
    for (const auto& limbs : trees) add(world, limbs);
    if (world.floor != Vector{}) add_floor(world);
  }
  ~InBullet() override {
    for (const auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    for (const auto& body : bodies_) world_.removeMultiBody(body.get());
    if (floor_) world_.removeRigidBody(floor_.get());
  }
  InBullet(const InBullet&) = delete;
  InBullet& operator=(const InBullet&) = delete;

  void set_gravity(const Vector& g) override { world_.setGravity(vector(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    const auto [in, link] = of(body);
    const btVector3 f = vector(force), torque = (vector(at) - in->localPosToWorld(link, {0, 0, 0})).cross(f);
    link < 0 ? in->addBaseForce(f) : in->addLinkForce(link, f);
    link < 0 ? in->addBaseTorque(torque) : in->addLinkTorque(link, torque);
  }
  void step(double seconds) override { world_.stepSimulation(btScalar(seconds), 1, btScalar(seconds)); }
  State state(int body) const override {
    const auto [in, link] = of(body);
    const auto size = static_cast<std::size_t>(in->getNumLinks() + 1), i = static_cast<std::size_t>(link + 1);
    std::vector<btVector3> spins(size), velocities(size);
    in->compTreeLinkVelocities(spins.data(), velocities.data());
    btQuaternion to_local = btQuaternion::getIdentity();
    for (int k = link; k >= 0; k = in->getParent(k)) to_local = to_local * in->getParentToLocalRot(k);
    const btQuaternion q = (to_local * in->getWorldToBaseRot()).inverse();
    return {vector(in->localPosToWorld(link, {0, 0, 0})),
            {q.w(), q.x(), q.y(), q.z()},
            vector(quatRotate(q, velocities[i])),
            vector(quatRotate(q, spins[i]))};
  }

 private:
  struct Place {
    btMultiBody* in;
    int link;
  };
  const Place& of(int body) const { return links_[static_cast<std::size_t>(body)]; }

  void add(const World& world, const std::vector<Limb>& limbs) {
    const auto body_of = [&](int i) -> const Body& { return world.bodies[static_cast<std::size_t>(i)]; };
    const bool fixed = limbs[0].joint.has_value();
    int count = 0;
    for (const Limb& limb : limbs)
      if (limb.joint)
        count += limb.joint->kind == Joint::rod ? 3 : limb.joint->kind == Joint::cylinder ? 2 : 1;
    Tree tree(fixed ? Link() : Link(body_of(limbs[0].body)), fixed, count);
    std::map<int, Link> made;
    made[ground] = Link();
    for (const Limb& limb : limbs) {
      Link& link = made[limb.body] = Link(body_of(limb.body));
      if (limb.joint) tree.add(*limb.joint, made[limb.parent], link);
    }
    bodies_.push_back(tree.finished());
    btMultiBody& body = *bodies_.back();
    if (variant_ != "defaults") {
      body.setLinearDamping(0);
      body.setAngularDamping(0);
      body.setMaxCoordinateVelocity(btScalar(BT_LARGE_FLOAT));
    }
    body.useRK4Integration(variant_ == "Runge-Kutta 4");
    world_.addMultiBody(&body);
    for (const Limb& limb : limbs) {
      links_[static_cast<std::size_t>(limb.body)] = {&body, made[limb.body].index};
      cover(world, limb.body, made[limb.body]);
    }
  }
  void cover(const World& world, int i, const Link& link) {
    const Shape& shape = world.bodies[static_cast<std::size_t>(i)].shape;
    if (shape.kind == Shape::none) return;
    if (shape.kind == Shape::ball)
      shapes_.push_back(std::make_unique<btSphereShape>(btScalar(shape.half[0])));
    if (shape.kind == Shape::box) shapes_.push_back(std::make_unique<btBoxShape>(vector(shape.half)));
    colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(of(i).in, link.index));
    btMultiBodyLinkCollider& collider = *colliders_.back();
    collider.setCollisionShape(shapes_.back().get());
    collider.setWorldTransform(link.place);
    rub(collider, world);
    if (variant_ != "defaults") collider.setContactProcessingThreshold(0);
    world_.addCollisionObject(&collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
    link.index < 0 ? of(i).in->setBaseCollider(&collider)
                   : void(of(i).in->getLink(link.index).m_collider = &collider);
  }
  void add_floor(const World& world) {
    const btVector3 normal = vector(world.floor), half(50, 50, 50);
    if (variant_ == "defaults")
      shapes_.push_back(std::make_unique<btStaticPlaneShape>(normal, 0));
    else
      shapes_.push_back(std::make_unique<btBoxShape>(half));
    floor_ = std::make_unique<btRigidBody>(0, nullptr, shapes_.back().get());
    if (variant_ != "defaults")
      floor_->setWorldTransform(btTransform(shortestArcQuat({0, 1, 0}, normal), normal * -half.y()));
    rub(*floor_, world);
    world_.addRigidBody(floor_.get());
  }
  /// Of two bodies that touch, coefficients are multiplied.
  static void rub(btCollisionObject& object, const World& world) {
    object.setFriction(btScalar(std::sqrt(world.friction)));
    object.setRestitution(btScalar(std::sqrt(world.restitution)));
  }

  std::string variant_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btMultiBodyConstraintSolver solver_;
  btMultiBodyDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::vector<std::unique_ptr<btMultiBody>> bodies_;
  std::unique_ptr<btRigidBody> floor_;
  std::vector<Place> links_;
};

}  // namespace

Engine engine() {
  const bool in_float = sizeof(btScalar) == sizeof(float);
  return {
      in_float ? "Bullet multibody" : "Bullet multibody in double",
      std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100),
      in_float ? "float" : "double",
      false,
      {{"defaults",
        "velocities are damped by 0.04/s and by 0.04 of their squares, and are 100 m/s and rad/s at most; "
        "a contact brakes before it touches, and gives speed where it is deep",
        1, true, "velocities are damped, and a contact brakes before it touches"},
       {"no damping",
        "no damping (setLinearDamping, setAngularDamping), and no bound (setMaxCoordinateVelocity); what "
        "is slow bounces too (m_restitutionVelocityThreshold), contacts act when they touch "
        "(setContactProcessingThreshold) and give no speed (m_erp2), and the floor is a box",
        1, false},
       {"Runge-Kutta 4", "the same and useRK4Integration(true)", 4, false}},
      [](const World& world, const std::string& variant, double) -> std::unique_ptr<Simulation> {
        return std::make_unique<InBullet>(world, variant);
      }};
}

}  // namespace oddity::engines
