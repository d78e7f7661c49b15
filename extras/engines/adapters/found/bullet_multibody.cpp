// Bullet: multibodies are damped and capped unasked.
//
// A btMultiBody thrown at 50 m/s without gravity or contact is damped, by 0.04/s and by 0.04 of its speed.
// One thrown at 200 m/s flies at 100 (setMaxCoordinateVelocity).
//   g++ bullet_multibody.cpp $(pkg-config --cflags --libs bullet)

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <cstdio>

int main() {
  for (const int speed : {1, 50, 200})
    for (const bool damped : {true, false}) {
      btDefaultCollisionConfiguration configuration;
      btCollisionDispatcher dispatcher(&configuration);
      btDbvtBroadphase broadphase;
      btMultiBodyConstraintSolver solver;
      btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
      world.setGravity({0, 0, 0});
      btMultiBody body(0, 1, {1, 1, 1}, false, false);
      body.finalizeMultiDof();
      if (!damped) body.setLinearDamping(0);
      body.setBaseVel({btScalar(speed), 0, 0});
      world.addMultiBody(&body);
      for (int i = 0; i < 240; ++i) world.stepSimulation(btScalar(1) / 240, 1, btScalar(1) / 240);
      std::printf("%3d m/s, %s: %.2f m in a second\n", speed, damped ? "as it is" : "undamped",
                  body.getBasePos().x());
      world.removeMultiBody(&body);
    }
}
