// Open Dynamics Engine [manual: ode.org/wiki/index.php/Manual]: joints by velocity constraints.

#include "extras/engines/adapters/ode_world.hpp"

namespace oddity::engines {

namespace {

Vector vector(const dReal* x) { return {x[0], x[1], x[2]}; }

class InOde final : public Simulation {
 public:
  InOde(const World& world, const std::string& variant)
      : quick_(variant == "quick step"),
        friction_(world.friction),
        restitution_(world.restitution),
        world_(world, variant == "finite rotations"),
        contacts_(dJointGroupCreate(0)) {
    set_gravity(world.gravity);
  }
  ~InOde() override { dJointGroupDestroy(contacts_); }

  void set_gravity(const Vector& g) override { dWorldSetGravity(world_.id(), g[0], g[1], g[2]); }
  void push(int body, const Vector& f, const Vector& at) override {
    dBodyAddForceAtPos(world_[body], f[0], f[1], f[2], at[0], at[1], at[2]);
  }
  void step(double seconds) override {
    dSpaceCollide(world_.space(), this, &touch);
    quick_ ? dWorldQuickStep(world_.id(), seconds) : dWorldStep(world_.id(), seconds);
    dJointGroupEmpty(contacts_);
  }
  State state(int body) const override {
    const dBodyID b = world_[body];
    const dReal* q = dBodyGetQuaternion(b);
    return {vector(dBodyGetPosition(b)),
            {q[0], q[1], q[2], q[3]},
            vector(dBodyGetLinearVel(b)),
            vector(dBodyGetAngularVel(b))};
  }
  bool save() override {
    saved_.clear();
    for (int i = 0; i < world_.size(); ++i) saved_.push_back(state(i));
    seed_ = dRandGetSeed();
    return true;
  }
  void restore() override {
    for (int i = 0; i < world_.size(); ++i) world_.put(i, saved_[static_cast<std::size_t>(i)]);
    dRandSetSeed(seed_);
  }

 private:
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
      dJointAttach(dJointCreateContact(world_.id(), contacts_, &contacts[i]), body, other);
    }
  }

  bool quick_;
  double friction_, restitution_;
  OdeWorld world_;
  dJointGroupID contacts_;
  std::vector<State> saved_;
  unsigned long seed_ = 0;
};

}  // namespace

Engine engine() {
  const bool in_double = dCheckConfiguration("ODE_double_precision");
  return {"ODE", dODE_VERSION, in_double ? "double" : "float", false, make<InOde>};
}

}  // namespace oddity::engines
