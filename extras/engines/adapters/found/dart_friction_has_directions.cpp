// DART 6.12: friction depends on the direction.
//
// Friction is limited in each of two directions separately: a box that slides along their diagonal stops
// after 71 % of the distance of one that slides along an axis.
//   g++ -std=c++17 -O2 -I/usr/include/eigen3 dart_friction_has_directions.cpp -ldart && ./a.out

#include <cstdio>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/simulation/World.hpp>

using namespace dart::dynamics;

SkeletonPtr box(const Eigen::Vector3d& size, double z, bool moves) {
  const SkeletonPtr s = Skeleton::create(moves ? "box" : "floor");
  BodyNode* const body = s->createJointAndBodyNodePair<FreeJoint>().second;
  auto* const shape =
      body->createShapeNodeWith<CollisionAspect, DynamicsAspect>(std::make_shared<BoxShape>(size));
  shape->getDynamicsAspect()->setFrictionCoeff(0.3);
  s->setPosition(5, z), s->setMobile(moves);
  return s;
}

int main() {
  for (const double angle : {0., 0.785398}) {
    const auto world = dart::simulation::World::create();
    const SkeletonPtr sliding = box({0.6, 0.4, 0.2}, 0.1, true);
    world->addSkeleton(box({9, 9, 1}, -0.5, false)), world->addSkeleton(sliding);
    sliding->setVelocity(3, 2 * std::cos(angle)), sliding->setVelocity(4, 2 * std::sin(angle));
    for (int i = 0; i < 2000; ++i) world->step();
    std::printf("at %2.0f degrees: stops after %.3f m; by Coulomb after %.3f m\n", angle * 57.29578,
                std::hypot(sliding->getPosition(3), sliding->getPosition(4)), 2 * 2 / (2 * 0.3 * 9.81));
  }
}
