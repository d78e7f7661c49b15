#pragma once

#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "extras/engines/adapters/simulation.hpp"

/// Code shared by Bullet's two kinds of bodies.
namespace oddity::engines {

inline btVector3 vector(const Vector& v) { return {btScalar(v[0]), btScalar(v[1]), btScalar(v[2])}; }
inline Vector vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline btTransform place(const State& s) {
  const auto& [w, x, y, z] = s.orientation;
  return btTransform({btScalar(x), btScalar(y), btScalar(z), btScalar(w)}, vector(s.position));
}

inline State state(const btVector3& position, const btQuaternion& q, const btVector3& velocity,
                   const btVector3& spin) {
  return {vector(position), {q.w(), q.x(), q.y(), q.z()}, vector(velocity), vector(spin)};
}

inline std::unique_ptr<btCollisionShape> shaped(const Shape& shape) {
  if (shape.kind == Shape::ball) return std::make_unique<btSphereShape>(btScalar(shape.half[0]));
  if (shape.kind == Shape::box) return std::make_unique<btBoxShape>(vector(shape.half));
  return std::make_unique<btEmptyShape>();
}

/// Square roots, as Bullet multiplies the coefficients of two touching bodies.
inline void rub(btCollisionObject& object, const World& world) {
  object.setFriction(btScalar(std::sqrt(world.friction)));
  object.setRestitution(btScalar(std::sqrt(world.restitution)));
}

/// A plane; or a box, which another box touches at four points in one step.
inline std::unique_ptr<btRigidBody> floor_of(const World& world, bool box,
                                             std::vector<std::unique_ptr<btCollisionShape>>& shapes) {
  const btVector3 normal = vector(world.floor), half(50, 50, 50);
  if (box)
    shapes.push_back(std::make_unique<btBoxShape>(half));
  else
    shapes.push_back(std::make_unique<btStaticPlaneShape>(normal, 0));
  auto floor = std::make_unique<btRigidBody>(0, nullptr, shapes.back().get());
  if (box) floor->setWorldTransform(btTransform(shortestArcQuat({0, 1, 0}, normal), normal * -half.y()));
  rub(*floor, world);
  return floor;
}

/// A dynamics world, and the objects it consists of.
template <class Solver, class Dynamics>
class BulletSimulation : public Simulation {
 public:
  void set_gravity(const Vector& g) override { world_.setGravity(vector(g)); }
  void step(double seconds) override { world_.stepSimulation(btScalar(seconds), 1, btScalar(seconds)); }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  Solver solver_;

 protected:
  Dynamics world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
};

inline Engine bullet(const std::string& name, decltype(Engine::make) make) {
  const bool in_float = sizeof(btScalar) == sizeof(float);
  return {name + (in_float ? "" : " in double"),
          std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100),
          in_float ? "float" : "double", false, make};
}

}  // namespace oddity::engines
