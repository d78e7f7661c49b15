// Box2D 2.4 [manual: box2d.org/documentation_v2_4]: the plane in float, joints held by velocities and then
// put right in place.

#include <box2d/box2d.h>

#include "solvers/engines/plane.hpp"

namespace oddity::engines {

namespace {

b2Vec2 vector(const Vector& v) { return {static_cast<float>(v[0]), static_cast<float>(v[1])}; }

class InBox2d final : public Simulation {
 public:
  InBox2d(const World& world, const std::string& variant)
      : fine_(variant != "defaults"),
        friction_(static_cast<float>(world.friction)),
        restitution_(static_cast<float>(world.restitution)),
        world_(vector(world.gravity)) {
    expect_in_plane(world);
    world_.SetAllowSleeping(!fine_);
    const b2BodyDef still;
    ground_ = world_.CreateBody(&still);
    for (const Body& b : world.bodies) add(b);
    for (const Joint& j : world.joints) add(j);
    own_springs_ = std::ranges::all_of(world.springs, [](const Spring& s) { return s.rest > b2_linearSlop; });
    if (own_springs_)
      for (const Spring& s : world.springs) add(s);
    if (world.floor != Vector{}) add_floor(vector(world.floor));
  }

  void set_gravity(const Vector& g) override { world_.SetGravity(vector(g)); }
  void push(int body, const Vector& force, const Vector& at) override {
    of(body)->ApplyForce(vector(force), vector(at), true);
  }
  void step(double seconds) override {
    world_.Step(static_cast<float>(seconds), fine_ ? 50 : 8, fine_ ? 20 : 3);
  }
  State state(int body) const override {
    const b2Body& b = *of(body);
    const b2Vec2 x = b.GetWorldCenter(), v = b.GetLinearVelocity();
    return {{x.x, x.y, 0}, about_z(b.GetAngle()), {v.x, v.y, 0}, {0, 0, b.GetAngularVelocity()}};
  }
  bool has_springs() const override { return own_springs_; }

 private:
  b2Body* of(int body) const { return body == ground ? ground_ : bodies_[static_cast<std::size_t>(body)]; }

  void add(const Body& b) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = vector(b.start.position);
    def.angle = static_cast<float>(angle(b.start.orientation));
    def.linearVelocity = vector(b.start.velocity);
    def.angularVelocity = static_cast<float>(b.start.spin[2]);
    b2Body* body = world_.CreateBody(&def);
    if (b.shape.kind == Shape::ball) {
      b2CircleShape ball;
      ball.m_radius = static_cast<float>(b.shape.half[0]);
      cover(body, ball);
    } else if (b.shape.kind == Shape::box) {
      b2PolygonShape box;
      box.SetAsBox(static_cast<float>(b.shape.half[0]), static_cast<float>(b.shape.half[1]));
      if (fine_) box.m_radius = 0;
      cover(body, box);
    }
    const b2MassData mass{static_cast<float>(b.mass), b2Vec2_zero, static_cast<float>(b.inertia[2])};
    body->SetMassData(&mass);
    bodies_.push_back(body);
  }
  void add(const Joint& j) {
    if (j.kind == Joint::rod)
      join(b2DistanceJointDef(), j, vector(j.end));
    else if (j.kind == Joint::cylinder)
      join(b2PrismaticJointDef(), j, vector(j.axis));
    else
      join(b2RevoluteJointDef(), j);
  }
  void join(auto joint, const Joint& j, auto... more) {
    joint.Initialize(of(j.a), of(j.b), vector(j.at), more...);
    world_.CreateJoint(&joint);
  }
  void add(const Spring& s) {
    b2DistanceJointDef spring;
    spring.Initialize(of(s.a), of(s.b), vector(s.at), vector(s.end));
    spring.length = static_cast<float>(s.rest);
    spring.minLength = 0;
    spring.maxLength = b2_maxFloat;
    spring.stiffness = static_cast<float>(s.stiffness);
    world_.CreateJoint(&spring);
  }
  void add_floor(const b2Vec2& normal) {
    const b2BodyDef still;
    const b2Vec2 along = 100 * b2Cross(normal, 1.0f);
    b2EdgeShape edge;
    edge.SetTwoSided(along, -along);
    if (fine_) edge.m_radius = 0;
    cover(world_.CreateBody(&still), edge);
  }
  void cover(b2Body* body, const b2Shape& shape) const {
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = friction_;
    fixture.restitution = restitution_;
    if (fine_) fixture.restitutionThreshold = 0;
    body->CreateFixture(&fixture);
  }

  bool fine_, own_springs_ = false;
  float friction_, restitution_;
  b2World world_;
  b2Body* ground_ = nullptr;
  std::vector<b2Body*> bodies_;
};

}  // namespace

/// b2_version is 2.4.0 in 2.4.1 too.
Engine engine() { return {"Box2D", VERSION_OF_FILE, "float", true, make<InBox2d>}; }

}  // namespace oddity::engines
