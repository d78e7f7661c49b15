// Box2D 2.4: boxes rest 1.5 cm above edges.
//
// A box on an edge rests 1.5 cm above it, a ball 0.5 cm. Polygons and edges have a skin of 1 cm, of which 0.5
// cm may overlap.
//   g++ box2d_skin.cpp -lbox2d

#include <box2d/box2d.h>

#include <cstdio>
#include <initializer_list>

int main() {
  b2World world({0, -9.81f});
  const b2BodyDef still;
  b2EdgeShape edge;
  edge.SetTwoSided({-10, 0}, {10, 0});
  world.CreateBody(&still)->CreateFixture(&edge, 0);
  b2PolygonShape box;
  box.SetAsBox(0.1f, 0.1f);
  b2CircleShape ball;
  ball.m_radius = 0.1f;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  for (const b2Shape* shape : {static_cast<const b2Shape*>(&box), static_cast<const b2Shape*>(&ball)}) {
    def.position = {shape == &box ? -1.0f : 1.0f, 0.1f};
    b2Body* body = world.CreateBody(&def);
    body->CreateFixture(shape, 1);
    for (int i = 0; i < 600; ++i) world.Step(1.0f / 60, 8, 3);
    std::printf("%s: %.4f m above\n", shape == &box ? "box" : "ball", body->GetPosition().y - 0.1f);
  }
}
