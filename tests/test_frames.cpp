// Frames of different lengths, and the four ways to combine them with steps of one length, compared with
// loops by hand.

#include "report/study/frames.hpp"

#include <cmath>
#include <vector>

#include "reference/bad_input.hpp"
#include "report/study/choose.hpp"
#include "report/study/held_steps.hpp"
#include "report/study/run.hpp"
#include "report/study/stability.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/disturbed.hpp"
#include "solvers/ode/explicit_euler.hpp"
#include "solvers/ode/step_lengths.hpp"
#include "solvers/ode/velocity_verlet.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/properties.hpp"

using namespace oddity;

namespace {

/// x'' = -x, from x = 1 at rest.
struct Swing {
  using State = std::array<double, 2>;
  State start() const { return {1, 0}; }
  void operator()(const auto& x, auto& dxdt, const auto&) const { dxdt = {x[1], -x[0]}; }
  State observe(const State& x, double) const { return x; }
};

using State = Swing::State;

State euler(State x, double h) { return {x[0] + h * x[1], x[1] - h * x[0]}; }
State after(long steps, double h) {
  State x{1, 0};
  for (long i = 0; i < steps; ++i) x = euler(x, h);
  return x;
}

/// The values drawn at the times, in steps of h.
std::vector<double> by_hand(const std::vector<double>& times, double h, Stepping stepping) {
  std::vector<double> drawn;
  State divided{1, 0};
  double before = 0;
  for (const double t : times) {
    const long k = static_cast<long>(std::floor(t / h + 1e-9));
    const double late = t - static_cast<double>(k) * h;
    const State last = after(k, h), one_before = after(std::max(0L, k - 1), h);
    State x = last;
    if (stepping == Stepping::divided) {
      const double count = std::ceil((t - before) / h - 1e-9);
      for (int i = 0; i < static_cast<int>(count); ++i) divided = euler(divided, (t - before) / count);
      x = divided;
    } else if (stepping == Stepping::extrapolated) {
      x = euler(last, late);
    } else if (stepping == Stepping::interpolated && k > 0) {
      for (std::size_t i = 0; i < 2; ++i) x[i] = one_before[i] + late / h * (last[i] - one_before[i]);
    }
    drawn.insert(drawn.end(), x.begin(), x.end());
    before = t;
  }
  return drawn;
}

}  // namespace

TEST_CASE("fixed steps meet frames of different lengths like loops by hand", "[frames]") {
  const auto frames = std::make_shared<const std::vector<double>>(
      std::vector<double>{0.004, 0.03, 0.031, 0.05, 0.11, 0.1201, 0.2, 0.2});
  for (const Stepping stepping :
       {Stepping::divided, Stepping::last_step, Stepping::interpolated, Stepping::extrapolated})
    for (const double h : {0.01, 0.025, 0.5}) {
      const Horizon horizon{frames->back(), 7, 0, frames, stepping};
      const Answer answer = observe_integrated<ode::ExplicitEuler>(Swing{}, horizon, h);
      const std::vector<double> expected =
          by_hand(std::vector<double>(frames->begin(), frames->begin() + 7), h, stepping);
      INFO("stepping " << static_cast<int>(stepping) << ", step " << h);
      REQUIRE(answer.value.size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) CHECK(near(answer.value[i], expected[i], 1e-14));
    }
}

TEST_CASE("frames have the requested lengths", "[frames]") {
  CHECK(frame_times({}, 60, 10) == nullptr);

  const auto jittered = frame_times({.jitter = 0.2}, 60, 100);
  double last = 0, shortest = 1, longest = 0;
  for (const double t : jittered->at) {
    shortest = std::min(shortest, t - last);
    longest = std::max(longest, t - last);
    last = t;
  }
  CHECK((shortest >= 0.8 / 60 - 1e-12 && shortest < 0.81 / 60));
  CHECK((longest <= 1.2 / 60 + 1e-12 && longest > 1.19 / 60));
  CHECK(near(jittered->longest, longest, 1e-12));
  CHECK((last <= 100 && last > 100 - 1.2 / 60));
  CHECK(jittered->says == "each up to 20 % longer or shorter");
  CHECK(frame_times({.jitter = 0.2}, 60, 100)->at == jittered->at);

  const auto dropped = frame_times({.drop = 0.25}, 60, 100);
  CHECK(near(static_cast<double>(dropped->at.size()), 4500, 150));
  CHECK(dropped->longest > 2.5 / 60);
  const auto capped = frame_times({.drop = 0.25, .longest = 0.02}, 60, 100);
  CHECK(capped->longest == 0.02);

  CHECK(frame_times({.jitter = 0.2, .seed = 2}, 60, 100)->at != jittered->at);
  CHECK(capped->says == "25 % dropped, none longer than 20 ms");
  CHECK(frame_times({.longest = 0.02}, 60, 1, "yr")->says == "none longer than 0.02 yr");
  const auto traced = frame_times({.trace = {0.01, 0.03}}, 60, 0.1);
  const std::vector<double> expected{0.01, 0.04, 0.05, 0.08, 0.09};
  REQUIRE(traced->at.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(near(traced->at[i], expected[i], 1e-12));
  CHECK(frame_times({.trace = {0.01}}, 60, 0.1)->says == "as in a trace of 1 frame");
  CHECK_THROWS_AS(frame_times({.trace = {2.0}}, 60, 1), BadInput);
  CHECK(complaint([] {
          frame_times({.trace = {1e-6, 1e6}}, 60, 10);
        }) ==
        "the last frame within the horizon of 10 s is drawn at 0.001 ms. So less than half of the motion is "
        "judged: ask for a longer horizon, or cap frames with --max-frame");
  CHECK(frame_times({.longest = 0.1, .trace = {1e-6, 1e6}}, 60, 10)->at.back() > 9.8);
  CHECK_THROWS_AS(frame_times({.jitter = 0.1}, 1e6, 10), BadInput);
}

TEST_CASE("a setting is shown in the scene's unit of time", "[frames]") {
  Need need = game_need();
  need.frame_times = frame_times({.jitter = 0.2}, 60, 10, "yr");
  const auto shown = [&](const std::string& algorithm, double step) {
    return shown_setting(Candidate{"model", algorithm, "step", step}, need);
  };
  CHECK(shown("explicit Euler", need.frame_times->longest) == "1 step per frame");
  CHECK(shown("explicit Euler", 0.01) == "steps up to 0.01 yr");
  CHECK(shown("explicit Euler, last of fixed steps", 0.01) == "steps of 0.01 yr");
  CHECK(shown_span(need, "yr") == "10 yr at 60 frames per yr, each up to 20 % longer or shorter");
}

TEST_CASE("a scene is studied at the task's frames", "[frames]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  Task task(properties::entry_of("3.5"));
  Need need = game_need();
  need.frame_times = frame_times({.drop = 0.25}, need.frames_per_second, need.horizon);
  task.frames = horizon_of(need);
  task.frames_text = shown_rate(need, "s");
  const Results results = run(std::span(&task, 1), truth, false);
  REQUIRE(results.exercises[0].quantities.size() == 1);
  const QuantityResult& swing = results.exercises[0].quantities[0];
  CHECK(swing.says.ends_with(", at 60 frames per second, 25 % dropped"));
  CHECK(swing.reference.value.size() == need.frame_times->at.size());
  CHECK(results.exercises[0].claims.empty());
  CHECK(std::ranges::any_of(swing.methods, [](const MethodResult& method) {
    return method.trials[0].algorithm == "Runge-Kutta 4, fixed steps interpolated";
  }));
}

TEST_CASE("a choice at frames of different lengths is judged where they are drawn", "[frames]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Task task(properties::entry_of("3.5"));
  Need need = game_need();
  need.horizon = 3;
  need.frame_times = frame_times({.jitter = 0.3, .drop = 0.02}, need.frames_per_second, need.horizon);
  const Choice choice = choose(task, need, truth, counted_price);
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->error <= 1);
  for (const double seed : {2, 3, 4, 5, 6}) {  // at other random frames
    Need other = need;
    other.frame_times =
        frame_times({.jitter = 0.3, .drop = 0.02, .seed = seed}, need.frames_per_second, need.horizon);
    const Quantity motion =
        motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(other), truth);
    const Method* chosen = method_of(motion, choice.chosen->model, choice.chosen->algorithm);
    REQUIRE(chosen);
    CHECK(run(motion, *chosen, choice.chosen->setting).error <= degree);
  }

  // The last of fixed steps is up to one step old: the bob has moved on by its speed times that.
  const Quantity motion =
      motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need), truth);
  const auto error_of = [&](const std::string& algorithm) {
    for (const Method& m : motion.methods)
      if (m.model == "one angle" && m.algorithm == algorithm) return run(motion, m, 1.0 / 120).error;
    return not_a_number;
  };
  const double divided = error_of("Runge-Kutta 4"), late = error_of("Runge-Kutta 4, last of fixed steps"),
               between = error_of("Runge-Kutta 4, fixed steps interpolated"),
               ahead = error_of("Runge-Kutta 4, fixed steps extrapolated");
  const double fastest =
      std::sqrt(2 * task.parameters["g"] / task.parameters["L"] * (1 - std::cos(task.parameters["a"])));
  CHECK((late > 0.8 * fastest / 120 && late < 1.01 * fastest / 120));
  CHECK((between > 0.99 * fastest / 120 && between < 1.01 * fastest / 120));
  CHECK(ahead < 0.03 * late);
  CHECK(divided < 1e-3 * ahead);
  CHECK(without_stepping("Runge-Kutta 4, fixed steps extrapolated") == "Runge-Kutta 4");
}

namespace {

/// x'' = -x, whose forces are of position alone.
struct Oscillator {
  using State = std::array<double, 2>;
  State start() const { return {1, 0}; }
  void operator()(const auto& x, auto& dxdt, const auto&) const { dxdt = {x[1], -x[0]}; }
  void acceleration(const auto& q, auto& a) const { a = {-q[0]}; }
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
};

/// Trace of velocity Verlet's matrix over one cycle of the lengths, in steps of h. Between -2 and 2 nothing
/// grows, as the determinant is 1.
double trace_of_verlet(const std::vector<double>& lengths, double h) {
  std::array<double, 4> all{1, 0, 0, 1};
  for (const double length : lengths) {
    const double s = h * length, c = 1 - s * s / 2, d = -s * (1 - s * s / 4);
    all = {c * all[0] + s * all[2], c * all[1] + s * all[3], d * all[0] + c * all[2],
           d * all[1] + c * all[3]};
  }
  return all[0] + all[3];
}

double safe_by_hand(const std::vector<double>& lengths) {
  double h = 0.01;
  while (std::abs(trace_of_verlet(lengths, h)) <= 2 + 1e-9) h += 1e-4;
  return h;
}

}  // namespace

TEST_CASE("varying frames resonate: their stable step is shorter than their longest frame explains",
          "[frames][stability]") {
  Quantity swing;
  SceneMethods(swing, {100}, halving("step", 1, 3), tolerances())
      .by<ode::VelocityVerlet>("swing", Oscillator{});
  const auto safe = [&](const std::vector<double>& lengths) {
    const ode::StepLengths here(lengths);
    return measured_limit(swing.methods.front(), 25).step();
  };
  CHECK(near(safe({1}), measured_limit(swing.methods.front(), 25).step(), 0.02));
  // Every third frame is dropped: the step is doubled.
  const std::vector<double> dropped{1, 2};
  const double found = safe(dropped);
  CHECK(near(found, safe_by_hand(dropped), 0.03));
  CHECK(found < 0.9 * safe({1}) / 2);
}

namespace {

/// An oscillator that keeps the latest time at which its rates are asked for.
struct Watched {
  double* latest;

  void operator()(const State& x, State& dxdt, double t) const {
    *latest = std::max(*latest, t);
    dxdt = {x[1], -x[0]};
  }
};

}  // namespace

TEST_CASE("steps as frames come end with the motion, as equal steps do", "[frames][stability]") {
  double latest = 0;
  const ode::Adapted<ode::AnySystem<2>, Watched> system(Watched{&latest});
  const ode::Disturbed<2> swing(system, {1, 0}, 1);
  for (const std::vector<double>& lengths : {std::vector<double>{1}, {0.7, 1.3}}) {
    const ode::StepLengths here(lengths);
    latest = 0;
    swing.lost("Runge-Kutta 4", 0.3);
    CHECK(latest == 1);
  }
}

TEST_CASE("multistep methods have no limit at frames that vary", "[frames][stability]") {
  HeldSteps held;
  find_stable_at_frames(held, Task(properties::entry_of("3.5")), {.jitter = 0.2}, 1);
  CHECK(held.stable_at_frames.contains({"one angle", "Runge-Kutta 4"}));
  for (const auto& [method, step] : held.stable_at_frames) CHECK_FALSE(ode::is_multistep(method.second));
}

TEST_CASE("the lengths of frames are in units of the usual one, the same at every call", "[frames]") {
  const auto lengths = frame_lengths({.drop = 0.1}, 1000);
  CHECK(lengths == frame_lengths({.drop = 0.1}, 1000));
  CHECK(near(*std::ranges::min_element(lengths), 1, 1e-12));
  CHECK(near(*std::ranges::max_element(lengths), std::round(*std::ranges::max_element(lengths)), 1e-9));
  const auto traced = frame_lengths({.trace = {0.01, 0.03}}, 4);
  REQUIRE(traced.size() >= 2);
  CHECK(near(traced[0], 0.5, 1e-12));
  CHECK(near(traced[1], 1.5, 1e-12));
}
