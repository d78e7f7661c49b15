// DART 6.12 [dartsim.github.io]: reduced coordinates, contacts by velocity constraints, in double.

#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>

#include "extras/engines/adapters/dart_world.hpp"

namespace oddity::engines {

namespace {

Vector vector(const Eigen::Vector3d& a) { return {a[0], a[1], a[2]}; }

class InDart final : public Simulation {
 public:
  InDart(const World& world, const std::string& variant) : world_(world) {
    set_gravity(world.gravity);
    if (variant == "native collision detector")
      world_.dart().getConstraintSolver()->setCollisionDetector(
          dart::collision::DARTCollisionDetector::create());
    start(world);
  }

  void set_gravity(const Vector& g) override { world_.dart().setGravity(vec(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    world_[body]->addExtForce(vec(force), vec(at), false, false);
  }
  void step(double seconds) override {
    world_.dart().setTimeStep(seconds);
    world_.dart().step();
  }
  State state(int body) const override {
    const dart::dynamics::BodyNode& b = *world_[body];
    const Eigen::Quaterniond q(b.getTransform().linear());
    return {vector(b.getTransform().translation()),
            {q.w(), q.x(), q.y(), q.z()},
            vector(b.getLinearVelocity()),
            vector(b.getAngularVelocity())};
  }
  bool save() override {
    saved_.clear();
    for (const auto& s : world_.skeletons()) saved_.push_back(s->getConfiguration());
    return true;
  }
  void restore() override {
    for (std::size_t i = 0; i < saved_.size(); ++i) world_.skeletons()[i]->setConfiguration(saved_[i]);
  }

 private:
  /// Sets the joints' velocities from the bodies' momenta.
  void start(const World& world) {
    for (const auto& s : world_.skeletons()) {
      Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s->getNumDofs()));
      for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i) {
        if (world_[i]->getSkeleton() != s) continue;
        const Body& b = body_of(world, i);
        const Eigen::Matrix3d R = world_[i]->getTransform().linear();
        Eigen::Vector6d momentum;
        momentum << R * vec(b.inertia).cwiseProduct(R.transpose() * vec(b.start.spin)),
            b.mass * vec(b.start.velocity);
        p += s->getWorldJacobian(world_[i]).transpose() * momentum;
      }
      if (p.size()) s->setVelocities(s->getMassMatrix().ldlt().solve(p));
    }
  }

  DartWorld world_;
  std::vector<dart::dynamics::Skeleton::Configuration> saved_;
};

}  // namespace

Engine engine() { return {"DART", DART_VERSION, "double", false, make<InDart>}; }

}  // namespace oddity::engines
