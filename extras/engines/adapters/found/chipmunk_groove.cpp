// Chipmunk 7: a bead leaves its groove.
//
// A bead in a groove, which a gear joint keeps from turning, is lost where the joint's point is 1 m from
// the bead; with all of a joint's error put right in one step, at every step size. At the bead's center
// the same joint holds. And Debian's library says on standard output that it is a debug build.
//   g++ chipmunk_groove.cpp -lchipmunk

#include <chipmunk/chipmunk.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

void slide(int rate, double off, double bias) {
  cpSpace* space = cpSpaceNew();
  cpSpaceSetGravity(space, cpv(5.9, -7.8));  // the groove is along x, and slopes
  cpBody* bead = cpSpaceAddBody(space, cpBodyNew(1, 1e-3));
  cpBody* ground = cpSpaceGetStaticBody(space);
  for (cpConstraint* joint : {cpGrooveJointNew(ground, bead, cpv(-1000, 0), cpv(1000, 0), cpv(-off, 0)),
                              cpGearJointNew(ground, bead, 0, 1)}) {
    if (bias >= 0) cpConstraintSetErrorBias(joint, bias);
    cpSpaceAddConstraint(space, joint);
  }
  for (int i = 0; i < 2 * rate; ++i) cpSpaceStep(space, 1.0 / rate);
  const cpVect x = cpBodyGetPosition(bead);
  std::printf("%5d Hz, point %.0f m off, %s: off the groove by %.1e m\n", rate, off,
              bias < 0 ? "as it is" : "no error left", std::abs(x.y));
}
int main() {
  for (const int rate : {60, 240, 960, 15360})
    slide(rate, 0, -1), slide(rate, 1, -1), slide(rate, 0, 0), slide(rate, 1, 0);
}
