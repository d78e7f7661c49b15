#pragma once

// The quantities of exercise 3.31.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "chapters/03_rigid_body_motion/31_rough_box/models.hpp"
#include "chapters/scene.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/ode/events.hpp"

namespace oddity::rough_box {

using Pose = std::array<double, 4>;  ///< time of rest, x, y, theta

/// Sliding and spinning as if each were alone.
inline Pose uncoupled(const Box& box) {
  const double slide = box.sliding_time(), spin = box.spinning_time();
  return {std::max(slide, spin), box.u0 * slide / 2, box.v0 * slide / 2, box.w0 * spin / 2};
}

/// The state in which a box rests that is decelerated steadily from now on.
inline Pose coasted(const InTime& box, double t, const InTime::State& x) {
  const auto f = box.friction(x[2], x[3], x[4], x[5]);
  const double now = box.speed(x[3], x[4], x[5]);
  const double left = now * now / -(x[3] * f[0] + x[4] * f[1] + box.J() * x[5] * f[2]);
  return {t + left, x[0] + x[3] * left / 2, x[1] + x[4] * left / 2, x[2] + x[5] * left / 2};
}

/// In time until a two-thousandth of the speed is left, and from there at a steady deceleration.
template <class Algorithm>
Solved<Pose> stopped_by_event(const Box& b, double setting) {
  const InTime box{b};
  const double least = 5e-4 * box.speed(box.u0, box.v0, box.w0);
  const auto slow = [&](const InTime::State& x, double) { return box.speed(x[3], x[4], x[5]) - least; };
  const auto event = ode::find_event<Algorithm>(box, box.start(), 0, box.long_enough(), setting, slow);
  Solved<Pose> rest{coasted(box, event.value.time, event.value.state), event.evaluations + 1};
  rest.ending = event.ending;
  rest.message = event.message;
  return rest;
}

template <class Algorithm>
Solved<Pose> in_stretched_time(const Box& b, double setting) {
  const Stretched box{b};
  const auto end = ode::integrate<Algorithm>(box, box.start(), 0, box.end(), setting);
  const auto& x = end.value;
  Solved<Pose> rest{{x[6], x[0], x[1], x[2]}, end.evaluations};
  rest.ending = end.ending;
  rest.message = end.message;
  return rest;
}

/// In time through the stop and on; `softness` 0 is friction that knows no rest. It gives no time of rest.
template <class Algorithm>
Solved<Pose> through_the_stop(const Box& b, double softness, double setting) {
  const InTime box{b, softness};
  const auto end = ode::integrate<Algorithm>(box, box.start(), 0, box.long_enough(), setting);
  const auto& x = end.value;
  Solved<Pose> rest{{box.long_enough(), x[0], x[1], x[2]}, end.evaluations};
  rest.ending = end.ending;
  rest.message = end.message;
  return rest;
}

/// One step with a test whether friction can stop the box within it; if so, the pose in which it rests.
enum class Stepping { semi_implicit_euler, midpoint };
inline std::optional<Pose> step_or_stop(const InTime& box, Stepping rule, double t, double h,
                                        InTime::State& x, long& evaluations) {
  const auto rhs = counted_calls(box, evaluations);
  InTime::State rate{}, half{};
  rhs(x, rate, t);
  const double now = box.speed(x[3], x[4], x[5]);
  const double braking = -(x[3] * rate[3] + x[4] * rate[4] + box.J() * x[5] * rate[5]) / now;
  if (now <= h * braking) return coasted(box, t, x);
  if (rule == Stepping::midpoint) {
    for (std::size_t i = 0; i < 6; ++i) half[i] = x[i] + h / 2 * rate[i];
    rhs(half, rate, t + h / 2);
    for (std::size_t i = 0; i < 6; ++i) x[i] += h * rate[i];
  } else {
    for (std::size_t i = 3; i < 6; ++i) x[i] += h * rate[i];
    for (std::size_t i = 0; i < 3; ++i) x[i] += h * x[i + 3];
  }
  return {};
}

inline Solved<Pose> with_stick_test(const Box& b, double h) {
  const InTime box{b};
  InTime::State x = box.start();
  Solved<Pose> rest;
  const double too_long = box.long_enough();
  for (double t = 0; t < too_long; t += h)
    if (const auto pose = step_or_stop(box, Stepping::midpoint, t, h, x, rest.evaluations)) {
      rest.value = *pose;
      return rest;
    }
  rest.ending = Ending::stalled;
  rest.message = "the box has not come to rest";
  return rest;
}

// ---- the quantities ---------------------------------------------------------------------------------------

inline Value place(const Pose& rest) { return {rest[1], rest[2], rest[3]}; }
inline Value moment(const Pose& rest) { return rest[0]; }

inline const std::string in_time = "friction at full speed only", soft = "regularized friction",
                         stretched = "time stretched by the speed", event = "stopped by event",
                         sticks = "steps with a stick test", midpoint = "explicit midpoint";

/// The methods that know a time of rest, seen through `see`.
template <class See>
void add_stopping(Quantity& q, const Box& box, const See& see) {
  const Knob steps = halving("step", 0.0625, 10), stretched_steps = halving("step", 0.5, 8);
  q.add({"sliding and spinning apart", "closed form", no_knob(),
         [=](double) {
           return Answer{see(uncoupled(box)), 1};
         },
         box.w0 == 0 || box.sliding_time() == 0 ? Outcome::ok : Outcome::inaccurate,
         "each motion takes friction's direction away from the other, and both last longer"});
  q.add({stretched, "Runge-Kutta 4", stretched_steps,
         [=](double h) { return answer(in_stretched_time<ode::RungeKutta4>(box, h), see); }});
  q.add({stretched, "Dormand-Prince 5(4)", tolerances(),
         [=](double e) { return answer(in_stretched_time<ode::DormandPrince54>(box, e), see); }});
  q.add({stretched, "Fehlberg 7(8)", tolerances(),
         [=](double e) { return answer(in_stretched_time<ode::Fehlberg78>(box, e), see); }});
  q.add({event, "Dormand-Prince 5(4)", tolerances(),
         [=](double e) { return answer(stopped_by_event<ode::DormandPrince54>(box, e), see); }});
  q.add({event, "Runge-Kutta 4", steps,
         [=](double h) { return answer(stopped_by_event<ode::RungeKutta4>(box, h), see); }});
  q.add({sticks, midpoint, steps, [=](double h) { return answer(with_stick_test(box, h), see); }});
}

inline Known true_rest(const Box& b, const Reference& truth) {
  return truth("03_31_rest", {b.a, b.b, b.mu, b.g, b.u0, b.v0, b.w0});
}

inline Quantity time_to_rest(const Box& box, const Reference& truth) {
  Known known = true_rest(box, truth);
  known.value.resize(1);
  Quantity q = quantity("time_to_rest", "s", "when the box comes to rest", known, {1e-6, "a microsecond"});
  add_stopping(q, box, moment);
  return q;
}

inline Quantity rest(const Box& box, const Reference& truth) {
  Known known = true_rest(box, truth);
  known.value.erase(known.value.begin());
  Quantity q = quantity("rest", "m, m, rad", "position and angle at which the box comes to rest", known,
                        {1e-6, "a micrometre, a fifth of a second of arc"});
  add_stopping(q, box, place);
  const Knob softness{"softness", {0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001}};
  q.add({in_time, "Runge-Kutta 4", halving("step", 0.0625, 6),
         [=](double h) { return answer(through_the_stop<ode::RungeKutta4>(box, 0, h), place); },
         Outcome::inaccurate, "at the stop friction changes its sign at every step: the box trembles"});
  q.add({soft, "Dormand-Prince 5(4), tolerance 1e-9", softness,
         [=](double e) { return answer(through_the_stop<ode::DormandPrince54>(box, e, 1e-9), place); }});
  q.add({soft, "Rosenbrock 4, tolerance 1e-9", softness,
         [=](double e) { return answer(through_the_stop<ode::Rosenbrock4>(box, e, 1e-9), place); }});
  q.add({soft, "Runge-Kutta 4, step 1/256", softness,
         [=](double e) { return answer(through_the_stop<ode::RungeKutta4>(box, e, 0x1p-8), place); },
         Outcome::inaccurate, "unstable at rest when the step exceeds 2.8 softness / (mu g)"});
  return q;
}

}  // namespace oddity::rough_box
