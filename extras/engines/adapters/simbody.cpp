// Simbody 3.7 [simtk.org/api_docs/simbody/3.7]: reduced coordinates, integrated to an accuracy, in double.

#include "extras/engines/adapters/simbody_world.hpp"

#include <iostream>

namespace oddity::engines {

namespace {

class InSimbody final : public Simulation {
 public:
  InSimbody(const World& world, const std::string& variant, double step) : world_(world) {
    variant.starts_with("semi-explicit Euler") ? use_euler(variant) : use_integrator(variant, step);
    if (world.floor != Vector{} && !euler_)
      throw NotExpressible("rigid contacts are the semi-explicit Euler time stepper's alone");
    const bool pushed = world.shaking != Vector{} || world.turning != Vector{};
    if (pushed && integrator_) integrator_->setAllowInterpolation(false);
    initialize(world_.start(world));
  }

  void set_gravity(const Vector& g) override { world_.gravity().setGravityVector(change(), vec(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    world_.system().realize(now(), SimTK::Stage::Position);
    const SimTK::MobilizedBody& b = world_[body];
    const SimTK::Vec3 station = b.findStationAtGroundPoint(now(), vec(at));
    world_.pushes().addForceToBodyPoint(change(), b, station, vec(force));
    pushed_ = true;
  }
  void step(double seconds) override {
    time_ += seconds;
    if (euler_) euler_->stepTo(time_);
    if (integrator_ && changed_) integrator_->reinitialize(SimTK::Stage::Instance, false);
    while (integrator_ && integrator_->getTime() < time_) integrator_->stepTo(time_);
    changed_ = false;
    if (pushed_) world_.pushes().clearAllForces(change());
    pushed_ = false;
  }
  State state(int body) const override {
    const SimTK::MobilizedBody& b = world_[body];
    world_.system().realize(now(), SimTK::Stage::Velocity);
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
  void use_euler(const std::string& variant) {
    euler_ = std::make_unique<SimTK::SemiExplicitEulerTimeStepper>(world_.system());
    if (variant.ends_with("1e-9")) euler_->setConstraintTolerance(1e-9);
    std::cout.setstate(std::ios::failbit);  // a library built without NDEBUG writes a trace of each step
  }
  void use_integrator(const std::string& variant, double step) {
    if (variant.starts_with("Verlet"))
      integrator_ = std::make_unique<SimTK::VerletIntegrator>(world_.system());
    else if (variant.starts_with("CPodes"))
      integrator_ = std::make_unique<SimTK::CPodesIntegrator>(world_.system());
    else
      integrator_ = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(world_.system());
    if (variant.ends_with("fixed steps")) integrator_->setFixedStepSize(step);
    if (variant.ends_with("1e-9")) integrator_->setAccuracy(1e-9);
  }
  void initialize(const SimTK::State& s) { euler_ ? euler_->initialize(s) : integrator_->initialize(s); }
  const SimTK::State& now() const { return euler_ ? euler_->getState() : integrator_->getState(); }
  SimTK::State& change() {
    changed_ = true;
    return euler_ ? euler_->updState() : integrator_->updAdvancedState();
  }

  SimbodyWorld world_;
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
