// ODE: fast bodies turn by less than they spin.
//
// A body of constant spin turns by 2 atan(spin h / 2) in a step, 7 % too little at 60 rad/s and 60 Hz.
// dBodySetFiniteRotationMode turns it by spin h.
//   g++ ode_turn.cpp -lode

#include <ode/ode.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

int main() {
  dInitODE2(0);
  for (const int finite : {0, 1})
    for (const int spin : {10, 30, 60, 100}) {
      const dWorldID world = dWorldCreate();
      const dBodyID body = dBodyCreate(world);
      dBodySetFiniteRotationMode(body, finite);
      dBodySetAngularVel(body, 0, 0, spin);
      dWorldStep(world, 1.0 / 60);
      const dReal* q = dBodyGetQuaternion(body);
      std::printf("%s rotation, %3d rad/s: turned by %.2f rad/s\n", finite ? "finite" : "usual ", spin,
                  120 * std::atan2(q[3], q[0]));
      dWorldDestroy(world);
    }
}
