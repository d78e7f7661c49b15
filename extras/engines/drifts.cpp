#include "extras/engines/drifts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "report/study/results.hpp"
#include "solvers/turns.hpp"

namespace oddity::engines {

namespace {

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

// ---- energy -----------------------------------------------------------------------------------------------

/// Whether energy is conserved in the world.
bool conserves(const World& world) {
  return world.shaking == Vector{} && world.friction == 0 &&
         (world.floor == Vector{} || world.restitution == 1);
}

struct Energy {
  double kinetic = 0, potential = 0;
};

struct Slid {
  double distance, speed;
};
/// Distance slid and speed of the body in its joint since the start.
Slid slid(const World& world, int body, const std::vector<State>& states) {
  const Joint& joint = *std::ranges::find(world.joints, body, &Joint::b);
  const auto moved = [&](int of) {
    if (of == ground) return State{};
    const auto i = static_cast<std::size_t>(of);
    return State{.position = states[i].position - world.bodies[i].start.position,
                 .velocity = states[i].velocity};
  };
  const State a = moved(joint.a), b = moved(joint.b);
  return {dot(joint.axis, b.position - a.position), dot(joint.axis, b.velocity - a.velocity)};
}

Energy energy(const World& world, const std::vector<State>& states) {
  Energy e;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [mass, inertia, start, shape] = world.bodies[i];
    const State& s = states[i];
    const Vector w = turned(inverse(s.orientation), s.spin), swept = cross(world.turning, s.position);
    e.kinetic += mass * dot(s.velocity, s.velocity) / 2;
    for (std::size_t k = 0; k < 3; ++k) e.kinetic += inertia[k] * w[k] * w[k] / 2;
    e.potential -= mass * (dot(world.gravity, s.position) + dot(swept, swept) / 2);
  }
  for (const Spring& spring : world.springs) {
    const Vector along =
        Point(world, spring.b, spring.end).now(states) - Point(world, spring.a, spring.at).now(states);
    const double stretch = length(along) - spring.rest;
    e.potential += spring.stiffness * stretch * stretch / 2;
  }
  for (const Rope& rope : world.ropes) {
    double stretch = rope.length - rope.rest;
    for (const auto& [body, factor] : rope.parts) stretch += factor * slid(world, body, states).distance;
    e.potential += rope.stiffness * stretch * stretch / 2;
  }
  for (const Joint& joint : world.joints)
    if (joint.wheel != 0) {
      const double speed = slid(world, joint.b, states).speed;
      e.kinetic += joint.wheel * speed * speed / 2;
    }
  return e;
}

// ---- momentum ---------------------------------------------------------------------------------------------

/// A momentum, and the part of it that no force changes.
struct Momentum {
  Vector whole, kept;
};
using States = std::vector<State>;
using Keeps = std::function<Momentum(const States&)>;

Vector along(const Vector& unit, const Vector& a) { return dot(unit, a) * unit; }

double mass_of(const World& world) {
  double mass = 0;
  for (const Body& body : world.bodies) mass += body.mass;
  return mass;
}

Vector momentum(const World& world, const States& states) {
  Vector sum{};
  for (std::size_t i = 0; i < states.size(); ++i) sum = sum + world.bodies[i].mass * states[i].velocity;
  return sum;
}

/// Angular momentum about a point that moves at `velocity`.
Vector angular_momentum(const World& world, const States& states, const Vector& point,
                        const Vector& velocity) {
  Vector sum{};
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [mass, inertia, start, shape] = world.bodies[i];
    const State& s = states[i];
    Vector own = turned(inverse(s.orientation), s.spin);
    for (std::size_t k = 0; k < 3; ++k) own[k] *= inertia[k];
    sum = sum + mass * cross(s.position - point, s.velocity - velocity) + turned(s.orientation, own);
  }
  return sum;
}

bool touches_ground(const auto& link) { return link.a == ground || link.b == ground; }

/// Number of joints and springs that hold the bodies.
int holds(const World& world) {
  return static_cast<int>(std::ranges::count_if(world.joints, touches_ground<Joint>) +
                          std::ranges::count_if(world.springs, touches_ground<Spring>) +
                          std::ssize(world.ropes));
}

/// The ball joint on which all bodies hang, if there is exactly one.
const Joint* pivot(const World& world) {
  if (holds(world) != 1) return nullptr;
  const auto found = std::ranges::find_if(
      world.joints, [](const Joint& j) { return j.kind == Joint::ball && touches_ground(j); });
  return found == world.joints.end() ? nullptr : &*found;
}

/// One body that turns about a point of its symmetry axis, its third.
bool is_top(const World& world, const Joint& pivot) {
  if (world.bodies.size() != 1) return false;
  const Body& body = world.bodies[0];
  const Vector tip = Point(world, 0, pivot.at).in_body;
  return body.inertia[0] == body.inertia[1] && std::hypot(tip[0], tip[1]) <= 1e-12 * std::abs(tip[2]);
}

/// Common direction of all external forces except those of a pivot: zero without forces, none if they differ.
std::optional<Vector> direction_of_forces(const World& world) {
  if (world.turning != Vector{}) return std::nullopt;
  Vector direction{};
  for (const Vector& force : {world.gravity, world.shaking, world.floor}) {
    if (force == Vector{}) continue;
    const Vector unit = 1 / length(force) * force;
    if (direction != Vector{} && length(cross(direction, unit)) > 1e-12) return std::nullopt;
    direction = unit;
  }
  if (world.floor != Vector{} && world.friction != 0) return std::nullopt;
  return direction;
}

std::vector<Keeps> kept_when_free(const World& world, const Vector& direction) {
  const auto linear = [&world, direction](const States& s) {
    const Vector p = momentum(world, s);
    return Momentum{p, p - along(direction, p)};
  };
  const auto angular = [&world, direction](const States& s) {
    const Vector velocity = 1 / mass_of(world) * momentum(world, s);
    const Vector L = angular_momentum(world, s, {}, velocity);  // equal about all points with this velocity
    return Momentum{L, world.floor == Vector{} ? L : along(direction, L)};
  };
  return {linear, angular};
}

std::vector<Keeps> kept_momenta(const World& world) {
  const std::optional<Vector> direction = direction_of_forces(world);
  if (direction && holds(world) == 0) return kept_when_free(world, *direction);
  const Joint* const on = pivot(world);
  if (on == nullptr) return {};
  std::vector<Keeps> all;
  if (direction)
    all.push_back([=, &world](const States& s) {
      const Vector L = angular_momentum(world, s, on->at, {});
      return Momentum{L, *direction == Vector{} ? L : along(*direction, L)};
    });
  if (is_top(world, *on))
    all.push_back([=, &world](const States& s) {
      const Vector spin = turned(inverse(s[0].orientation), s[0].spin);
      return Momentum{angular_momentum(world, s, on->at, {}), {0, 0, world.bodies[0].inertia[2] * spin[2]}};
    });
  return all;
}

double drift(const Keeps& keeps, const std::vector<States>& frames) {
  const Vector start = keeps(frames.front()).kept;
  double change = 0, whole = 0;
  for (const States& states : frames) {
    const Momentum now = keeps(states);
    change = std::max(change, length(now.kept - start));
    whole = std::max(whole, length(now.whole));
  }
  return whole > 0 ? change / whole : not_a_number;
}

// ---- joints -----------------------------------------------------------------------------------------------

/// Distance of the joint's ends, or error of a rod's length.
double off(const World& world, const Joint& joint, const std::vector<State>& states) {
  const Vector a = Point(world, joint.a, joint.at).now(states);
  if (joint.kind == Joint::rod)
    return std::abs(length(Point(world, joint.b, joint.end).now(states) - a) - length(joint.end - joint.at));
  const Vector apart = Point(world, joint.b, joint.at).now(states) - a;
  if (joint.kind != Joint::cylinder && joint.kind != Joint::slide) return length(apart);
  return length(apart - dot(apart, joint.axis) * joint.axis);  // the axis does not turn
}

}  // namespace

double energy_drift(const World& world, const std::vector<std::vector<State>>& frames) {
  if (!conserves(world)) return not_a_number;
  const Energy start = energy(world, frames.front());
  double change = 0, moving = 0;
  for (const auto& states : frames) {
    const Energy now = energy(world, states);
    change = std::max(change, std::abs(now.kinetic + now.potential - start.kinetic - start.potential));
    moving = std::max(moving, now.kinetic);
  }
  return moving > 0 ? change / moving : not_a_number;
}

double momentum_drift(const World& world, const std::vector<std::vector<State>>& frames) {
  double most = not_a_number;
  for (const Keeps& keeps : kept_momenta(world)) most = std::fmax(most, drift(keeps, frames));
  return most;
}

double joints_apart(const World& world, const std::vector<std::vector<State>>& frames) {
  double most = 0;
  for (const auto& states : frames)
    for (const Joint& joint : world.joints) most = std::max(most, off(world, joint, states));
  return most;
}

}  // namespace oddity::engines
