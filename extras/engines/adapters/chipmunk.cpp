// Chipmunk 7 [manual: chipmunk-physics.net/release/ChipmunkLatest-Docs]: the plane in double, joints by
// impulses.

#include "extras/engines/adapters/chipmunk_world.hpp"
#include "extras/engines/adapters/plane.hpp"

namespace oddity::engines {

namespace {

class InChipmunk final : public Simulation {
 public:
  InChipmunk(const World& world, const std::string& variant) : world_(world) {
    set_gravity(world.gravity);
    if (variant != "defaults") {
      cpSpaceSetIterations(world_.space(), 50);
      cpSpaceSetCollisionSlop(world_.space(), 1e-4);
    }
  }

  void set_gravity(const Vector& g) override { cpSpaceSetGravity(world_.space(), vector(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    cpBodyApplyForceAtWorldPoint(world_[body], vector(force), vector(at));
  }
  void step(double seconds) override { cpSpaceStep(world_.space(), seconds); }
  State state(int body) const override {
    const cpBody* b = world_[body];
    const cpVect x = cpBodyGetPosition(b), v = cpBodyGetVelocity(b);
    return {{x.x, x.y, 0}, about_z(cpBodyGetAngle(b)), {v.x, v.y, 0}, {0, 0, cpBodyGetAngularVelocity(b)}};
  }
  bool has_springs() const override { return true; }

 private:
  ChipmunkWorld world_;
};

}  // namespace

Engine engine() {
  return {"Chipmunk", cpVersionString, CP_USE_DOUBLES ? "double" : "float", true, make<InChipmunk>};
}

}  // namespace oddity::engines
