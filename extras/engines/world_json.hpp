#pragma once

#include <nlohmann/json.hpp>

#include "solvers/world.hpp"

/// A world as it is sent to an engine's program, and its states as they come back.
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

/// What an engine's program is asked, as one line of JSON on its standard input.
struct Request {
  World world;
  std::string variant;
  int frames = 0;
  double frames_per_second = 60;
  int steps_per_frame = 1;
  int runs = 1;           ///< timed, each from the start
  bool restored = false;  ///< one more, saved half way and gone on from there twice
};

/// What it answers, as one line.
struct Reply {
  std::vector<std::vector<State>>
      frames;  ///< from the start on, as long as they are numbers; bodies in the world's order
  std::vector<double> seconds;  ///< each run's, without its making
  bool same_bits = true;        ///< all runs
  std::string restored;         ///< "same bits", "other bits", "not offered"; empty: not asked
  std::string cannot;           ///< why the engine has no such world; empty: it has
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Request, world, variant, frames, frames_per_second, steps_per_frame, runs,
                                   restored)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Reply, frames, seconds, same_bits, restored, cannot)

}  // namespace oddity::engines
