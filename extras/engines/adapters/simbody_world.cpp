// Simbody's bodies, springs and contacts [simtk.org/api_docs/simbody/3.7].

#include "extras/engines/adapters/simbody_world.hpp"

namespace oddity::engines {

using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

namespace {

Transform pose(const State& s) {
  const auto& q = s.orientation;
  return {SimTK::Rotation(SimTK::Quaternion(q[0], q[1], q[2], q[3])), vec(s.position)};
}
Transform place(const World& world, int body) {
  return body == ground ? Transform() : pose(start(world, body));
}
Vec3 in(const World& world, int body, const Vector& at) { return ~place(world, body) * vec(at); }

/// The joint's frame in the world at the start, where the frames of both bodies coincide.
Transform frame(const Joint& j) {
  const bool has_axis = j.kind == Joint::hinge || j.kind == Joint::cylinder;
  return {has_axis ? SimTK::Rotation(SimTK::UnitVec3(vec(j.axis)), SimTK::ZAxis) : SimTK::Rotation(),
          vec(j.at)};
}
Transform frame(const Universal& across, const Vector& at) {
  return {SimTK::Rotation(SimTK::UnitVec3(vec(across.first)), SimTK::XAxis, vec(across.second), SimTK::YAxis),
          vec(at)};
}

void expect_apart(const World& world) {
  if (std::ranges::count(world.bodies, Shape::none, [](const Body& b) { return b.shape.kind; }) + 1 <
      std::ssize(world.bodies))
    throw NotExpressible("contacts between bodies: each pair of points has to be declared");
}

}  // namespace

SimbodyWorld::SimbodyWorld(const World& world)
    : gravity_(forces_, matter_, vec(world.gravity)),
      pushes_(forces_, matter_),
      bodies_(world.bodies.size()) {
  for (const Limb& limb : tree(world))
    of(limb.body) = joined(limb, body_of(world, limb.body), place(world, limb.parent));
  for (const Spring& s : world.springs) add(s, world);
  if (world.floor != Vector{}) {
    expect_apart(world);
    for (std::size_t i = 0; i < bodies_.size(); ++i) lay(bodies_[i], world.bodies[i].shape, world);
  }
  system_.realizeTopology();
}

MobilizedBody SimbodyWorld::joined(const Limb& limb, const Body& b, const Transform& parent) {
  const SimTK::Inertia inertia(b.inertia[0], b.inertia[1], b.inertia[2]);
  const SimTK::Body::Rigid rigid(SimTK::MassProperties(b.mass, Vec3(0), inertia));
  const Transform body = pose(b.start);
  if (!limb.joint) return MobilizedBody::Free(of(ground), body, rigid, Transform());
  const Joint& j = *limb.joint;
  const Transform joint = frame(j);
  if (j.kind == Joint::hinge)
    return MobilizedBody::Pin(of(limb.parent), ~parent * joint, rigid, ~body * joint);
  if (j.kind == Joint::cylinder)
    return MobilizedBody::Cylinder(of(limb.parent), ~parent * joint, rigid, ~body * joint);
  if (j.kind == Joint::ball)
    return MobilizedBody::Ball(of(limb.parent), ~parent * joint, rigid, ~body * joint);
  const Transform along = frame(Universal(j), j.at), end(vec(j.end));
  MobilizedBody::Universal link(of(limb.parent), ~parent * along, SimTK::Body::Massless(), Transform());
  return MobilizedBody::Ball(link, ~along * end, rigid, ~body * end);
}

void SimbodyWorld::add(const Spring& s, const World& world) {
  SimTK::Force::TwoPointLinearSpring(forces_, of(s.a), in(world, s.a, s.at), of(s.b), in(world, s.b, s.end),
                                     s.stiffness, s.rest);
}

void SimbodyWorld::lay(MobilizedBody& b, const Shape& shape, const World& world) {
  const SimTK::UnitVec3 up(vec(world.floor));
  const double e = world.restitution, mu = world.friction;
  MobilizedBody& floor = matter_.updGround();
  if (shape.kind == Shape::ball)
    matter_.adoptUnilateralContact(
        new SimTK::SpherePlaneContact(floor, up, 0, b, Vec3(0), shape.half[0], e, mu, mu, 0));
  if (shape.kind == Shape::box)
    for (const double x : {-1, 1})
      for (const double y : {-1, 1})
        for (const double z : {-1, 1}) {
          const Vec3 corner(x * shape.half[0], y * shape.half[1], z * shape.half[2]);
          matter_.adoptUnilateralContact(new SimTK::PointPlaneContact(floor, up, 0, b, corner, e, mu, mu, 0));
        }
}

/// Sets the joints' velocities from the bodies' momenta.
SimTK::State SimbodyWorld::start(const World& world) const {
  SimTK::State s = system_.getDefaultState();
  system_.realize(s, SimTK::Stage::Position);
  SimTK::Vector_<SimTK::SpatialVec> momenta(matter_.getNumBodies(), SimTK::SpatialVec(Vec3(0)));
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Body& b = world.bodies[i];
    const SimTK::Rotation& R = bodies_[i].getBodyRotation(s);
    momenta[bodies_[i].getMobilizedBodyIndex()] = SimTK::SpatialVec(
        R * ((~R * vec(b.start.spin)).elementwiseMultiply(vec(b.inertia))), b.mass * vec(b.start.velocity));
  }
  SimTK::Vector p, u;
  matter_.multiplyBySystemJacobianTranspose(s, momenta, p);
  system_.realize(s, SimTK::Stage::Dynamics);
  matter_.multiplyByMInv(s, p, u);
  s.updU() = u;
  return s;
}

}  // namespace oddity::engines
