// Open Dynamics Engine [manual: ode.org/wiki/index.php/Manual]: joints held by velocities.

#include <ode/ode.h>

#include "solvers/engines/simulation.hpp"

namespace oddity::engines {

namespace {

Vector vector(const dReal* x) { return {x[0], x[1], x[2]}; }

class InOde final : public Simulation {
 public:
  InOde(const World& world, const std::string& variant)
      : quick_(variant == "quick step"), finite_(variant == "finite rotations") {
    dInitODE2(0);
    world_ = dWorldCreate();
    space_ = dSimpleSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    set_gravity(world.gravity);
    friction_ = world.friction, restitution_ = world.restitution;
    for (const Body& b : world.bodies) add(b);
    for (const Joint& j : world.joints) add(j);
    if (world.floor != Vector{}) dCreatePlane(space_, world.floor[0], world.floor[1], world.floor[2], 0);
  }
  ~InOde() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    dCloseODE();
  }

  void set_gravity(const Vector& g) override { dWorldSetGravity(world_, g[0], g[1], g[2]); }
  void push(int body, const Vector& f, const Vector& at) override {
    dBodyAddForceAtPos(of(body), f[0], f[1], f[2], at[0], at[1], at[2]);
  }
  void step(double seconds) override {
    dSpaceCollide(space_, this, &touch);
    quick_ ? dWorldQuickStep(world_, seconds) : dWorldStep(world_, seconds);
    dJointGroupEmpty(contacts_);
  }
  State state(int body) const override {
    const dReal* q = dBodyGetQuaternion(of(body));
    return {vector(dBodyGetPosition(of(body))),
            {q[0], q[1], q[2], q[3]},
            vector(dBodyGetLinearVel(of(body))),
            vector(dBodyGetAngularVel(of(body)))};
  }
  bool save() override {
    saved_.clear();
    for (std::size_t i = 0; i < bodies_.size(); ++i) saved_.push_back(state(static_cast<int>(i)));
    seed_ = dRandGetSeed();
    return true;
  }
  void restore() override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) put(bodies_[i], saved_[i]);
    dRandSetSeed(seed_);
  }

 private:
  dBodyID of(int body) const { return body == ground ? nullptr : bodies_[static_cast<std::size_t>(body)]; }

  void add(const Body& b) {
    const dBodyID body = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, b.mass, 0, 0, 0, b.inertia[0], b.inertia[1], b.inertia[2], 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetFiniteRotationMode(body, finite_);
    put(body, b.start);
    if (b.shape.kind != Shape::none)
      dGeomSetBody(b.shape.kind == Shape::ball
                       ? dCreateSphere(space_, b.shape.half[0])
                       : dCreateBox(space_, 2 * b.shape.half[0], 2 * b.shape.half[1], 2 * b.shape.half[2]),
                   body);
    bodies_.push_back(body);
  }
  static void put(dBodyID body, const State& s) {
    dBodySetPosition(body, s.position[0], s.position[1], s.position[2]);
    dBodySetQuaternion(body, s.orientation.data());
    dBodySetLinearVel(body, s.velocity[0], s.velocity[1], s.velocity[2]);
    dBodySetAngularVel(body, s.spin[0], s.spin[1], s.spin[2]);
  }
  void add(const Joint& j) {
    const auto [x, y, z] = j.at;
    const auto [ax, ay, az] = j.axis;
    if (j.kind == Joint::hinge) {
      const dJointID hinge = dJointCreateHinge(world_, nullptr);
      dJointAttach(hinge, of(j.b), of(j.a));
      dJointSetHingeAnchor(hinge, x, y, z);
      dJointSetHingeAxis(hinge, ax, ay, az);
    } else if (j.kind == Joint::ball) {
      const dJointID ball = dJointCreateBall(world_, nullptr);
      dJointAttach(ball, of(j.b), of(j.a));
      dJointSetBallAnchor(ball, x, y, z);
    } else if (j.kind == Joint::cylinder) {
      const dJointID piston = dJointCreatePiston(world_, nullptr);
      dJointAttach(piston, of(j.b), of(j.a));
      dJointSetPistonAnchor(piston, x, y, z);
      dJointSetPistonAxis(piston, ax, ay, az);
    } else {
      const dJointID rod = dJointCreateDBall(world_, nullptr);
      dJointAttach(rod, of(j.a), of(j.b));
      dJointSetDBallAnchor1(rod, x, y, z);
      dJointSetDBallAnchor2(rod, j.end[0], j.end[1], j.end[2]);
    }
  }
  static void touch(void* self, dGeomID a, dGeomID b) { static_cast<InOde*>(self)->touch(a, b); }
  void touch(dGeomID a, dGeomID b) {
    const dBodyID body = dGeomGetBody(a), other = dGeomGetBody(b);
    if (body && other && dAreConnectedExcluding(body, other, dJointTypeContact)) return;
    dContact contacts[8] = {};
    const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
      contacts[i].surface.mode = dContactBounce | dContactApprox1;
      contacts[i].surface.mu = friction_;
      contacts[i].surface.bounce = restitution_;
      dJointAttach(dJointCreateContact(world_, contacts_, &contacts[i]), body, other);
    }
  }

  bool quick_, finite_;
  double friction_ = 0, restitution_ = 0;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<dBodyID> bodies_;
  std::vector<State> saved_;
  unsigned long seed_ = 0;
};

}  // namespace

Engine engine() {
  const bool in_double = dCheckConfiguration("ODE_double_precision");
  return {"ODE", dODE_VERSION, in_double ? "double" : "float", false, make<InOde>};
}

}  // namespace oddity::engines
