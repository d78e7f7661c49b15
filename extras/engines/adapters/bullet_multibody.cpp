// Bullet 3.24's btMultiBody [Featherstone's articulated bodies: BulletDynamics/Featherstone of its
// repository]: joints are exact, by reduced coordinates, and bodies on joints are trees.

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>

#include "extras/engines/adapters/bullet_tree.hpp"

namespace oddity::engines {

namespace {

class InBullet final : public BulletSimulation<btMultiBodyConstraintSolver, btMultiBodyDynamicsWorld> {
 public:
  InBullet(const World& world, const std::string& variant) : variant_(variant), links_(world.bodies.size()) {
    set_gravity(world.gravity);
    if (variant != "defaults") {
      world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
      world_.getSolverInfo().m_erp2 = 0;
    }
    for (const auto& limbs : trees(world)) add(world, limbs);
    if (world.floor == Vector{}) return;
    floor_ = floor_of(world, variant != "defaults", shapes_);
    world_.addRigidBody(floor_.get());
  }
  ~InBullet() override {
    for (const auto& collider : colliders_) world_.removeCollisionObject(collider.get());
    for (const auto& body : bodies_) world_.removeMultiBody(body.get());
    if (floor_) world_.removeRigidBody(floor_.get());
  }

  void push(int body, const Vector& force, const Vector& at) override {
    const auto [in, link] = of(body);
    const btVector3 f = vector(force), torque = (vector(at) - in->localPosToWorld(link, {0, 0, 0})).cross(f);
    link < 0 ? in->addBaseForce(f) : in->addLinkForce(link, f);
    link < 0 ? in->addBaseTorque(torque) : in->addLinkTorque(link, torque);
  }
  State state(int body) const override {
    const auto [in, link] = of(body);
    const auto size = static_cast<std::size_t>(in->getNumLinks() + 1), i = static_cast<std::size_t>(link + 1);
    std::vector<btVector3> spins(size), velocities(size);
    in->compTreeLinkVelocities(spins.data(), velocities.data());
    btQuaternion to_local = btQuaternion::getIdentity();
    for (int k = link; k >= 0; k = in->getParent(k)) to_local = to_local * in->getParentToLocalRot(k);
    const btQuaternion q = (to_local * in->getWorldToBaseRot()).inverse();
    return engines::state(in->localPosToWorld(link, {0, 0, 0}), q, quatRotate(q, velocities[i]),
                          quatRotate(q, spins[i]));
  }

 private:
  struct Place {
    btMultiBody* in;
    int link;
  };
  const Place& of(int body) const { return links_[static_cast<std::size_t>(body)]; }

  void add(const World& world, const std::vector<Limb>& limbs) {
    BulletTree tree(world, limbs);
    btMultiBody& body = *bodies_.emplace_back(tree.finished());
    if (variant_ != "defaults") {
      body.setLinearDamping(0);
      body.setAngularDamping(0);
      body.setMaxCoordinateVelocity(btScalar(BT_LARGE_FLOAT));
    }
    body.useRK4Integration(variant_ == "Runge-Kutta 4");
    world_.addMultiBody(&body);
    for (const Limb& limb : limbs) {
      links_[static_cast<std::size_t>(limb.body)] = {&body, tree.link(limb.body).index};
      cover(world, limb.body, tree.link(limb.body));
    }
  }
  void cover(const World& world, int i, const Link& link) {
    const Shape& shape = body_of(world, i).shape;
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

  std::string variant_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
  std::vector<std::unique_ptr<btMultiBody>> bodies_;
  std::unique_ptr<btRigidBody> floor_;
  std::vector<Place> links_;
};

}  // namespace

Engine engine() { return bullet("Bullet multibody", make<InBullet>); }

}  // namespace oddity::engines
