// Bullet: balls bounce too little, or too fast.
//
// A ball should leave the floor at 0.8 of its speed. With fine steps it does not leave it: a contact acts
// from 2 cm away, and the bounce is less by distance / step. With coarse steps the ball is found deep inside
// the floor, and leaves too fast.
//   g++ bullet_bounce.cpp $(pkg-config --cflags --libs bullet)

#include <btBulletDynamicsCommon.h>

#include <cstdio>

int main() {
  for (const int rate : {60, 240, 960, 3840, 15360}) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity({0, btScalar(-9.81), 0});
    btStaticPlaneShape plane({0, 1, 0}, 0);
    btSphereShape sphere(btScalar(0.1));
    btRigidBody floor(0, nullptr, &plane), ball(1, nullptr, &sphere, {1, 1, 1});
    floor.setRestitution(1), ball.setRestitution(btScalar(0.8));
    ball.translate({0, btScalar(1.1), 0});
    world.addRigidBody(&floor), world.addRigidBody(&ball);
    btScalar down = 0, up = 0;
    for (int i = 0; i < rate; ++i) {
      world.stepSimulation(btScalar(1) / rate, 1, btScalar(1) / rate);
      down = btMin(down, ball.getLinearVelocity().y()), up = btMax(up, ball.getLinearVelocity().y());
    }
    std::printf("%5d Hz: down at %.3f m/s, up at %.3f\n", rate, -down, up);
    world.removeRigidBody(&floor), world.removeRigidBody(&ball);
  }
}
