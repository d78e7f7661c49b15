#include "extras/engines/drifts.hpp"

#include <cmath>

#include "report/verify/catch.hpp"
#include "solvers/turns.hpp"
#include "tests/near.hpp"

using namespace oddity::engines;

namespace {

using Frames = std::vector<std::vector<State>>;

constexpr double g = 9.81;

/// One body, with state at(t), every tenth of a second.
template <class At>
Frames seen(const At& at) {
  Frames frames;
  for (int i = 0; i <= 20; ++i) frames.push_back({at(0.1 * i)});
  return frames;
}

/// A body of moments 1, 1, 2 without torque: its axis and its spin go round its angular momentum, which is
/// vertical.
State spinning(double t) {
  constexpr double L = 10, tilt = 0.4;
  const Vector up{0, 0, 1};
  const Quaternion own = about(up, -L * std::cos(tilt) / 2 * t);
  State s;
  s.orientation = product(product(about(up, L * t), about({1, 0, 0}, tilt)), own);
  const Vector third = turned(s.orientation, up);
  s.spin = L * (up - 0.5 * dot(up, third) * third);
  return s;
}

/// A top of moments 1, 1, 2 about its mass center, which is 1 m from its tip, in steady precession.
State precessing(double t) {
  constexpr double tilt = 0.5, round = 0.7;
  const Vector up{0, 0, 1};
  State s;
  s.orientation = product(about(up, round * t), about({1, 0, 0}, tilt));
  s.position = turned(s.orientation, up);
  s.spin = round * up + 6.0 * s.position;
  s.velocity = cross(s.spin, s.position);
  return s;
}

Body top() { return {.mass = 1, .inertia = {1, 1, 2}}; }

World with(World world, const State& start) {
  world.bodies[0].start = start;
  return world;
}

}  // namespace

TEST_CASE("a flying body keeps its energy, its momentum across gravity, and its angular momentum",
          "[engines]") {
  const World world = with({.gravity = {0, 0, -g}, .bodies = {top()}}, spinning(0));
  const auto flying = [](double t) {
    State s = spinning(t);
    s.position = {3 * t, 0, 4 * t - g * t * t / 2};
    s.velocity = {3, 0, 4 - g * t};
    return s;
  };
  CHECK(energy_drift(world, seen(flying)) < 1e-13);
  CHECK(momentum_drift(world, seen(flying)) < 1e-13);

  const auto braked = [&](double t) {
    State s = flying(t);
    s.velocity[0] -= 0.3 * t;
    return s;
  };
  CHECK(near_part(momentum_drift(world, seen(braked)), 0.6 / std::hypot(2.4, 4 - 2 * g), 1e-12));

  const auto slowed = [&](double t) {
    State s = flying(t);
    s.spin = (1 - 0.05 * t) * s.spin;
    return s;
  };
  CHECK(near_part(momentum_drift(world, seen(slowed)), 0.1, 1e-12));
  CHECK(energy_drift(world, seen(slowed)) > 0.01);
}

TEST_CASE("a body that spins faster the deeper it is keeps its energy", "[engines]") {
  const World world = with({.gravity = {0, 0, -g}, .bodies = {top()}}, spinning(0));
  const auto unwinding = [](double t) {  // about the axis of moment 2
    State s;
    s.position = {0, 0, -t};
    s.spin = {0, 0, std::sqrt(g * t)};
    return s;
  };
  CHECK(energy_drift(world, seen(unwinding)) < 1e-13);
}

TEST_CASE("a body on a spring keeps its energy, and so does a falling body that turns a wheel", "[engines]") {
  const auto swinging = [](double t) {
    State s;
    s.position = {std::cos(2 * t), 0, 0};
    s.velocity = {-2 * std::sin(2 * t), 0, 0};
    return s;
  };
  const Spring spring{.end = {1, 0, 0}, .stiffness = 4};
  World world = with({.bodies = {top()}, .springs = {spring}}, swinging(0));
  CHECK(energy_drift(world, seen(swinging)) < 1e-13);

  // One kilogram falls with half of gravity's acceleration if it turns the same again.
  const auto falling = [](double t) {
    State s;
    s.position = {0, 0, -g * t * t / 4};
    s.velocity = {0, 0, -g * t / 2};
    return s;
  };
  const Joint wheel{.kind = Joint::slide, .wheel = 1};
  world = with({.gravity = {0, 0, -g}, .bodies = {top()}, .joints = {wheel}}, falling(0));
  CHECK(energy_drift(world, seen(falling)) < 1e-13);
}

TEST_CASE("bodies on a pivot keep their angular momentum along gravity, and a top that about its axis",
          "[engines]") {
  World world = with({.gravity = {0, 0, -g}, .bodies = {top()}, .joints = {{Joint::ball}}}, precessing(0));
  CHECK(momentum_drift(world, seen(precessing)) < 1e-13);
  CHECK(joints_apart(world, seen(precessing)) < 1e-13);

  const auto slower_about_its_axis = [](double t) {
    State s = precessing(t);
    s.spin = s.spin - 0.3 * t * s.position;
    return s;
  };
  CHECK(momentum_drift(world, seen(slower_about_its_axis)) > 0.05);
  const auto slower_round = [](double t) {
    State s = precessing(t);
    s.spin = s.spin - 0.1 * t * Vector{0, 0, 1};
    return s;
  };
  CHECK(momentum_drift(world, seen(slower_round)) > 0.01);

  // Shaken sideways, a symmetric top keeps only the part about its own axis.
  world.shaking = {1, 0, 0};
  const auto pushed_round = [](double t) {
    State s = precessing(t);
    s.velocity = (1 + t) * s.velocity;
    return s;
  };
  CHECK(momentum_drift(world, seen(pushed_round)) < 1e-13);
  CHECK(momentum_drift(world, seen(slower_about_its_axis)) > 0.05);
  world.bodies[0].inertia[0] = 1.5;
  CHECK(std::isnan(momentum_drift(world, seen(precessing))));
}

TEST_CASE("a world that conserves no momentum or no energy has no such drift", "[engines]") {
  const World flying = with({.gravity = {0, 0, -g}, .bodies = {top()}}, spinning(0));
  const Frames frames = seen(spinning);
  World hinged = flying, turning = flying, shaken = flying, rough = flying, inclined = flying,
        smooth = flying, bounced = flying;
  hinged.joints = {{Joint::hinge}};
  turning.turning = {0, 0, 0.1};
  shaken.shaking = {1, 0, 0};
  smooth.floor = {0, 0, 1};
  smooth.restitution = 1;
  rough = smooth;
  rough.friction = 0.3;
  inclined = smooth;
  inclined.floor = {0.6, 0, 0.8};
  bounced = smooth;
  bounced.restitution = 0.5;
  for (const World& world : {hinged, turning, shaken, rough, inclined})
    CHECK(std::isnan(momentum_drift(world, frames)));
  for (const World& world : {flying, smooth, bounced}) CHECK(momentum_drift(world, frames) < 1e-13);
  for (const World& world : {shaken, rough, bounced}) CHECK(std::isnan(energy_drift(world, frames)));
  for (const World& world : {flying, turning, smooth}) CHECK(energy_drift(world, frames) < 1e-13);
}

TEST_CASE("a joint is off by the distance of its ends, a rod by its length", "[engines]") {
  const auto at = [](const Vector& position) {
    return Frames{{State{.position = {1, 0, 0}}}, {State{.position = position}}};
  };
  const World start = with({.bodies = {top()}}, {.position = {1, 0, 0}});
  const auto off = [&](const Joint& joint, const Vector& position) {
    World world = start;
    world.joints = {joint};
    return joints_apart(world, at(position));
  };
  const Joint ball{.kind = Joint::ball, .at = {0, 0, 0}}, rod{.kind = Joint::rod, .end = {1, 0, 0}},
      slide{.kind = Joint::slide, .at = {1, 0, 0}, .axis = {0, 1, 0}};
  CHECK(near_ulps(off(ball, {1, 0.3, 0.4}), 0.5, 64));
  CHECK(near_ulps(off(rod, {0, 1.25, 0}), 0.25, 64));
  CHECK(near(off(rod, {0, 0, 1}), 0, 1e-15));
  CHECK(near_ulps(off(slide, {1, 7, 0.2}), 0.2, 64));
}
