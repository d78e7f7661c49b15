// ODE's bodies, joints and shapes [manual: ode.org/wiki/index.php/Manual].

#include "extras/engines/adapters/ode_world.hpp"

namespace oddity::engines {

OdeWorld::OdeWorld(const World& world, bool finite_rotations) {
  dInitODE2(0);
  world_ = dWorldCreate();
  space_ = dSimpleSpaceCreate(nullptr);
  for (const Body& b : world.bodies) add(b, finite_rotations);
  for (const Joint& j : world.joints) add(j);
  if (world.floor != Vector{}) dCreatePlane(space_, world.floor[0], world.floor[1], world.floor[2], 0);
}

OdeWorld::~OdeWorld() {
  dSpaceDestroy(space_);
  dWorldDestroy(world_);
  dCloseODE();
}

void OdeWorld::put(int body, const State& s) {
  const dBodyID id = bodies_[body];
  dBodySetPosition(id, s.position[0], s.position[1], s.position[2]);
  dBodySetQuaternion(id, s.orientation.data());
  dBodySetLinearVel(id, s.velocity[0], s.velocity[1], s.velocity[2]);
  dBodySetAngularVel(id, s.spin[0], s.spin[1], s.spin[2]);
}

void OdeWorld::add(const Body& b, bool finite_rotations) {
  const dBodyID body = dBodyCreate(world_);
  bodies_.add(body);
  dMass mass;
  dMassSetParameters(&mass, b.mass, 0, 0, 0, b.inertia[0], b.inertia[1], b.inertia[2], 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetFiniteRotationMode(body, finite_rotations);
  put(size() - 1, b.start);
  const Vector& half = b.shape.half;
  if (b.shape.kind == Shape::ball) dGeomSetBody(dCreateSphere(space_, half[0]), body);
  if (b.shape.kind == Shape::box)
    dGeomSetBody(dCreateBox(space_, 2 * half[0], 2 * half[1], 2 * half[2]), body);
}

void OdeWorld::add(const Joint& j) {
  const auto [x, y, z] = j.at;
  const auto [ax, ay, az] = j.axis;
  const dBodyID a = bodies_[j.a], b = bodies_[j.b];
  if (j.kind == Joint::hinge) {
    const dJointID hinge = dJointCreateHinge(world_, nullptr);
    dJointAttach(hinge, b, a);
    dJointSetHingeAnchor(hinge, x, y, z);
    dJointSetHingeAxis(hinge, ax, ay, az);
  } else if (j.kind == Joint::ball) {
    const dJointID ball = dJointCreateBall(world_, nullptr);
    dJointAttach(ball, b, a);
    dJointSetBallAnchor(ball, x, y, z);
  } else if (j.kind == Joint::cylinder) {
    const dJointID piston = dJointCreatePiston(world_, nullptr);
    dJointAttach(piston, b, a);
    dJointSetPistonAnchor(piston, x, y, z);
    dJointSetPistonAxis(piston, ax, ay, az);
  } else {
    const dJointID rod = dJointCreateDBall(world_, nullptr);
    dJointAttach(rod, a, b);
    dJointSetDBallAnchor1(rod, x, y, z);
    dJointSetDBallAnchor2(rod, j.end[0], j.end[1], j.end[2]);
  }
}

}  // namespace oddity::engines
