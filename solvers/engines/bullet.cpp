// Bullet 3.24's rigid bodies [manual: docs/Bullet_User_Manual.pdf of its repository]: joints held
// by impulses. bullet_multibody.cpp has its other solver.

#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "solvers/engines/simulation.hpp"

namespace oddity::engines {

namespace {

btVector3 vector(const Vector& v) { return {btScalar(v[0]), btScalar(v[1]), btScalar(v[2])}; }
Vector vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

class InBullet final : public Simulation {
 public:
  InBullet(const World& world, bool fine) : fine_(fine) {
    if (fine) {
      world_.getSolverInfo().m_numIterations = 100;
      world_.getSolverInfo().m_restitutionVelocityThreshold = 0;
      world_.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
    }
    set_gravity(world.gravity);
    friction_ = btScalar(std::sqrt(world.friction)), restitution_ = btScalar(std::sqrt(world.restitution));
    for (const Body& b : world.bodies) add(b);
    for (const Joint& j : world.joints) add(j);
    if (world.floor != Vector{}) add_floor(vector(world.floor));
  }
  ~InBullet() override {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  InBullet(const InBullet&) = delete;
  InBullet& operator=(const InBullet&) = delete;

  void set_gravity(const Vector& g) override { world_.setGravity(vector(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    of(body).applyForce(vector(force), vector(at) - of(body).getCenterOfMassPosition());
  }
  void step(double seconds) override { world_.stepSimulation(btScalar(seconds), 1, btScalar(seconds)); }
  State state(int body) const override {
    const btRigidBody& b = of(body);
    const btQuaternion q = b.getOrientation();
    return {vector(b.getCenterOfMassPosition()),
            {q.w(), q.x(), q.y(), q.z()},
            vector(b.getLinearVelocity()),
            vector(b.getAngularVelocity())};
  }

 private:
  btRigidBody& of(int body) const {
    return body == ground ? btTypedConstraint::getFixedBody() : *bodies_[static_cast<std::size_t>(body)];
  }
  /// The joint's point and axis as the body has them; Bullet's hinges turn about z, its sliders about x.
  btTransform in(int body, const Joint& j) const {
    const btVector3 own = j.kind == Joint::cylinder ? btVector3(1, 0, 0) : btVector3(0, 0, 1);
    const btTransform in_world(shortestArcQuat(own, vector(j.axis)), vector(j.at));
    return of(body).getCenterOfMassTransform().inverse() * in_world;
  }
  static std::unique_ptr<btCollisionShape> shaped(const Shape& shape) {
    if (shape.kind == Shape::ball) return std::make_unique<btSphereShape>(btScalar(shape.half[0]));
    if (shape.kind == Shape::box) return std::make_unique<btBoxShape>(vector(shape.half));
    return std::make_unique<btEmptyShape>();
  }

  void add(const Body& b) {
    const auto& [w, x, y, z] = b.start.orientation;
    const btQuaternion turn{btScalar(x), btScalar(y), btScalar(z), btScalar(w)};
    btRigidBody& body = add(btScalar(b.mass), btTransform(turn, vector(b.start.position)), shaped(b.shape),
                            vector(b.inertia));
    body.setLinearVelocity(vector(b.start.velocity));
    body.setAngularVelocity(vector(b.start.spin));
    if (fine_) body.setActivationState(DISABLE_DEACTIVATION);
    if (fine_) body.setContactProcessingThreshold(0);
  }
  void add_floor(const btVector3& normal) {
    const btVector3 half(50, 50, 50), still(0, 0, 0);
    if (fine_)
      add(0, btTransform(shortestArcQuat({0, 1, 0}, normal), normal * -50),
          std::make_unique<btBoxShape>(half), still);
    else
      add(0, btTransform::getIdentity(), std::make_unique<btStaticPlaneShape>(normal, 0), still);
  }
  /// Of two bodies that touch, coefficients are multiplied.
  btRigidBody& add(btScalar mass, const btTransform& place, std::unique_ptr<btCollisionShape> shape,
                   const btVector3& inertia) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
    info.m_startWorldTransform = place;
    info.m_friction = friction_, info.m_restitution = restitution_;
    shapes_.push_back(std::move(shape));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
  }
  void add(const Joint& j) {
    const btTransform a = in(j.a, j), b = in(j.b, j);
    if (j.kind == Joint::rod) throw NotExpressible("no joint that keeps a distance");
    if (j.kind == Joint::hinge) {
      joints_.push_back(std::make_unique<btHingeConstraint>(of(j.a), of(j.b), a, b));
    } else if (j.kind == Joint::ball) {
      joints_.push_back(
          std::make_unique<btPoint2PointConstraint>(of(j.a), of(j.b), a.getOrigin(), b.getOrigin()));
    } else {
      auto cylinder = std::make_unique<btSliderConstraint>(of(j.a), of(j.b), a, b, true);
      cylinder->setLowerAngLimit(1), cylinder->setUpperAngLimit(-1);  // none: the upper is below the lower
      joints_.push_back(std::move(cylinder));
    }
    world_.addConstraint(joints_.back().get(), true);
  }

  bool fine_;
  btScalar friction_ = 0, restitution_ = 0;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace

Engine engine() {
  const bool in_float = sizeof(btScalar) == sizeof(float);
  return {
      in_float ? "Bullet" : "Bullet in double",
      std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100),
      in_float ? "float" : "double",
      false,
      {{"defaults",
        "10 iterations; what is slower than 0.8 m/s and 1 rad/s for 2 s sleeps; nothing bounces below 0.2 "
        "m/s, a contact brakes before it touches, and one that is less than 4 cm deep gives speed",
        1, true, "a contact brakes before it touches"},
       {"100 iterations",
        "100 iterations (m_numIterations) and no sleep (DISABLE_DEACTIVATION); what is slow bounces too "
        "(m_restitutionVelocityThreshold), contacts act when they touch (setContactProcessingThreshold) "
        "and give no speed (m_splitImpulsePenetrationThreshold); the floor is a box, which is touched at "
        "four points in one step",
        1, false}},
      [](const World& world, const std::string& variant, double) -> std::unique_ptr<Simulation> {
        return std::make_unique<InBullet>(world, variant != "defaults");
      }};
}

}  // namespace oddity::engines
