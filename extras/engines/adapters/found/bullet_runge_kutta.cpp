// Bullet: Runge-Kutta 4 is of order 1 on free bodies.
//
// useRK4Integration has order 4 on hinges, 2 on a ball joint and 1 on a free body: it turns a body once, by
// the mean of four spins. Here a free body of moments 1, 2, 3.
//   g++ bullet_runge_kutta.cpp -DBT_USE_DOUBLE_PRECISION $(pkg-config --cflags --libs bullet-float64)

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>
#include <cstdio>

btQuaternion turned(int rate) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btMultiBodyConstraintSolver solver;
  btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, 0});
  btMultiBody body(0, 1, {1, 2, 3}, false, false);
  body.finalizeMultiDof();
  body.setLinearDamping(0), body.setAngularDamping(0), body.useRK4Integration(true);
  body.setBaseOmega({0.1, 2, 0.1});
  world.addMultiBody(&body);
  for (int i = 0; i < 2 * rate; ++i) world.stepSimulation(1.0 / rate, 1, 1.0 / rate);
  world.removeMultiBody(&body);
  return body.getWorldToBaseRot();
}
int main() {
  const btQuaternion last = turned(61440);
  for (const int rate : {60, 120, 240, 480, 960})
    std::printf("%4d Hz: off by %.1e rad\n", rate, last.angleShortestPath(turned(rate)));
}
