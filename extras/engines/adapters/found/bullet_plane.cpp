// Bullet: boxes sink into planes and rattle.
//
// A box that slides on btStaticPlaneShape at 60 Hz sinks in by 2 cm and rattles; on a large box it sinks in
// by 4 mm. A plane gets one more contact point per step, another box gets four at once.
//   g++ bullet_plane.cpp $(pkg-config --cflags --libs bullet)

#include <btBulletDynamicsCommon.h>
#include <cstdio>

void slide(const char* name, btCollisionShape* shape, btScalar top) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, btScalar(-9.81), 0});
  btBoxShape shape_of_box({btScalar(0.3), btScalar(0.2), btScalar(0.1)});
  btRigidBody floor(0, nullptr, shape), box(1, nullptr, &shape_of_box, {0.0167f, 0.0333f, 0.0433f});
  floor.setFriction(1), box.setFriction(btScalar(0.3));
  floor.translate({0, -top, 0}), box.translate({0, btScalar(0.2), 0});
  box.setLinearVelocity({2, 0, 0});
  world.addRigidBody(&floor), world.addRigidBody(&box);
  for (int i = 0; i < 30; ++i) {
    world.stepSimulation(btScalar(1) / 60, 1, btScalar(1) / 60);
    const btScalar sunk = btScalar(0.2) - box.getWorldTransform().getOrigin().y();
    if (i % 6 == 5) std::printf("%s: sunk %.4f m\n", name, sunk);
  }
  world.removeRigidBody(&floor), world.removeRigidBody(&box);
}
int main() {
  btStaticPlaneShape plane({0, 1, 0}, 0);
  btBoxShape block({50, 50, 50});
  slide("plane", &plane, 0), slide("block", &block, 50);
}
