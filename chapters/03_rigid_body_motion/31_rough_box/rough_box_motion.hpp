#pragma once

// Exercise 3.31 as a motion: position and angle of the box in time, through its stop and after.

#include "chapters/03_rigid_body_motion/31_rough_box/rough_box.hpp"
#include "chapters/stops.hpp"

namespace oddity::rough_box {

inline bool fail(Answer& answer, Ending ending, std::string message) {
  answer.ending = ending;
  answer.message = std::move(message);
  return false;
}

/// From stop to stop in the stretched time. How much of it a stop needs is found by Newton's method, from
/// below, as the speed falls.
template <class Algorithm>
Answer slide_in_stretched_time(const Box& b, const Horizon& horizon, double setting) {
  const Stretched box{b};
  Stretched::State x = box.start();
  double s = 0;
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double, double stop) {
    for (int newton = 0; s < box.end() && std::abs(stop - x[6]) > 1e-15 * stop; ++newton) {
      if (newton == 100) return fail(answer, Ending::stalled, "the time of the stop is not met");
      const double part = std::min((stop - x[6]) / box.speed(x[3], x[4], x[5]), box.end() - s);
      const auto end = ode::integrate<Algorithm>(box, x, 0, part, setting);
      answer.evaluations += end.evaluations;
      if (!end.reached()) return fail(answer, end.ending, end.message);
      x = end.value;
      s += part;
    }
    return true;
  };
  through_times(horizon, go_on, [&](double) { seen.insert(seen.end(), x.begin(), x.begin() + 3); });
  answer.value = Value(std::move(seen));
  return answer;
}

/// From stop to stop in time, and from a two-thousandth of the speed on at a steady deceleration.
template <class Algorithm>
Answer slide_until_event(const Box& b, const Horizon& horizon, double setting) {
  const InTime box{b};
  const double least = 5e-4 * box.speed(box.u0, box.v0, box.w0);
  const auto slow = [&](const InTime::State& x, double) { return box.speed(x[3], x[4], x[5]) - least; };
  InTime::State x = box.start();
  bool rests = false;
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double from, double to) {
    if (rests) return true;
    const auto stop = ode::find_event<Algorithm>(box, x, from, to, setting, slow);
    answer.evaluations += stop.evaluations;
    x = stop.value.state;
    if (stop.reached()) {
      const Pose rest = coasted(box, stop.value.time, x);
      std::copy(rest.begin() + 1, rest.end(), x.begin());
      rests = true;
    } else if (stop.value.time != to) {
      return fail(answer, stop.ending, stop.message);
    }
    return true;
  };
  through_times(horizon, go_on, [&](double) { seen.insert(seen.end(), x.begin(), x.begin() + 3); });
  answer.value = Value(std::move(seen));
  return answer;
}

/// By equal steps, none of which takes the box through its stop.
inline Answer slide_with_stick_test(const Box& b, Stepping rule, const Horizon& horizon, double step) {
  const InTime box{b};
  InTime::State x = box.start();
  bool rests = false;
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double from, double to) {
    const double n = count_of_steps(to - from, step), h = (to - from) / n;
    for (double k = 0; k < n && !rests; ++k) {
      if (answer.evaluations > ode::budget)
        return fail(answer, Ending::stalled, "the budget of evaluations is spent");
      if (const auto rest = step_or_stop(box, rule, from + k * h, h, x, answer.evaluations)) {
        std::copy(rest->begin() + 1, rest->end(), x.begin());
        rests = true;
      }
    }
    return true;
  };
  through_times(horizon, go_on, [&](double) { seen.insert(seen.end(), x.begin(), x.begin() + 3); });
  answer.value = Value(std::move(seen));
  return answer;
}

inline Quantity slide(const Box& box, const Horizon& horizon, const Reference& truth) {
  using enum Outcome;
  Quantity q = quantity(
      "slide", "m, m, rad", "position and angle at four times, the last after the stop",
      trajectory(truth, "03_31_slide", {box.a, box.b, box.mu, box.g, box.u0, box.v0, box.w0}, horizon),
      {1e-6, "a micrometre, a fifth of a second of arc"});
  const Knob steps = halving("step", 0.0625, 10), stretched_steps = halving("step", 0.5, 8);
  const InTime full{box}, softened{box, 0.01};
  const std::string soft_1 = "friction regularized at 1 cm/s", order = "its order is too low for this need",
                    trembles = "at the stop friction changes its sign at every step: the box trembles",
                    creeps = "below a centimetre a second friction is too weak";
  Ladder(q, horizon, steps, tolerances(2, 4, 1))
      .closed_form("sliding and spinning apart", Uncoupled{box},
                   box.w0 == 0 || box.sliding_time() == 0 ? ok : inaccurate,
                   "each motion takes friction's direction away from the other, and both last longer")
      .by<ode::ExplicitEuler>(in_time, full, inaccurate, order)
      .by<ode::RungeKutta4>(in_time, full, inaccurate, trembles)
      .by<ode::DormandPrince54>(in_time, full, inaccurate, trembles)
      .by<ode::Fehlberg78>(in_time, full, inaccurate, trembles);
  Ladder(q, horizon, steps, tolerances())
      .by<ode::ExplicitEuler>(soft_1, softened, inaccurate, creeps)
      .by<ode::RungeKutta4>(soft_1, softened, inaccurate, creeps)
      .by<ode::DormandPrince54>(soft_1, softened, inaccurate, creeps)
      .by<ode::Fehlberg78>(soft_1, softened, inaccurate, creeps)
      .by_others(soft_1, softened,
                 {{"modified midpoint", inaccurate, creeps},
                  {"Adams-Bashforth 4", inaccurate, creeps},
                  {"Adams-Bashforth-Moulton 6", inaccurate, creeps},
                  {"linearly implicit Euler", inaccurate, creeps},
                  {"Rosenbrock 4", inaccurate, creeps},
                  {"GSL rk8pd", inaccurate, creeps},
                  {"GSL msadams", inaccurate, creeps},
                  {"GSL msbdf", inaccurate, creeps},
                  {"GSL bsimp", inaccurate, creeps},
                  {"CVODE Adams", inaccurate, creeps},
                  {"CVODE BDF", inaccurate, creeps},
                  {"ARKODE Zonneveld 4(3)", inaccurate, creeps},
                  {"ARKODE Verner 6(5)", inaccurate, creeps}});
  q.add({sticks, "semi-implicit Euler", steps,
         [=](double h) { return slide_with_stick_test(box, Stepping::semi_implicit_euler, horizon, h); },
         inaccurate, order});
  q.add({sticks, midpoint, steps,
         [=](double h) { return slide_with_stick_test(box, Stepping::midpoint, horizon, h); }});
  q.add({event, "Runge-Kutta 4", steps,
         [=](double h) { return slide_until_event<ode::RungeKutta4>(box, horizon, h); }});
  q.add({event, "Dormand-Prince 5(4)", tolerances(),
         [=](double e) { return slide_until_event<ode::DormandPrince54>(box, horizon, e); }});
  q.add({event, "Fehlberg 7(8)", tolerances(),
         [=](double e) { return slide_until_event<ode::Fehlberg78>(box, horizon, e); }});
  q.add({stretched, "Runge-Kutta 4", stretched_steps,
         [=](double h) { return slide_in_stretched_time<ode::RungeKutta4>(box, horizon, h); }});
  q.add({stretched, "Dormand-Prince 5(4)", tolerances(),
         [=](double e) { return slide_in_stretched_time<ode::DormandPrince54>(box, horizon, e); }});
  q.add({stretched, "Fehlberg 7(8)", tolerances(),
         [=](double e) { return slide_in_stretched_time<ode::Fehlberg78>(box, horizon, e); }});
  return q;
}

}  // namespace oddity::rough_box
