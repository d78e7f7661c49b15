#pragma once

#include <nlohmann/json.hpp>

#include "solvers/world.hpp"

/// A world as sent to an engine's program, and its states as returned.
namespace oddity::engines {

NLOHMANN_JSON_SERIALIZE_ENUM(Shape::Kind, {{Shape::none, "none"}, {Shape::ball, "ball"}, {Shape::box, "box"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Joint::Kind, {{Joint::hinge, "hinge"},
                                           {Joint::ball, "ball"},
                                           {Joint::cylinder, "cylinder"},
                                           {Joint::slide, "slide"},
                                           {Joint::rod, "rod"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(State, position, orientation, velocity, spin)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Shape, kind, half)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Body, mass, inertia, start, shape)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Joint, kind, a, b, at, axis, end, wheel)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Spring, a, b, at, end, stiffness, rest)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rope::Part, body, factor)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rope, parts, length, stiffness, rest)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(World, gravity, bodies, joints, springs, ropes, floor, friction,
                                   restitution, shaking, frequency, turning)

/// Request to an engine's program, as one line of JSON on its standard input.
struct Request {
  World world;
  std::string variant;
  int frames = 0;
  double frames_per_second = 60;
  int steps_per_frame = 1;
  int runs = 1;           ///< number of timed runs, each from the start
  bool restored = false;  ///< adds a run that is saved half way and continued from there twice
};

/// The reply, as one line.
struct Reply {
  std::vector<std::vector<State>>
      frames;  ///< from the start on, as long as they are numbers; bodies in the world's order
  std::vector<double> seconds;  ///< each run's, without its construction
  bool same_bits = true;        ///< whether all runs have the same bits
  std::string restored;         ///< "same bits", "other bits", "not offered"; empty: not asked
  std::string cannot;           ///< why the engine cannot build the world; empty: it can
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Request, world, variant, frames, frames_per_second, steps_per_frame, runs,
                                   restored)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Reply, frames, seconds, same_bits, restored, cannot)

}  // namespace oddity::engines
