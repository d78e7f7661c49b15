// Simbody 3.7: Debian's traces every step.
//
// Its time stepper for rigid contacts writes a trace of every step to standard output: the library was built
// without NDEBUG.
//   g++ -std=c++17 -O2 -w -I/usr/include/simbody simbody_traces.cpp -lSimTKsimbody -lSimTKmath
//   -lSimTKcommon

#include <Simbody.h>

using namespace SimTK;

int main() {
  MultibodySystem system;
  SimbodyMatterSubsystem matter(system);
  Body::Rigid body(MassProperties(1, Vec3(0), Inertia(1)));
  MobilizedBody::Free ball(matter.Ground(), body);
  matter.adoptUnilateralContact(
      new SpherePlaneContact(matter.updGround(), YAxis, 0, ball, Vec3(0), 1, 0.5, 0.3, 0.3, 0));
  SemiExplicitEulerTimeStepper stepper(system);
  stepper.initialize(system.realizeTopology());
  stepper.stepTo(0.01);
}
