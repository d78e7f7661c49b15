// Bullet 3.24's rigid bodies [manual: docs/Bullet_User_Manual.pdf of its repository]: joints by impulses.

#include "extras/engines/adapters/bullet.hpp"

namespace oddity::engines {

namespace {

class InBullet final : public BulletSimulation<btSequentialImpulseConstraintSolver, btDiscreteDynamicsWorld> {
 public:
  InBullet(const World& world, const std::string& variant) : fine_(variant != "defaults") {
    if (fine_) {
      world_.getSolverInfo().m_numIterations = 100;
      world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
      world_.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
    }
    set_gravity(world.gravity);
    for (const Body& b : world.bodies) add(b, world);
    if (world.floor != Vector{}) bodies_.push_back(floor_of(world, fine_, shapes_));
    for (const auto& body : bodies_) world_.addRigidBody(body.get());
    for (const Joint& j : world.joints) add(j);
  }
  ~InBullet() override {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void push(int body, const Vector& force, const Vector& at) override {
    of(body).applyForce(vector(force), vector(at) - of(body).getCenterOfMassPosition());
  }
  State state(int body) const override {
    const btRigidBody& b = of(body);
    return engines::state(b.getCenterOfMassPosition(), b.getOrientation(), b.getLinearVelocity(),
                          b.getAngularVelocity());
  }

 private:
  btRigidBody& of(int body) const {
    return body == ground ? btTypedConstraint::getFixedBody() : *bodies_[static_cast<std::size_t>(body)];
  }
  /// The joint's point and axis in the body's frame; Bullet's hinges turn about z, its sliders about x.
  btTransform in(int body, const Joint& j) const {
    const btVector3 own = j.kind == Joint::cylinder ? btVector3(1, 0, 0) : btVector3(0, 0, 1);
    const btTransform in_world(shortestArcQuat(own, vector(j.axis)), vector(j.at));
    return of(body).getCenterOfMassTransform().inverse() * in_world;
  }

  void add(const Body& b, const World& world) {
    shapes_.push_back(shaped(b.shape));
    const btRigidBody::btRigidBodyConstructionInfo info(btScalar(b.mass), nullptr, shapes_.back().get(),
                                                        vector(b.inertia));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    rub(body, world);
    body.setCenterOfMassTransform(place(b.start));
    body.setLinearVelocity(vector(b.start.velocity));
    body.setAngularVelocity(vector(b.start.spin));
    if (fine_) body.setActivationState(DISABLE_DEACTIVATION);
    if (fine_) body.setContactProcessingThreshold(0);
  }
  static auto cylinder(btRigidBody& a, btRigidBody& b, const btTransform& in_a, const btTransform& in_b) {
    auto slider = std::make_unique<btSliderConstraint>(a, b, in_a, in_b, true);
    slider->setLowerAngLimit(1), slider->setUpperAngLimit(-1);  // no limit: the upper is below the lower
    return slider;
  }
  void add(const Joint& j) {
    if (j.kind == Joint::rod) throw NotExpressible("no joint that keeps a distance");
    btRigidBody &a = of(j.a), &b = of(j.b);
    const btTransform in_a = in(j.a, j), in_b = in(j.b, j);
    std::unique_ptr<btTypedConstraint> joint;
    if (j.kind == Joint::hinge)
      joint = std::make_unique<btHingeConstraint>(a, b, in_a, in_b);
    else if (j.kind == Joint::ball)
      joint = std::make_unique<btPoint2PointConstraint>(a, b, in_a.getOrigin(), in_b.getOrigin());
    else
      joint = cylinder(a, b, in_a, in_b);
    world_.addConstraint(joint.get(), true);
    joints_.push_back(std::move(joint));
  }

  bool fine_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace

Engine engine() { return bullet("Bullet", make<InBullet>); }

}  // namespace oddity::engines
