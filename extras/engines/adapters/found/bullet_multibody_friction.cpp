// Bullet: friction bends a multibody's straight slide.
//
// By Coulomb's law a box that slides without spin goes straight on, for speed^2 / (2 friction g). As a
// btMultiBody it leaves its line, by 7 degrees at 45, and goes too far, however short the step.
//   g++ -DBT_USE_DOUBLE_PRECISION bullet_multibody_friction.cpp $(pkg-config --cflags --libs bullet-float64)

#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

int main() {
  const double friction = 0.3, g = 9.81, degree = M_PI / 180;
  for (const double steps : {60, 480, 1920})
    for (const double angle : {0.0, 22.5, 45.0, 67.5}) {
      btDefaultCollisionConfiguration configuration;
      btCollisionDispatcher dispatcher(&configuration);
      btDbvtBroadphase broadphase;
      btMultiBodyConstraintSolver solver;
      btMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
      world.setGravity({0, 0, -g});
      world.getSolverInfo().m_erp2 = 0;
      btBoxShape large({50, 50, 50}), small({0.3, 0.2, 0.02});
      btRigidBody floor(0, nullptr, &large);
      floor.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0, -50}));
      btMultiBody box(0, 1, {0.0135, 0.0301, 0.0433}, false, false);
      box.finalizeMultiDof();
      box.setBasePos({0, 0, 0.02});
      box.setBaseVel({2 * std::cos(angle * degree), 2 * std::sin(angle * degree), 0});
      box.setLinearDamping(0), box.setAngularDamping(0);
      btMultiBodyLinkCollider collider(&box, -1);
      collider.setCollisionShape(&small);
      collider.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0, 0.02}));
      collider.setContactProcessingThreshold(0);
      box.setBaseCollider(&collider);
      collider.setFriction(std::sqrt(friction)), floor.setFriction(std::sqrt(friction));
      world.addMultiBody(&box);
      world.addRigidBody(&floor);
      world.addCollisionObject(&collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
      for (int i = 0; i < 2 * steps; ++i) world.stepSimulation(1 / steps, 1, 1 / steps);
      const btVector3 to = box.getBasePos();
      std::printf("%4g Hz, to %4.1f degrees: comes to rest at %5.2f degrees after %.4f m; Coulomb %.4f m\n",
                  steps, angle, std::atan2(to.y(), to.x()) / degree, std::hypot(to.x(), to.y()),
                  4 / (2 * friction * g));
      world.removeCollisionObject(&collider);
      world.removeRigidBody(&floor);
      world.removeMultiBody(&box);
    }
}
