// Chipmunk 7 [manual: chipmunk-physics.net/release/ChipmunkLatest-Docs]: the plane in double, joints held by
// impulses.

#include <chipmunk/chipmunk.h>

#include "solvers/engines/plane.hpp"

namespace oddity::engines {

namespace {

cpVect vector(const Vector& v) { return {v[0], v[1]}; }

template <auto free>
struct Freed {
  void operator()(auto* it) const { free(it); }
};

class InChipmunk final : public Simulation {
 public:
  InChipmunk(const World& world, const std::string& variant)
      : friction_(world.friction), restitution_(world.restitution) {
    expect_in_plane(world);
    set_gravity(world.gravity);
    if (variant != "defaults") {
      cpSpaceSetIterations(space_.get(), 50);
      cpSpaceSetCollisionSlop(space_.get(), 1e-4);
    }
    for (const Body& b : world.bodies) add(b);
    for (const Joint& j : world.joints) add(j);
    for (const Spring& s : world.springs)
      add(cpDampedSpringNew(of(s.a), of(s.b), in(s.a, s.at), in(s.b, s.end), s.rest, s.stiffness, 0), s.a,
          s.b);
    if (world.floor != Vector{}) {
      const cpVect along = cpvmult(cpvperp(vector(world.floor)), 1000);
      add(cpSegmentShapeNew(of(ground), along, cpvneg(along), 0));
    }
  }

  void set_gravity(const Vector& g) override { cpSpaceSetGravity(space_.get(), vector(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    cpBodyApplyForceAtWorldPoint(of(body), vector(force), vector(at));
  }
  void step(double seconds) override { cpSpaceStep(space_.get(), seconds); }
  State state(int body) const override {
    const cpBody* b = of(body);
    const cpVect x = cpBodyGetPosition(b), v = cpBodyGetVelocity(b);
    return {{x.x, x.y, 0}, about_z(cpBodyGetAngle(b)), {v.x, v.y, 0}, {0, 0, cpBodyGetAngularVelocity(b)}};
  }
  bool has_springs() const override { return true; }

 private:
  cpBody* of(int body) const {
    return body == ground ? cpSpaceGetStaticBody(space_.get())
                          : bodies_[static_cast<std::size_t>(body)].get();
  }
  cpVect in(int body, const Vector& at) const { return cpBodyWorldToLocal(of(body), vector(at)); }

  void add(const Body& b) {
    cpBody* body = cpBodyNew(b.mass, b.inertia[2]);
    bodies_.emplace_back(body);
    cpSpaceAddBody(space_.get(), body);
    cpBodySetPosition(body, vector(b.start.position));
    cpBodySetAngle(body, angle(b.start.orientation));
    cpBodySetVelocity(body, vector(b.start.velocity));
    cpBodySetAngularVelocity(body, b.start.spin[2]);
    const Vector& half = b.shape.half;
    if (b.shape.kind == Shape::ball) add(cpCircleShapeNew(body, half[0], cpvzero));
    if (b.shape.kind == Shape::box) add(cpBoxShapeNew(body, 2 * half[0], 2 * half[1], 0));
  }
  void add(const Joint& j) {
    if (j.kind == Joint::rod) {
      add(cpPinJointNew(of(j.a), of(j.b), in(j.a, j.at), in(j.b, j.end)), j.a, j.b);
    } else if (j.kind == Joint::cylinder) {  // a point in a groove, and a turn of one is that of the other
      const Vector from{j.at[0] - 1000 * j.axis[0], j.at[1] - 1000 * j.axis[1]};
      const Vector to{j.at[0] + 1000 * j.axis[0], j.at[1] + 1000 * j.axis[1]};
      add(cpGrooveJointNew(of(j.a), of(j.b), in(j.a, from), in(j.a, to), in(j.b, j.at)), j.a, j.b);
      add(cpGearJointNew(of(j.a), of(j.b), cpBodyGetAngle(of(j.b)) - cpBodyGetAngle(of(j.a)), 1), j.a, j.b);
    } else {
      add(cpPivotJointNew(of(j.a), of(j.b), vector(j.at)), j.a, j.b);
    }
  }
  void add(cpConstraint* constraint, int a, int b) {
    constraints_.emplace_back(constraint);
    cpSpaceAddConstraint(space_.get(), constraint);
    if (a != ground && b != ground) cpConstraintSetCollideBodies(constraint, cpFalse);
  }
  /// Of two shapes that touch, coefficients are multiplied.
  void add(cpShape* shape) {
    shapes_.emplace_back(shape);
    cpSpaceAddShape(space_.get(), shape);
    cpShapeSetFriction(shape, std::sqrt(friction_));
    cpShapeSetElasticity(shape, std::sqrt(restitution_));
  }

  double friction_, restitution_;
  // A space is freed before what is in it.
  std::vector<std::unique_ptr<cpBody, Freed<cpBodyFree>>> bodies_;
  std::vector<std::unique_ptr<cpShape, Freed<cpShapeFree>>> shapes_;
  std::vector<std::unique_ptr<cpConstraint, Freed<cpConstraintFree>>> constraints_;
  std::unique_ptr<cpSpace, Freed<cpSpaceFree>> space_{cpSpaceNew()};
};

}  // namespace

Engine engine() {
  return {"Chipmunk", cpVersionString, CP_USE_DOUBLES ? "double" : "float", true, make<InChipmunk>};
}

}  // namespace oddity::engines
