// The quantities of exercise 3.31: when and where the box comes to rest, and its path until then and after.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "chapters/03_rigid_body_motion/31_rough_box/rough_box.hpp"
#include "chapters/scene.hpp"
#include "chapters/stops.hpp"
#include "solvers/counted_calls.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/ode/steps_in.hpp"

namespace oddity::ex03_31 {

using namespace rough_box;

namespace {

using Pose = std::array<double, 4>;  ///< time of rest, x, y, theta

/// Sliding and spinning as if each were alone.
Pose uncoupled(const Box& box) {
  const double slide = box.sliding_time(), spin = box.spinning_time();
  return {std::max(slide, spin), box.u0 * slide / 2, box.v0 * slide / 2, box.w0 * spin / 2};
}

/// Pose at rest after a steady deceleration from this time and state.
Pose coasted(const InTime<double>& box, double t, const InTime<double>::State& x) {
  InTime<double>::State rate;
  box(x, rate, t);
  const auto rest = box.coasted(x, rate);
  return {t + box.time_left(x, rate), rest[0], rest[1], rest[2]};
}

template <class Algorithm>
Solved<Pose> stopped_by_event(const Box& b, double setting) {
  const UntilRest<double> box{{b}};
  const auto event = ode::first_event<Algorithm>(box, box.start(), 0, box.p.long_enough(), setting);
  Solved<Pose> rest{coasted(box, event.value.time, event.value.before), event.evaluations + 1};
  rest.ending = event.ending;
  rest.message = event.message;
  return rest;
}

template <class Algorithm>
Solved<Pose> in_stretched_time(const Box& b, double setting) {
  const Stretched<double> box{b};
  const auto end = ode::integrate<Algorithm>(box, box.start(), 0, box.end(), setting);
  const auto& x = end.value;
  Solved<Pose> rest{{x[6], x[0], x[1], x[2]}, end.evaluations};
  rest.ending = end.ending;
  rest.message = end.message;
  return rest;
}

/// Integrates in time through the stop and beyond; `softness` 0 is friction without rest. It gives no time of
/// rest.
template <class Algorithm>
Solved<Pose> through_the_stop(const Box& b, double softness, double setting) {
  const InTime<double> box{b, softness};
  const auto end = ode::integrate<Algorithm>(box, box.start(), 0, box.p.long_enough(), setting);
  const auto& x = end.value;
  Solved<Pose> rest{{box.p.long_enough(), x[0], x[1], x[2]}, end.evaluations};
  rest.ending = end.ending;
  rest.message = end.message;
  return rest;
}

Solved<Pose> with_stick_test(const Box& b, double h) {
  const WithStickTest<double> box(b, true);
  InTime<double>::State x = box.start();
  Solved<Pose> rest;
  const auto rates = counted_calls(box, rest.evaluations);
  const double too_long = box.p.long_enough();
  for (double t = 0; t < too_long; t += h) {
    const auto before = x;
    if (box.step(rates, x, t, h)) {
      rest.value = coasted(box, t, before);
      return rest;
    }
  }
  rest.ending = Ending::stalled;
  rest.message = "the box has not come to rest";
  return rest;
}

// ---- the quantities ---------------------------------------------------------------------------------------

constexpr double need_of_place = 1e-6;  ///< m and rad
std::string need_reason() {
  return filled("a micrometre, @1 seconds of arc", {3600 * need_of_place / degree});
}

Value place(const Pose& rest) { return {rest[1], rest[2], rest[3]}; }
Value moment(const Pose& rest) { return rest[0]; }

const std::string in_time = "friction at full speed only", soft = "regularized friction",
                  stretched = "time stretched by the speed", event = "stopped by event",
                  sticks = "steps with a stick test", midpoint = "explicit midpoint";

/// Adds the methods that compute a time of rest, with `see` applied to their poses.
template <class See>
void add_stopping(Quantity& q, const Box& box, const See& see) {
  const Resolution steps = halving("step", 0.0625, 10), stretched_steps = halving("step", 0.5, 8);
  q.add({"sliding and spinning apart", "closed form", no_resolution(),
         [=](double) {
           return Answer{see(uncoupled(box)), 1};
         },
         box.w0 == 0 ? Outcome::ok : Outcome::inaccurate,
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

Known true_rest(const Box& b, const Reference& truth) {
  return truth("03_31_rest", {b.foot.a, b.foot.b, b.mu, b.g, b.u0, b.v0, b.w0});
}

Quantity time_to_rest(const Box& box, const Reference& truth) {
  Known known = true_rest(box, truth);
  known.value.resize(1);
  Quantity q = quantity("time_to_rest", "s", "when the box comes to rest", known, {1e-6, "a microsecond"});
  add_stopping(q, box, moment);
  return q;
}

Quantity rest(const Box& box, const Reference& truth) {
  Known known = true_rest(box, truth);
  known.value.erase(known.value.begin());
  Quantity q = quantity("rest", "m, m, rad", "position and angle at which the box comes to rest", known,
                        {need_of_place, need_reason()});
  add_stopping(q, box, place);
  const Resolution softness{"softness", {0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001}};
  q.add({in_time, "Runge-Kutta 4", halving("step", 0.0625, 6),
         [=](double h) { return answer(through_the_stop<ode::RungeKutta4>(box, 0, h), place); },
         Outcome::inaccurate, "at the stop friction changes sign within every step: the box never rests"});
  q.add({soft, "Dormand-Prince 5(4), tolerance 1e-9", softness,
         [=](double e) { return answer(through_the_stop<ode::DormandPrince54>(box, e, 1e-9), place); }});
  q.add({soft, "Rosenbrock 4, tolerance 1e-9", softness,
         [=](double e) { return answer(through_the_stop<ode::Rosenbrock4>(box, e, 1e-9), place); }});
  q.add({soft, "Runge-Kutta 4, step 1/256", softness,
         [=](double e) { return answer(through_the_stop<ode::RungeKutta4>(box, e, 0x1p-8), place); },
         Outcome::inaccurate,
         R"(unstable at rest when the step exceeds 2.8 times the softness over $\mu g$)"});
  return q;
}

bool fail(Answer& answer, Ending ending, std::string message) {
  answer.ending = ending;
  answer.message = std::move(message);
  return false;
}

/// The number of a state's observed components: its places, or its places and rates.
enum class Seen { places = 3, places_and_rates = 6 };

/// From stop to stop in the stretched time. The stretched time to each stop is found by Newton's method, from
/// below, as the speed falls.
template <class Algorithm>
Answer slide_in_stretched_time(const Box& b, const Horizon& horizon, double setting, Seen what) {
  const Stretched<double> box{b};
  Stretched<double>::State x = box.start();
  double s = 0;
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double, double stop) {
    for (int newton = 0; s < box.end() && std::abs(stop - x[6]) > 1e-15 * stop; ++newton) {
      if (newton == 100) return fail(answer, Ending::stalled, "the time of the stop is not met");
      const double part = std::min((stop - x[6]) / box.p.speed(x[3], x[4], x[5]), box.end() - s);
      const auto end = ode::integrate<Algorithm>(box, x, 0, part, setting);
      answer.evaluations += end.evaluations;
      if (!end.reached()) return fail(answer, end.ending, end.message);
      x = end.value;
      s += part;
    }
    return true;
  };
  through_times(horizon, go_on,
                [&](double) { seen.insert(seen.end(), x.begin(), x.begin() + static_cast<int>(what)); });
  answer.value = Value(std::move(seen));
  return answer;
}

/// By equal steps, none of which passes through the box's stop.
Answer slide_with_stick_test(const WithStickTest<double>& box, const Horizon& horizon, double step,
                             Seen what) {
  InTime<double>::State x = box.start();
  bool rests = false;
  Answer answer;
  const auto rates = counted_calls(box, answer.evaluations);
  std::vector<double> seen;
  const auto go_on = [&](double from, double to) {
    const double n = ode::steps_in(from, to, step), h = (to - from) / n;
    for (double k = 0; k < n && !rests; ++k) {
      if (answer.evaluations > ode::most_evaluations)
        return fail(answer, Ending::stalled, "the budget of evaluations is spent");
      rests = box.step(rates, x, from + k * h, h);
    }
    return true;
  };
  through_times(horizon, go_on,
                [&](double) { seen.insert(seen.end(), x.begin(), x.begin() + static_cast<int>(what)); });
  answer.value = Value(std::move(seen));
  return answer;
}

}  // namespace

Quantity slide(const Box& box, const Horizon& horizon, const Reference& truth) {
  using enum Outcome;
  Quantity q = quantity("slide", "m, m, rad", "position and angle at four times",
                        trajectory(truth, "03_31_slide",
                                   {box.foot.a, box.foot.b, box.mu, box.g, box.u0, box.v0, box.w0}, horizon),
                        {need_of_place, need_reason()});
  const Resolution steps = halving("step", 0.0625, 10), stretched_steps = halving("step", 0.5, 8);
  constexpr double softness = 0.01;
  const InTime<double> full{box}, softened{box, softness};
  const std::string soft_1 = "friction regularized at 1 cm/s", order = "its order is too low for this need",
                    restless = "at the stop friction changes sign within every step: the box never rests",
                    creeps = filled("below @1 cm/s friction is too weak", {softness / centimeter});
  SceneMethods(q, horizon, steps, tolerances(2, 4, 1))
      .closed_form("sliding and spinning apart", Uncoupled<double>{box}, box.w0 == 0 ? ok : inaccurate,
                   "each motion takes friction's direction away from the other, and both last longer")
      .by<ode::ExplicitEuler>(in_time, full, inaccurate, order)
      .by<ode::RungeKutta4>(in_time, full, inaccurate, restless)
      .by<ode::DormandPrince54>(in_time, full, inaccurate, restless)
      .by<ode::Fehlberg78>(in_time, full, inaccurate, restless);
  SceneMethods(q, horizon, steps, tolerances())
      .by<ode::ExplicitEuler>(soft_1, softened, inaccurate, creeps)
      .by<ode::RungeKutta4>(soft_1, softened, inaccurate, creeps)
      .by<ode::DormandPrince54>(soft_1, softened, inaccurate, creeps)
      .by<ode::Fehlberg78>(soft_1, softened, inaccurate, creeps)
      .by_remaining_integrators(soft_1, softened,
                                {{"modified midpoint", inaccurate, creeps},
                                 {"Adams-Bashforth 4", inaccurate, creeps},
                                 {"Adams-Bashforth-Moulton 6", inaccurate, creeps},
                                 {"linearly implicit Euler", inaccurate, creeps},
                                 {"Rosenbrock 4", inaccurate, creeps},
                                 {"DOP853", inaccurate, creeps},
                                 {"Verner 9(8)", inaccurate, creeps},
                                 {"GSL rk8pd", inaccurate, creeps},
                                 {"GSL msadams", inaccurate, creeps},
                                 {"GSL msbdf", inaccurate, creeps},
                                 {"GSL bsimp", inaccurate, creeps},
                                 {"CVODE Adams", inaccurate, creeps},
                                 {"CVODE BDF", inaccurate, creeps},
                                 {"ARKODE Zonneveld 4(3)", inaccurate, creeps},
                                 {"ARKODE Verner 6(5)", inaccurate, creeps}});
  const auto add = [&](const std::string& model, const std::string& algorithm, const Resolution& resolution,
                       const auto& seen, Outcome expected, const std::string& why) {
    Method method{model,      algorithm,
                  resolution, [=](double setting) { return seen(setting, Seen::places); },
                  expected,   why};
    method.places_and_rates = [=](double setting) { return seen(setting, Seen::places_and_rates).value; };
    q.add(std::move(method));
  };
  const auto by_steps = [=](bool by_midpoint) {
    return [=](double h, Seen what) {
      return slide_with_stick_test(WithStickTest<double>(box, by_midpoint), horizon, h, what);
    };
  };
  const auto by_stretched = [=]<class Algorithm>(std::type_identity<Algorithm>) {
    return [=](double setting, Seen what) {
      return slide_in_stretched_time<Algorithm>(box, horizon, setting, what);
    };
  };
  add(sticks, "semi-implicit Euler", steps, by_steps(false), inaccurate, order);
  add(sticks, midpoint, steps, by_steps(true), ok, "");
  SceneMethods(q, horizon, steps, tolerances())
      .by<ode::RungeKutta4>(event, UntilRest<double>{{box}})
      .by<ode::DormandPrince54>(event, UntilRest<double>{{box}})
      .by<ode::Fehlberg78>(event, UntilRest<double>{{box}});
  add(stretched, "Runge-Kutta 4", stretched_steps, by_stretched(std::type_identity<ode::RungeKutta4>{}), ok,
      "");
  add(stretched, "Dormand-Prince 5(4)", tolerances(),
      by_stretched(std::type_identity<ode::DormandPrince54>{}), ok, "");
  add(stretched, "Fehlberg 7(8)", tolerances(), by_stretched(std::type_identity<ode::Fehlberg78>{}), ok, "");
  return q;
}

std::vector<Quantity> at_rest(const Box& box, const Reference& truth) {
  Quantity end = rest(box, truth);
  end.add(
      Breakdown{"Friction that has full strength at any speed reverses within every step once the box should "
                "rest: the box creeps on. A test whether friction can stop the box within the step "
                "lets it rest.",
                in_time + ", Runge-Kutta 4", 0x1p-8, Outcome::inaccurate, sticks + ", " + midpoint, 0x1p-12});
  end.add(Breakdown{
      R"(Regularized friction is stiff at rest: its rate is $\mu g$ over the softness, and a fixed )"
      R"(explicit step ends by creeping. An implicit method takes its steps from the motion.)",
      soft + ", Runge-Kutta 4, step 1/256", 0.0001, Outcome::inaccurate,
      soft + ", Rosenbrock 4, tolerance 1e-9", 0.0001});
  return {time_to_rest(box, truth), end};
}

}  // namespace oddity::ex03_31
