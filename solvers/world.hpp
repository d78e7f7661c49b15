#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

/// A scene in the one form that is given to all third-party engines: SI units, right-handed axes.
///
/// A plane scene lies in x and y, and rotates about z: 2D engines take only these.
namespace oddity::engines {

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z: from the body's axes to the world's

/// State of a body's center of mass, along the world's axes.
struct State {
  Vector position{};
  Quaternion orientation{1, 0, 0, 0};
  Vector velocity{};
  Vector spin{};
};

/// Shape that touches the floor: a ball of radius half[0], or a box.
struct Shape {
  enum Kind { none, ball, box };
  Kind kind = none;
  Vector half{};
};

struct Body {
  double mass = 1;
  Vector inertia{};  ///< principal moments about the center of mass, along the body's axes; not zero
  State start = {};
  Shape shape = {};
};

/// In place of a body: the ground, which does not move.
inline constexpr int ground = -1;

/// A joint. Points and axes are in world coordinates at the start.
struct Joint {
  enum Kind {
    hinge,     ///< b turns about `axis` through `at`
    ball,      ///< b turns about the point `at`
    cylinder,  ///< b turns about `axis` through `at`, and slides along it
    slide,     ///< b moves along `axis`, and does not turn
    rod,       ///< keeps the distance of `at` on a and `end` on b; turns no body that it holds at the center
  };
  Kind kind = hinge;
  int a = ground;
  int b = 0;
  Vector at{};
  Vector axis{0, 0, 1};
  Vector end{};
  double wheel = 0;  ///< for a slide: moment of inertia over radius^2 of the wheel that it turns [kg]
};

/// A spring from `at` on a to `end` on b.
struct Spring {
  int a = ground;
  int b = 0;
  Vector at{};
  Vector end{};
  double stiffness = 0;  ///< N/m
  double rest = 0;       ///< m
};

/// A spring at the end of a rope that runs over wheels without slipping.
struct Rope {
  struct Part {
    int body;
    double factor;  ///< lengthening of the spring per displacement of the body's slide
  };
  std::vector<Part> parts;
  double length = 0;     ///< length of the spring at the start [m]
  double stiffness = 0;  ///< N/m
  double rest = 0;       ///< m
};

struct World {
  Vector gravity{};
  std::vector<Body> bodies = {};
  std::vector<Joint> joints = {};
  std::vector<Spring> springs = {};
  std::vector<Rope> ropes = {};
  Vector floor{};       ///< normal of the floor through the origin, which is solid below it; zero: no floor
  double friction = 0;  ///< between any two bodies
  double restitution = 0;  ///< likewise
  /// Added to gravity as `shaking` sin(`frequency` t): the frame is shaken.
  Vector shaking = {};
  double frequency = 0;
  /// Angular velocity of the axes about the origin: adds the Coriolis and the centrifugal force.
  Vector turning = {};
};

/// A world, and the quantities that a scene observes of its bodies.
struct Staging {
  World world;
  std::function<std::vector<double>(std::span<const State>, double t)> observe;
  std::string differs = {};  ///< how the world differs from the scene, for engines and at any step size
};

}  // namespace oddity::engines
