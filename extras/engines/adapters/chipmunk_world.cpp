// Chipmunk's bodies, joints and shapes [manual: chipmunk-physics.net/release/ChipmunkLatest-Docs].

#include "extras/engines/adapters/chipmunk_world.hpp"

#include "extras/engines/adapters/plane.hpp"

namespace oddity::engines {

ChipmunkWorld::ChipmunkWorld(const World& world)
    : friction_(world.friction), restitution_(world.restitution) {
  expect_in_plane(world);
  for (const Body& b : world.bodies) add(b);
  for (const Joint& j : world.joints) add(j);
  for (const Spring& s : world.springs) add(s);
  if (world.floor != Vector{}) {
    const cpVect along = cpvmult(cpvperp(vector(world.floor)), 1000);
    add(cpSegmentShapeNew(bodies_[ground], along, cpvneg(along), 0));
  }
}

void ChipmunkWorld::add(const Body& b) {
  cpBody* body = cpBodyNew(b.mass, b.inertia[2]);
  owned_.emplace_back(body);
  bodies_.add(body);
  cpSpaceAddBody(space(), body);
  cpBodySetPosition(body, vector(b.start.position));
  cpBodySetAngle(body, angle(b.start.orientation));
  cpBodySetVelocity(body, vector(b.start.velocity));
  cpBodySetAngularVelocity(body, b.start.spin[2]);
  const Vector& half = b.shape.half;
  if (b.shape.kind == Shape::ball) add(cpCircleShapeNew(body, half[0], cpvzero));
  if (b.shape.kind == Shape::box) add(cpBoxShapeNew(body, 2 * half[0], 2 * half[1], 0));
}

void ChipmunkWorld::add(const Joint& j) {
  cpBody *a = bodies_[j.a], *b = bodies_[j.b];
  const cpVect at = vector(j.at);
  if (j.kind == Joint::rod) {
    add(cpPinJointNew(a, b, in(j.a, at), in(j.b, vector(j.end))), j.a, j.b);
  } else if (j.kind == Joint::cylinder) {  // a point in a groove, and both bodies turn together
    const cpVect far = cpvmult(vector(j.axis), 1000);
    const cpVect from = in(j.a, cpvsub(at, far)), to = in(j.a, cpvadd(at, far));
    add(cpGrooveJointNew(a, b, from, to, in(j.b, at)), j.a, j.b);
    add(cpGearJointNew(a, b, cpBodyGetAngle(b) - cpBodyGetAngle(a), 1), j.a, j.b);
  } else {
    add(cpPivotJointNew(a, b, at), j.a, j.b);
  }
}

void ChipmunkWorld::add(const Spring& s) {
  const cpVect at = in(s.a, vector(s.at)), end = in(s.b, vector(s.end));
  add(cpDampedSpringNew(bodies_[s.a], bodies_[s.b], at, end, s.rest, s.stiffness, 0), s.a, s.b);
}

void ChipmunkWorld::add(cpConstraint* constraint, int a, int b) {
  constraints_.emplace_back(constraint);
  cpSpaceAddConstraint(space(), constraint);
  if (a != ground && b != ground) cpConstraintSetCollideBodies(constraint, cpFalse);
}

/// Chipmunk multiplies the coefficients of two touching shapes.
void ChipmunkWorld::add(cpShape* shape) {
  shapes_.emplace_back(shape);
  cpSpaceAddShape(space(), shape);
  cpShapeSetFriction(shape, std::sqrt(friction_));
  cpShapeSetElasticity(shape, std::sqrt(restitution_));
}

}  // namespace oddity::engines
