// Chipmunk 7: a bead leaves its groove.
//
// A gear joint keeps a bead in a groove from turning. The bead is lost if the groove joint's point is 1 m
// from it, at every step size, even if all of a joint's error is corrected in one step. With the point at the
// bead's center the same joint holds. Also, Debian's library writes to standard output that it is a debug
// build.
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
