// Bullet: a small pendulum falls asleep on its way.
//
// A pendulum let go at 0.1 rad swings for two seconds, and then stops where it is. Bodies slower than 0.8 m/s
// and 1 rad/s for that long are put to sleep, forces or not.
//   g++ bullet_sleep.cpp $(pkg-config --cflags --libs bullet)

#include <btBulletDynamicsCommon.h>
#include <cstdio>

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, btScalar(-9.81), 0});
  btSphereShape sphere(btScalar(0.1));
  btRigidBody bob(1, nullptr, &sphere, {0.004f, 0.004f, 0.004f});
  bob.translate({std::sin(btScalar(0.1)), -std::cos(btScalar(0.1)), 0});
  btPoint2PointConstraint joint(bob, bob.getWorldTransform().inverse() * btVector3(0, 0, 0));
  world.addRigidBody(&bob), world.addConstraint(&joint);
  for (int i = 0; i <= 300; ++i) {
    if (i % 30 == 0)
      std::printf("%3.1f s: x = %+.4f m, %s\n", i / 60.0, bob.getWorldTransform().getOrigin().x(),
                  bob.isActive() ? "awake" : "asleep");
    world.stepSimulation(btScalar(1) / 60, 1, btScalar(1) / 60);
  }
  world.removeConstraint(&joint), world.removeRigidBody(&bob);
}
