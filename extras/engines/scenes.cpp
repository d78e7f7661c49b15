#include "extras/engines/scenes.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <map>

#include "chapters/03_rigid_body_motion/25_chain/models.hpp"
#include "chapters/own_reference.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/study/initial_conditions.hpp"
#include "solvers/turns.hpp"

namespace oddity {

namespace engines {

namespace {

/// A scene whose reference is see(t) at every frame, to `error`.
template <class See>
EngineScene at_every_frame(std::string name, std::string title, const Need& need, Staging staging,
                           std::vector<Norm> norms, const See& see, double error, const std::string& by) {
  const Horizon horizon{need.horizon, 1, need.frames_per_second};
  Known known{{}, error, by};
  const auto times = horizon.times();
  for (double t : std::span(times).subspan(1)) {
    const std::vector<double> seen = see(t);
    known.value.insert(known.value.end(), seen.begin(), seen.end());
  }
  Quantity motion = quantity("motion", std::string(norms.front().unit), title, known, {0, "asked for"});
  motion.samples = horizon.count();
  motion.norms = std::move(norms);
  motion.needs = needs_of(need, motion);
  motion.need.allowed = *std::ranges::min_element(motion.needs);
  return {std::move(name), std::move(title), need, std::move(staging), std::move(motion)};
}

// ---- a body that turns freely -----------------------------------------------------------------------------

/// Moments 1 < 2 < 3, and a spin that takes it past its middle axis: it tumbles. Observed is the direction of
/// the constant angular momentum in the body, I w/|L|, by Jacobi's functions [Landau and Lifshitz, Mechanics,
/// 37].
EngineScene free_body(const Need& need) {
  constexpr double I1 = 1, I2 = 2, I3 = 3, w1 = 1.7, w3 = 1;
  constexpr double E2 = I1 * w1 * w1 + I3 * w3 * w3, L2 = I1 * I1 * w1 * w1 + I3 * I3 * w3 * w3;
  const double rate = std::sqrt((I3 - I2) * (L2 - E2 * I1) / (I1 * I2 * I3));
  const double modulus = (I2 - I1) * (E2 * I3 - L2) / ((I3 - I2) * (L2 - E2 * I1));
  const double most2 = std::sqrt((E2 * I3 - L2) / (I2 * (I3 - I2))), L = std::sqrt(L2);
  Body body{1, {I1, I2, I3}};
  body.start.spin = {w1, 0, w3};
  const auto see = [=](double t) {
    double sn, cn, dn;
    if (gsl_sf_elljac_e(rate * t, modulus, &sn, &cn, &dn) != GSL_SUCCESS) sn = cn = dn = NAN;
    return std::vector{I1 * w1 * cn / L, I2 * most2 * sn / L, I3 * w3 * dn / L};
  };
  const Vector momentum{I1 * w1 / L, 0, I3 * w3 / L};
  const auto observe = [momentum](std::span<const State> seen, double) {
    const Vector in_body = turned(inverse(seen[0].orientation), momentum);
    return std::vector<double>(in_body.begin(), in_body.end());
  };
  return at_every_frame("free body", "a body with three moments that turns freely", need,
                        {{.bodies = {body}}, observe}, {{"rad", {0, 1, 2}}}, see, 1e-12,
                        "Jacobi's functions");
}

// ---- a ball that bounces ----------------------------------------------------------------------------------

/// Radius 0.1 m, let go 1 m above its first touch; the floor returns 0.8 of its speed.
EngineScene bouncing_ball(const Need& need) {
  constexpr double g = 9.81, returned = 0.8, radius = 0.1, fall = 1;
  Body ball{1, {0.004, 0.004, 0.004}};
  ball.start.position = {0, radius + fall, 0};
  ball.shape = {Shape::ball, {radius}};
  const auto see = [=](double t) {
    double left = t - std::sqrt(2 * fall / g), speed = std::sqrt(2 * g * fall);
    if (left < 0) return std::vector{radius + fall - g * t * t / 2};
    for (speed *= returned; speed > 1e-9; speed *= returned) {
      if (left < 2 * speed / g) return std::vector{radius + left * (speed - g * left / 2)};
      left -= 2 * speed / g;
    }
    return std::vector{radius};
  };
  const auto observe = [](std::span<const State> seen, double) { return std::vector{seen[0].position[1]}; };
  return at_every_frame(
      "bouncing ball", "a ball that is returned 0.8 of its speed by the floor", need,
      {{.gravity = {0, -g, 0}, .bodies = {ball}, .floor = {0, 1, 0}, .restitution = returned}, observe},
      {{"m", {0}}}, see, 1e-12, "flights in closed form");
}

// ---- a box on its corners ---------------------------------------------------------------------------------

/// The box of exercise 3.31, with Coulomb's friction at its four corners instead of under its whole foot. The
/// friction acts `h` below the center. The corners' loads are linear over the foot and balance its moment.
/// For 1 kg and in the box's axes they are N = g/4 - h (Fx x/(4 a^2) + Fy y/(4 b^2)).
class OnCorners {
 public:
  using State = std::array<double, 6>;  ///< x, y, theta, and their velocities
  static constexpr double a = 0.3, b = 0.2, h = 0.02, mu = 0.3, g = 9.81, inertia = (a * a + b * b) / 3;
  static constexpr State start{0, 0, 0, 2, 0.5, 10};

  void operator()(const State& s, State& dsdt, double) const {
    const double c = std::cos(s[2]), i = std::sin(s[2]);
    const double u = c * s[3] + i * s[4], v = c * s[4] - i * s[3];
    std::array<std::array<double, 2>, 4> along;
    double sum[2]{}, over_x[2]{}, over_y[2]{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [x, y] = corners[k];
      const double slip[2]{u - s[5] * y, v + s[5] * x}, speed = std::hypot(slip[0], slip[1]);
      for (std::size_t j = 0; j < 2; ++j) {
        along[k][j] = speed > 0 ? -slip[j] / speed : 0;
        sum[j] += along[k][j], over_x[j] += x * along[k][j], over_y[j] += y * along[k][j];
      }
    }
    const double p = mu * h / (4 * a * a),
                 q = mu * h / (4 * b * b);  // (1 + p over_x, q over_y) F = mu g/4 sum
    const double det = (1 + p * over_x[0]) * (1 + q * over_y[1]) - q * over_y[0] * p * over_x[1];
    const double Fx = mu * g / 4 * (sum[0] * (1 + q * over_y[1]) - sum[1] * q * over_y[0]) / det;
    const double Fy = mu * g / 4 * (sum[1] * (1 + p * over_x[0]) - sum[0] * p * over_x[1]) / det;
    double moment = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [x, y] = corners[k];
      const double N = g / 4 - h * (Fx * x / (4 * a * a) + Fy * y / (4 * b * b));
      moment += mu * N * (x * along[k][1] - y * along[k][0]);
    }
    dsdt = {s[3], s[4], s[5], c * Fx - i * Fy, i * Fx + c * Fy, moment / inertia};
  }

  /// x, y and theta at every frame. The box rests where a step would stop it.
  std::vector<double> seen(const Need& need, int steps_per_frame) const {
    boost::numeric::odeint::runge_kutta4<State> stepper;
    const double dt = 1 / (need.frames_per_second * steps_per_frame);
    State s = start;
    bool rests = false;
    std::vector<double> seen;
    for (int frame = 0; frame < need.frames(); ++frame) {
      for (int i = 0; i < steps_per_frame && !rests; ++i) {
        stepper.do_step(*this, s, 0, dt);
        rests = std::hypot(s[3], s[4], a * s[5]) < 4 * mu * g * dt;
      }
      seen.insert(seen.end(), s.begin(), s.begin() + 3);
    }
    return seen;
  }

 private:
  static constexpr std::array<std::array<double, 2>, 4> corners{{{a, b}, {a, -b}, {-a, b}, {-a, -b}}};
};

EngineScene box_on_corners(const Need& need) {
  using Box = OnCorners;
  Body box{1,
           {(Box::b * Box::b + Box::h * Box::h) / 3, (Box::a * Box::a + Box::h * Box::h) / 3, Box::inertia}};
  box.start = {.position = {0, 0, Box::h},
               .velocity = {Box::start[3], Box::start[4], 0},
               .spin = {0, 0, Box::start[5]}};
  box.shape = {Shape::box, {Box::a, Box::b, Box::h}};
  const auto seen = Box().seen(need, 400), again = Box().seen(need, 200);
  const auto see = [&](double t) {
    const auto at = static_cast<std::ptrdiff_t>(3 * std::lround(t * need.frames_per_second) - 3);
    return std::vector(seen.begin() + at, seen.begin() + at + 3);
  };
  const auto observe = [](std::span<const State> states, double) {
    const auto [w, x, y, z] = states[0].orientation;
    return std::vector{states[0].position[0], states[0].position[1], 2 * std::atan2(z, w)};
  };
  return at_every_frame(
      "box on corners", "the box of 3.31 with Coulomb's friction at its four corners", need,
      {{.gravity = {0, 0, -Box::g}, .bodies = {box}, .floor = {0, 0, 1}, .friction = Box::mu}, observe},
      {{"m", {0, 1}}, {"rad", {2}}}, see, distance(seen, again), "Runge-Kutta 4 at two steps");
}

// ---- chains of many links ---------------------------------------------------------------------------------

/// n links with 1 m and 1 kg in total, straight at an angle from the vertical, let go.
class Chain {
 public:
  Chain(int n, double angle) : m_(static_cast<std::size_t>(n), 1.0 / n), r_(m_), start_(2 * m_.size(), 0.0) {
    std::fill_n(start_.begin(), m_.size(), angle);
  }

  void operator()(const std::vector<double>& x, std::vector<double>& dxdt, double) const {
    const auto n = static_cast<std::ptrdiff_t>(m_.size());
    const std::vector<double> theta(x.begin(), x.begin() + n), omega(x.begin() + n, x.end());
    std::vector<double> alpha(theta);
    chain::by_tensions(m_, r_, g, theta, omega, alpha);
    std::ranges::copy(omega, dxdt.begin());
    std::ranges::copy(alpha, dxdt.begin() + n);
  }
  /// The last mass at every frame.
  template <class Stepper>
  std::vector<double> ends(const Stepper& stepper, const Need& need) const {
    std::vector<double> x = start_, seen;
    std::vector<double> times;
    for (int i = 0; i <= need.frames(); ++i) times.push_back(i / need.frames_per_second);
    boost::numeric::odeint::integrate_times(stepper, *this, x, times.begin(), times.end(), 1e-3,
                                            [&](const std::vector<double>& at, double t) {
                                              if (t == 0) return;
                                              const auto [across, up] = end_of(at);
                                              seen.insert(seen.end(), {across, up});
                                            });
    return seen;
  }
  World world() const {
    World world{.gravity = {0, -g, 0}};
    Vector at{};
    for (std::size_t k = 0; k < m_.size(); ++k) {
      Body mass{m_[k],
                {0.1 * m_[k] * r_[k] * r_[k], 0.1 * m_[k] * r_[k] * r_[k], 0.1 * m_[k] * r_[k] * r_[k]}};
      mass.start.position = at + Vector{r_[k] * std::sin(start_[k]), -r_[k] * std::cos(start_[k]), 0};
      const int b = static_cast<int>(k);
      world.joints.push_back({.kind = Joint::rod, .a = b - 1, .b = b, .at = at, .end = mass.start.position});
      at = mass.start.position;
      world.bodies.push_back(mass);
    }
    return world;
  }

 private:
  static constexpr double g = 9.81;

  std::pair<double, double> end_of(const std::vector<double>& x) const {
    double across = 0, up = 0;
    for (std::size_t k = 0; k < m_.size(); ++k)
      across += r_[k] * std::sin(x[k]), up -= r_[k] * std::cos(x[k]);
    return {across, up};
  }

  std::vector<double> m_, r_, start_;
};

/// By two algorithms, which must agree. From 0.5 rad the differences of a hundred links grow a millionfold
/// between the seventh and the tenth second; from 0.3 rad they do not.
EngineScene chain_of(int n, const Need& need) {
  namespace odeint = boost::numeric::odeint;
  const double angle = n < 100 ? 0.5 : 0.3;
  const Chain chain(n, angle);
  const auto seen = chain.ends(
      odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<std::vector<double>>()), need);
  const auto again = chain.ends(odeint::bulirsch_stoer<std::vector<double>>(1e-12, 1e-12), need);
  const auto see = [&](double t) {
    const auto at = static_cast<std::ptrdiff_t>(2 * std::lround(t * need.frames_per_second) - 2);
    return std::vector(seen.begin() + at, seen.begin() + at + 2);
  };
  const auto observe = [](std::span<const State> masses, double) {
    const auto& end = masses.back().position;
    return std::vector{end[0], end[1]};
  };
  const std::string name = "chain of " + std::to_string(n);
  return at_every_frame(
      name, "a " + name + " links, 1 m long, let go straight at " + format_shortest(angle) + " rad; its end",
      need, {chain.world(), observe}, {{"m", {0, 1}}}, see, distance(seen, again),
      "Fehlberg 7(8) and Bulirsch-Stoer");
}

}  // namespace

}  // namespace engines

namespace {

using Make = EngineScene (*)(const Need&);
const std::vector<std::pair<std::string, Make>>& generators() {
  static const std::vector<std::pair<std::string, Make>> all{
      {"free body", engines::free_body},
      {"bouncing ball", engines::bouncing_ball},
      {"box on corners", engines::box_on_corners},
      {"chain of 10", [](const Need& need) { return engines::chain_of(10, need); }},
      {"chain of 100", [](const Need& need) { return engines::chain_of(100, need); }}};
  return all;
}

}  // namespace

bool has_engine_scene(const Entry& entry) { return entry.exercise.scene && entry.exercise.scene->staging; }

void require_engine_scene(const Entry& entry) {
  if (has_engine_scene(entry)) return;
  if (entry.number.chapter == 0)
    throw BadInput("this file does not stage its scene for engines: add [staged] with its bodies and joints");
  std::string those;
  for (const Entry& other : registry())
    if (has_engine_scene(other)) those += (those.empty() ? "" : ", ") + to_string(other.number);
  throw BadInput(to_string(entry.number) + " is not set up for engines; " + those + " are");
}

EngineScene engine_scene(const Task& task, const Need& need, const Reference& truth) {
  require_engine_scene(*task.entry);
  InitialConditions starts(task, need, truth);
  return {to_string(task.entry->number), std::string(task.entry->exercise.title), need,
          task.entry->exercise.scene->staging(task.parameters), starts.asked().motion};
}

std::vector<std::string> further_engine_scenes() {
  std::vector<std::string> names;
  for (const auto& [name, make] : generators()) names.push_back(name);
  return names;
}

EngineScene further_engine_scene(const std::string& name, const Need& need) {
  const auto found = std::ranges::find(generators(), name, &std::pair<std::string, Make>::first);
  if (found == generators().end())
    throw BadInput("there is no scene '" + name + "' for engines" +
                   did_you_mean(name, further_engine_scenes()));
  return found->second(need);
}

}  // namespace oddity
