// ODE: quick steps do not repeat themselves.
//
// dWorldQuickStep gives other bits when the same world runs again. It visits the joints in an order drawn
// from one random generator for all worlds, which a new world does not reset (dRandSetSeed does).
//   g++ ode_seed.cpp -lode

#include <ode/ode.h>

#include <cstdio>

double run() {
  const dWorldID world = dWorldCreate();
  dWorldSetGravity(world, 0, -9.81, 0);
  dBodyID before = nullptr;
  for (int i = 0; i < 10; ++i) {
    const dBodyID body = dBodyCreate(world);
    dBodySetPosition(body, i + 1, 0, 0);
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, body, before);
    dJointSetBallAnchor(joint, i, 0, 0);
    before = body;
  }
  for (int i = 0; i < 60; ++i) dWorldQuickStep(world, 1.0 / 60);
  const double y = dBodyGetPosition(before)[1];
  dWorldDestroy(world);
  return y;
}
int main() {
  dInitODE2(0);
  for (int i = 0; i < 3; ++i) std::printf("%.17g\n", run());
  for (int i = 0; i < 2; ++i) dRandSetSeed(0), std::printf("%.17g from seed 0\n", run());
}
