// Simbody 3.7 [simtk.org/api_docs/simbody/3.7]: reduced coordinates, integrated to an accuracy, in double.

// Its headers are C++17: in C++20 its indices have several == that fit equally well, unless this one is
// there.
namespace SimTK {
template <class Index>
requires requires(const Index& i) { i.isValidExtended(); }
bool operator==(const Index& a, const Index& b) { return int(a) == int(b); }
}  // namespace SimTK

#undef NDEBUG  // Debian's library is built without it, and some of its objects are larger then
#pragma GCC diagnostic ignored "-Warray-bounds"  // gcc 12 takes its matrices' rows for matrices
#include <Simbody.h>

#include <iostream>

#include "solvers/engines/tree.hpp"

namespace oddity::engines {

namespace {

using SimTK::Transform;
using SimTK::Vec3;

Vec3 vec(const Vector& a) { return {a[0], a[1], a[2]}; }
Vector vector(const Vec3& a) { return {a[0], a[1], a[2]}; }

Transform pose(const State& s) {
  const auto& q = s.orientation;
  return {SimTK::Rotation(SimTK::Quaternion(q[0], q[1], q[2], q[3])), vec(s.position)};
}

class InSimbody final : public Simulation {
 public:
  InSimbody(const World& world, const std::string& variant, double step)
      : gravity_(forces_, matter_, vec(world.gravity)),
        pushes_(forces_, matter_),
        bodies_(world.bodies.size()) {
    const bool euler = variant.starts_with("semi-explicit Euler");
    for (const Limb& limb : tree(world)) add(limb, world);
    for (const Spring& s : world.springs)
      SimTK::Force::TwoPointLinearSpring(forces_, of(s.a), in(world, s.a, s.at), of(s.b),
                                         in(world, s.b, s.end), s.stiffness, s.rest);
    if (world.floor != Vector{}) {
      if (std::ranges::count(world.bodies, Shape::none, [](const Body& b) { return b.shape.kind; }) + 1 <
          std::ssize(world.bodies))
        throw NotExpressible("contacts between bodies: each pair of points has to be declared");
      if (!euler) throw NotExpressible("rigid contacts are the semi-explicit Euler time stepper's alone");
      for (std::size_t i = 0; i < bodies_.size(); ++i) lay(bodies_[i], world.bodies[i].shape, world);
    }
    const bool pushed = world.shaking != Vector{} || world.turning != Vector{};
    system_.realizeTopology();
    euler ? use_euler(variant) : use_integrator(variant, step, pushed);
    start(world);
  }

  void set_gravity(const Vector& g) override { gravity_.setGravityVector(change(), vec(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    const SimTK::MobilizedBody& b = of(body);
    system_.realize(now(), SimTK::Stage::Position);
    const Vec3 station = b.findStationAtGroundPoint(now(), vec(at));
    pushes_.addForceToBodyPoint(change(), b, station, vec(force));
    pushed_ = true;
  }
  void step(double seconds) override {
    time_ += seconds;
    if (euler_) {
      euler_->stepTo(time_);
    } else {
      if (changed_) integrator_->reinitialize(SimTK::Stage::Instance, false);
      while (integrator_->getTime() < time_) integrator_->stepTo(time_);
    }
    changed_ = false;
    if (pushed_) pushes_.clearAllForces(change());
    pushed_ = false;
  }
  State state(int body) const override {
    const SimTK::MobilizedBody& b = of(body);
    system_.realize(now(), SimTK::Stage::Velocity);
    const SimTK::Quaternion q = b.getBodyRotation(now()).convertRotationToQuaternion();
    return {vector(b.getBodyOriginLocation(now())),
            {q[0], q[1], q[2], q[3]},
            vector(b.getBodyOriginVelocity(now())),
            vector(b.getBodyAngularVelocity(now()))};
  }
  bool has_springs() const override { return true; }
  bool save() override {
    saved_ = now();
    return true;
  }
  void restore() override {
    time_ = saved_.getTime();
    initialize(saved_);
  }

 private:
  SimTK::MobilizedBody& of(int body) {
    return body == ground ? matter_.updGround() : bodies_[static_cast<std::size_t>(body)];
  }
  const SimTK::MobilizedBody& of(int body) const { return const_cast<InSimbody*>(this)->of(body); }
  static Transform place(const World& world, int body) {
    return body == ground ? Transform() : pose(world.bodies[static_cast<std::size_t>(body)].start);
  }
  static Vec3 in(const World& world, int body, const Vector& at) { return ~place(world, body) * vec(at); }

  /// Each joint's two frames are one in the world at the start.
  void add(const Limb& limb, const World& world) {
    const Body& b = world.bodies[static_cast<std::size_t>(limb.body)];
    const auto& I = b.inertia;
    const SimTK::Body::Rigid rigid(SimTK::MassProperties(b.mass, Vec3(0), SimTK::Inertia(I[0], I[1], I[2])));
    const Transform parent = place(world, limb.parent), body = pose(b.start);
    SimTK::MobilizedBody& result = bodies_[static_cast<std::size_t>(limb.body)];
    if (!limb.joint) {
      result = SimTK::MobilizedBody::Free(of(ground), body, rigid, Transform());
      return;
    }
    const Joint& j = *limb.joint;
    const Transform joint(j.kind == Joint::hinge || j.kind == Joint::cylinder
                              ? SimTK::Rotation(SimTK::UnitVec3(vec(j.axis)), SimTK::ZAxis)
                              : SimTK::Rotation(),
                          vec(j.at));
    if (j.kind == Joint::hinge)
      result = SimTK::MobilizedBody::Pin(of(limb.parent), ~parent * joint, rigid, ~body * joint);
    if (j.kind == Joint::cylinder)
      result = SimTK::MobilizedBody::Cylinder(of(limb.parent), ~parent * joint, rigid, ~body * joint);
    if (j.kind == Joint::ball)
      result = SimTK::MobilizedBody::Ball(of(limb.parent), ~parent * joint, rigid, ~body * joint);
    if (j.kind != Joint::rod) return;
    const Universal across(j);
    const Transform along(
        SimTK::Rotation(SimTK::UnitVec3(vec(across.first)), SimTK::XAxis, vec(across.second), SimTK::YAxis),
        vec(j.at));
    SimTK::MobilizedBody::Universal link(of(limb.parent), ~parent * along, SimTK::Body::Massless(),
                                         Transform());
    const Transform end(vec(j.end));
    result = SimTK::MobilizedBody::Ball(link, ~along * end, rigid, ~body * end);
  }
  void lay(SimTK::MobilizedBody& b, const Shape& shape, const World& world) {
    const SimTK::UnitVec3 up(vec(world.floor));
    const double e = world.restitution, mu = world.friction;
    SimTK::MobilizedBody& floor = matter_.updGround();
    if (shape.kind == Shape::ball)
      matter_.adoptUnilateralContact(
          new SimTK::SpherePlaneContact(floor, up, 0, b, Vec3(0), shape.half[0], e, mu, mu, 0));
    if (shape.kind == Shape::box)
      for (const double x : {-1, 1})
        for (const double y : {-1, 1})
          for (const double z : {-1, 1}) {
            const Vec3 corner(x * shape.half[0], y * shape.half[1], z * shape.half[2]);
            matter_.adoptUnilateralContact(
                new SimTK::PointPlaneContact(floor, up, 0, b, corner, e, mu, mu, 0));
          }
  }
  void use_euler(const std::string& variant) {
    euler_ = std::make_unique<SimTK::SemiExplicitEulerTimeStepper>(system_);
    if (variant.ends_with("1e-9")) euler_->setConstraintTolerance(1e-9);
    std::cout.setstate(std::ios::failbit);  // built without NDEBUG it writes a trace of each step
  }
  void use_integrator(const std::string& variant, double step, bool pushed) {
    if (variant.starts_with("Verlet"))
      integrator_ = std::make_unique<SimTK::VerletIntegrator>(system_);
    else if (variant.starts_with("CPodes"))
      integrator_ = std::make_unique<SimTK::CPodesIntegrator>(system_);
    else
      integrator_ = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system_);
    if (variant.ends_with("fixed steps")) integrator_->setFixedStepSize(step);
    if (variant.ends_with("1e-9")) integrator_->setAccuracy(1e-9);
    if (pushed) integrator_->setAllowInterpolation(false);
  }
  void initialize(const SimTK::State& s) { euler_ ? euler_->initialize(s) : integrator_->initialize(s); }
  /// The joints' velocities are those that the bodies' momenta give.
  void start(const World& world) {
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
    initialize(s);
  }
  const SimTK::State& now() const { return euler_ ? euler_->getState() : integrator_->getState(); }
  SimTK::State& change() {
    changed_ = true;
    return euler_ ? euler_->updState() : integrator_->updAdvancedState();
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  SimTK::Force::Gravity gravity_;
  SimTK::Force::DiscreteForces pushes_;
  std::vector<SimTK::MobilizedBody> bodies_;
  std::unique_ptr<SimTK::Integrator> integrator_;
  std::unique_ptr<SimTK::SemiExplicitEulerTimeStepper> euler_;
  double time_ = 0;
  bool changed_ = false, pushed_ = false;
  SimTK::State saved_;
};

std::string version() {
  int major, minor, patch;
  SimTK_version_simbody(&major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

Engine engine() { return {"Simbody", version(), "double", false, make<InSimbody>}; }

}  // namespace oddity::engines
