#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

/// A scene as other people's engines are given it, once for all of them: SI units, right-handed axes.
///
/// A scene in a plane lies in x and y, and turns about z: engines of the plane take those alone.
namespace oddity::engines {

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z: from the body's axes to the world's

/// Of a body's center of mass, along the world's axes.
struct State {
  Vector position{};
  Quaternion orientation{1, 0, 0, 0};
  Vector velocity{};
  Vector spin{};
};

/// What touches the floor: a ball of radius half[0], or a box.
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

/// Instead of a body: what does not move.
inline constexpr int ground = -1;

/// Points and axes are in the world at the start.
struct Joint {
  enum Kind {
    hinge,     ///< b turns about `axis` through `at`
    ball,      ///< b turns about the point `at`
    cylinder,  ///< b turns about `axis` through `at`, and slides along it
    slide,     ///< b moves along `axis`, and does not turn
    rod,  ///< the distance of `at` on a and `end` on b stays; neither turns a body where it is its center
  };
  Kind kind = hinge;
  int a = ground;
  int b = 0;
  Vector at{};
  Vector axis{0, 0, 1};
  Vector end{};
  double wheel = 0;  ///< of a slide: moment of inertia over radius^2 of what it turns [kg]
};

/// From `at` on a to `end` on b.
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
    double factor;  ///< by how much the body's slide lengthens the spring
  };
  std::vector<Part> parts;
  double length = 0;     ///< of the spring at the start [m]
  double stiffness = 0;  ///< N/m
  double rest = 0;       ///< m
};

struct World {
  Vector gravity{};
  std::vector<Body> bodies = {};
  std::vector<Joint> joints = {};
  std::vector<Spring> springs = {};
  std::vector<Rope> ropes = {};
  Vector floor{};          ///< the normal of what fills all below the plane through the origin; zero: none
  double friction = 0;     ///< between any two
  double restitution = 0;  ///< likewise
  /// Gravity has `shaking` sin(`frequency` t) added, as seen from a place that is shaken.
  Vector shaking = {};
  double frequency = 0;
  /// The axes turn about the origin at this rate: with Coriolis's and the centrifugal force.
  Vector turning = {};
};

/// A world, and what a scene observes of its bodies.
struct Staging {
  World world;
  std::function<std::vector<double>(std::span<const State>, double t)> observe;
  std::string differs = {};  ///< what no fine step takes away, where engines have it other than the scene
};

}  // namespace oddity::engines
