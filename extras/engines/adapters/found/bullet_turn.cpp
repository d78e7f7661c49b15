// Bullet: fast bodies turn by less than they spin.
//
// A body keeps its spin, but turns by less. Where a step would turn it by more than 45 degrees,
// btTransformUtil::integrateTransform cuts the angle in only one of the two places that use it.
//   g++ bullet_turn.cpp $(pkg-config --cflags --libs bullet)

#include <btBulletDynamicsCommon.h>
#include <cstdio>

int main() {
  for (const int spin : {40, 47, 48, 60, 100, 150, 200}) {
    btTransform place = btTransform::getIdentity(), next;
    btTransformUtil::integrateTransform(place, {0, 0, 0}, {0, 0, btScalar(spin)}, btScalar(1) / 60, next);
    std::printf("spin %3d rad/s at 60 Hz: turns by %6.2f rad/s\n", spin, 60 * next.getRotation().getAngle());
  }
}
