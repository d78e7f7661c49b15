// Bullet 3.24's btMultiBody [Featherstone's articulated bodies: BulletDynamics/Featherstone of its
// repository]: joints hold exactly, by reduced coordinates, and bodies on joints are trees.

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include <map>

#include "solvers/engines/bullet_tree.hpp"

namespace oddity::engines {

namespace {

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
    BulletTree tree(fixed ? Link() : Link(body_of(limbs[0].body)), fixed, count);
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
    shapes_.push_back(shaped(shape));
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
    floor_ = floor_of(world, variant_ != "defaults", shapes_);
    rub(*floor_, world);
    world_.addRigidBody(floor_.get());
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

Engine engine() { return bullet("Bullet multibody", make<InBullet>); }

}  // namespace oddity::engines
