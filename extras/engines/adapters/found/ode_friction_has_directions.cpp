// ODE 0.16: friction depends on the direction.
//
// Friction is limited in each of two directions separately, also where it is proportional to the pressure
// (dContactApprox1). A box that slides along their diagonal stops after 71 % of the distance of one that
// slides along an axis.
//   g++ ode_friction_has_directions.cpp -lode && ./a.out

#include <ode/ode.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

namespace {

dWorldID world;
dJointGroupID contacts;

void touch(void*, dGeomID a, dGeomID b) {
  dContact c[8] = {};
  for (int i = dCollide(a, b, 8, &c[0].geom, sizeof(dContact)); i-- > 0;) {
    c[i].surface.mode = dContactApprox1;
    c[i].surface.mu = 0.3;
    dJointAttach(dJointCreateContact(world, contacts, &c[i]), dGeomGetBody(a), dGeomGetBody(b));
  }
}

}  // namespace

int main() {
  dInitODE2(0);
  contacts = dJointGroupCreate(0);
  for (const double degrees : {0., 45.}) {
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, -9.81);
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dCreatePlane(space, 0, 0, 1, 0);
    const dBodyID body = dBodyCreate(world);
    dGeomSetBody(dCreateBox(space, 0.6, 0.4, 0.04), body);
    dBodySetPosition(body, 0, 0, 0.02);
    dBodySetLinearVel(body, 2 * std::cos(degrees * M_PI / 180), 2 * std::sin(degrees * M_PI / 180), 0);
    for (int step = 0; step < 2000; ++step) {
      dSpaceCollide(space, nullptr, touch);
      dWorldStep(world, 1e-3);
      dJointGroupEmpty(contacts);
    }
    const dReal* at = dBodyGetPosition(body);
    std::printf("at %2.0f degrees: stops after %.3f m; by Coulomb after %.3f m\n", degrees,
                std::hypot(at[0], at[1]), 2 * 2 / (2 * 0.3 * 9.81));
    dSpaceDestroy(space);
    dWorldDestroy(world);
  }
}
