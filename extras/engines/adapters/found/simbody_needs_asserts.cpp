// Simbody 3.7: Debian's crashes programs that define NDEBUG.
//
// A program that defines NDEBUG, as release builds do, crashes when it sets a speed. The library was built
// without it, and a class in headers and library then differs by 56 bytes.
//   g++ -std=c++17 -O2 -w -I/usr/include/simbody simbody_needs_asserts.cpp -lSimTKsimbody -lSimTKmath
//   -lSimTKcommon
// prints 168 from ./a.out; with -DNDEBUG it is a segmentation fault.

#include <Simbody.h>

using namespace SimTK;

int main() {
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  Body::Rigid body(MassProperties(1, Vec3(0), Inertia(1)));
  MobilizedBody::Pin pin(matter.Ground(), Transform(), body, Transform(Vec3(0, 1, 0)));
  State s = system.realizeTopology();
  system.realize(s, Stage::Velocity);
  s.updU()[0] = 1;
  system.realize(s, Stage::Velocity);
  std::cout << sizeof(CacheEntryInfo) << "\n";
}
