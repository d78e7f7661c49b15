// Bullet: a box's corners share its load unevenly.
//
// Statics leaves open how four corners share a box's load: a part may move from one diagonal to the other.
// Bullet's solver moves a part that changes in each step, for any number of iterations and any step. With the
// parts read from its contacts, Coulomb's friction at four corners turns a sliding, spinning box as Bullet
// does; with an even share the box turns further.
//   g++ -O2 -DBT_USE_DOUBLE_PRECISION bullet_corner_loads.cpp $(pkg-config --cflags --libs bullet-float64)

#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>
#include <vector>

constexpr double a = 0.3, b = 0.2, h = 0.02, mu = 0.3, g = 9.81, dt = 1.0 / 1920;

// Angle by which Coulomb's friction turns the box, with these parts of the load moved between the diagonals.
double coulomb(const std::vector<double>& parts) {
  double theta = 0, u = 2, v = 0.5, spin = 10, N[4] = {g / 4, g / 4, g / 4, g / 4};
  constexpr int fine = 100;
  for (std::size_t step = 0; step < fine * parts.size() && std::hypot(u, v, a * spin) > 1e-3; ++step) {
    double Fx = 0, Fy = 0, moment = 0, c = std::cos(theta), s = std::sin(theta);
    for (int k = 0; k < 4; ++k) {
      const double x = k < 2 ? a : -a, y = k % 2 ? -b : b;
      const double p = c * u + s * v - spin * y, q = c * v - s * u + spin * x,
                   f = mu * N[k] / std::hypot(p, q);
      Fx -= f * p, Fy -= f * q, moment += f * (y * p - x * q);
    }
    for (int k = 0; k < 4; ++k) {
      const double x = k < 2 ? a : -a, y = k % 2 ? -b : b;
      N[k] = g / 4 - h * (Fx * x / (4 * a * a) + Fy * y / (4 * b * b)) +
             (x * y > 0 ? 1 : -1) * parts[step / fine] * g / 4;
    }
    theta += dt / fine * spin;
    u += dt / fine * (c * Fx - s * Fy), v += dt / fine * (s * Fx + c * Fy),
        spin += dt / fine * moment * 3 / (a * a + b * b);
  }
  return theta * 180 / M_PI;
}

int main() {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, 0, -g});
  world.getSolverInfo().m_numIterations = 100;
  world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
  btBoxShape ground({50, 50, 50}), shape({a, b, h});
  btRigidBody floor(0, nullptr, &ground),
      box(1, nullptr, &shape, {(b * b + h * h) / 3, (a * a + h * h) / 3, (a * a + b * b) / 3});
  floor.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, 0, -50}));
  box.setCenterOfMassTransform(btTransform(btQuaternion::getIdentity(), {0, 0, h}));
  box.setLinearVelocity({2, 0.5, 0});
  box.setAngularVelocity({0, 0, 10});
  box.setActivationState(DISABLE_DEACTIVATION);
  box.setContactProcessingThreshold(0);
  for (btRigidBody* body : {&floor, &box}) body->setFriction(std::sqrt(mu)), world.addRigidBody(body);
  double theta = 0, mean = 0;
  std::vector<double> parts;
  for (int i = 0; i < 1920; ++i) {
    world.stepSimulation(dt, 1, dt);
    theta += dt * box.getAngularVelocity().z();
    double part = 0, all = 0;
    const btPersistentManifold& touch = *dispatcher.getManifoldByIndexInternal(0);
    for (int k = 0; k < touch.getNumContacts(); ++k) {
      const btManifoldPoint& point = touch.getContactPoint(k);
      const btVector3 at = touch.getBody0() == &box ? point.m_localPointA : point.m_localPointB;
      all += point.getAppliedImpulse(), part += point.getAppliedImpulse() * (at.x() * at.y() > 0 ? 1 : -1);
    }
    parts.push_back(all > 0 ? part / all : 0);
    mean += parts.back() / 1920;
  }
  std::printf("Bullet %.2f deg; its part on the other diagonal %.3f in the mean\n", theta * 180 / M_PI, mean);
  std::printf("Coulomb with these parts %.2f deg, with none %.2f deg\n", coulomb(parts),
              coulomb(std::vector<double>(1920)));
}
