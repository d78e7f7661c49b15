// DART 6.12: balls are polyhedra.
//
// By default balls collide as polyhedra (FCL between meshes). One that should roll on at 5/7 of its speed
// sinks in by millimetres, leaves its line and almost stops. With DARTCollisionDetector it is round.
//   g++ -std=c++17 -O2 -I/usr/include/eigen3 dart_balls_are_polyhedra.cpp -ldart && ./a.out

#include <cstdio>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/simulation/World.hpp>

using namespace dart::dynamics;

SkeletonPtr body(const ShapePtr& shape, double z, bool moves) {
  const SkeletonPtr s = Skeleton::create(moves ? "ball" : "floor");
  BodyNode* const b = s->createJointAndBodyNodePair<FreeJoint>().second;
  b->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
  b->setInertia(Inertia(1, Eigen::Vector3d::Zero(), shape->computeInertia(1)));
  s->setPosition(5, z), s->setMobile(moves);
  return s;
}

int main() {
  for (const bool native : {false, true}) {
    const auto world = dart::simulation::World::create();
    auto* const solver = world->getConstraintSolver();
    if (native) solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
    const SkeletonPtr ball = body(std::make_shared<SphereShape>(0.1), 0.1, true);
    world->addSkeleton(ball);
    world->addSkeleton(body(std::make_shared<BoxShape>(Eigen::Vector3d(9, 9, 1)), -0.5, false));
    ball->setVelocity(3, 1);
    for (int i = 0; i < 2000; ++i) world->step();  // 1 ms each
    const Eigen::Vector3d v = ball->getRootBodyNode()->getLinearVelocity();
    std::printf("%-15s: after 2 s its velocity is (%.3f, %.3f, %.3f) m/s, by Coulomb (0.714, 0, 0)\n",
                native ? "DART's detector" : "defaults", v[0], v[1], v[2]);
  }
}
