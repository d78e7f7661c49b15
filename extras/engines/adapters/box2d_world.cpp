// Box2D's bodies, joints and shapes [manual: box2d.org/documentation_v2_4].

#include "extras/engines/adapters/box2d_world.hpp"

#include "extras/engines/adapters/plane.hpp"

namespace oddity::engines {

Box2dWorld::Box2dWorld(const World& world, bool fine)
    : fine_(fine),
      friction_(static_cast<float>(world.friction)),
      restitution_(static_cast<float>(world.restitution)),
      box2d_(vector(world.gravity)) {
  expect_in_plane(world);
  box2d_.SetAllowSleeping(!fine_);
  const b2BodyDef still;
  bodies_ = Handles<b2Body*>(box2d_.CreateBody(&still));
  for (const Body& b : world.bodies) add(b);
  for (const Joint& j : world.joints) add(j);
  has_springs_ = std::ranges::all_of(world.springs, [](const Spring& s) { return s.rest > b2_linearSlop; });
  if (has_springs_)
    for (const Spring& s : world.springs) add(s);
  if (world.floor != Vector{}) add_floor(vector(world.floor));
}

void Box2dWorld::add(const Body& b) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = vector(b.start.position);
  def.angle = static_cast<float>(angle(b.start.orientation));
  def.linearVelocity = vector(b.start.velocity);
  def.angularVelocity = static_cast<float>(b.start.spin[2]);
  b2Body* body = box2d_.CreateBody(&def);
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
  bodies_.add(body);
}

void Box2dWorld::add(const Joint& j) {
  if (j.kind == Joint::rod)
    join(b2DistanceJointDef(), j, vector(j.end));
  else if (j.kind == Joint::cylinder)
    join(b2PrismaticJointDef(), j, vector(j.axis));
  else
    join(b2RevoluteJointDef(), j);
}

void Box2dWorld::join(auto joint, const Joint& j, auto... more) {
  joint.Initialize(bodies_[j.a], bodies_[j.b], vector(j.at), more...);
  box2d_.CreateJoint(&joint);
}

void Box2dWorld::add(const Spring& s) {
  b2DistanceJointDef spring;
  spring.Initialize(bodies_[s.a], bodies_[s.b], vector(s.at), vector(s.end));
  spring.length = static_cast<float>(s.rest);
  spring.minLength = 0;
  spring.maxLength = b2_maxFloat;
  spring.stiffness = static_cast<float>(s.stiffness);
  box2d_.CreateJoint(&spring);
}

void Box2dWorld::add_floor(const b2Vec2& normal) {
  const b2BodyDef still;
  const b2Vec2 along = 100 * b2Cross(normal, 1.0f);
  b2EdgeShape edge;
  edge.SetTwoSided(along, -along);
  if (fine_) edge.m_radius = 0;
  cover(box2d_.CreateBody(&still), edge);
}

void Box2dWorld::cover(b2Body* body, const b2Shape& shape) const {
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = friction_;
  fixture.restitution = restitution_;
  if (fine_) fixture.restitutionThreshold = 0;
  body->CreateFixture(&fixture);
}

}  // namespace oddity::engines
