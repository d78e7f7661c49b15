// Box2D 2.4 [manual: box2d.org/documentation_v2_4]: the plane in float, joints by velocity constraints with
// position correction.

#include "extras/engines/adapters/box2d_world.hpp"
#include "extras/engines/adapters/plane.hpp"

namespace oddity::engines {

namespace {

class InBox2d final : public Simulation {
 public:
  InBox2d(const World& world, const std::string& variant)
      : fine_(variant != "defaults"), world_(world, fine_) {}

  void set_gravity(const Vector& g) override { world_.box2d().SetGravity(vector(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    world_[body]->ApplyForce(vector(force), vector(at), true);
  }
  void step(double seconds) override {
    world_.box2d().Step(static_cast<float>(seconds), fine_ ? 50 : 8, fine_ ? 20 : 3);
  }
  State state(int body) const override {
    const b2Body& b = *world_[body];
    const b2Vec2 x = b.GetWorldCenter(), v = b.GetLinearVelocity();
    return {{x.x, x.y, 0}, about_z(b.GetAngle()), {v.x, v.y, 0}, {0, 0, b.GetAngularVelocity()}};
  }
  bool has_springs() const override { return world_.has_springs(); }

 private:
  bool fine_;
  Box2dWorld world_;
};

}  // namespace

/// Version from the file name, as b2_version is 2.4.0 in 2.4.1 too.
Engine engine() { return {"Box2D", VERSION_OF_FILE, "float", true, make<InBox2d>}; }

}  // namespace oddity::engines
