// Box2D 2.4: fast bodies are slowed for good.
//
// No body moves by more than 2 m or turns by more than a quarter in a step: a faster one is slowed for good.
// Also, b2_version is 2.4.0 in 2.4.1.
//   g++ box2d_caps.cpp -lbox2d

#include <box2d/box2d.h>

#include <cstdio>

int main() {
  std::printf("version %d.%d.%d\n", b2_version.major, b2_version.minor, b2_version.revision);
  b2World world({0, 0});
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.linearVelocity = {200, 0};
  def.angularVelocity = 200;
  b2Body* body = world.CreateBody(&def);
  const b2MassData mass{1, {0, 0}, 1};
  body->SetMassData(&mass);
  for (int i = 0; i < 60; ++i) world.Step(1.0f / 60, 8, 3);
  std::printf("from 200 m/s and 200 rad/s: %.1f m/s, %.1f rad/s\n", body->GetLinearVelocity().x,
              body->GetAngularVelocity());
}
