#pragma once

#include <algorithm>
#include <bit>
#include <cstring>
#include <tuple>
#include <utility>

#include "extras/lanes/compiled.hpp"
#include "extras/lanes/dormand_prince_54.hpp"

/// Many bodies of one model in lanes. A body is the model with its own parameters and a state, both of single
/// numbers. Its motion has the same bits in lanes as alone.
namespace oddity::lanes {

/// A model of single numbers, and the same model of lanes.
template <class Alone, class Together>
struct Pair {
  using State = typename Together::State;
  using StateAlone = typename Alone::State;
  using Number = typename State::value_type;
  using T = typename Number::value_type;
  static constexpr std::size_t width = Number::size();
};

/// Memory for a model that is filled lane by lane.
template <class Model>
union Room {
  Model model;
  Room() {}
};

/// Puts an object of single numbers into a lane of an object of lanes. Their other members, such as flags,
/// are equal for all lanes, and are copied each time.
template <class Number, class Together, class Alone>
void put(Together& all, std::size_t lane, const Alone& one) {
  using T = typename Number::value_type;
  static_assert(std::is_trivially_copyable_v<Together> && std::is_trivially_copyable_v<Alone>);
  constexpr std::size_t whole = sizeof(Together) / sizeof(Number), left = sizeof(Together) % sizeof(Number);
  static_assert(whole * sizeof(T) <= sizeof(Alone) && sizeof(Alone) - whole * sizeof(T) <= left);
  auto* to = reinterpret_cast<std::byte*>(&all);
  const auto* from = reinterpret_cast<const std::byte*>(&one);
  for (std::size_t i = 0; i < whole; ++i)
    std::memcpy(to + i * sizeof(Number) + lane * sizeof(T), from + i * sizeof(T), sizeof(T));
  if constexpr (left > 0)
    std::memcpy(to + whole * sizeof(Number), from + whole * sizeof(T), sizeof(Alone) - whole * sizeof(T));
}
/// Copies a lane of one object into a lane of another. Members that are not numbers are equal for all.
template <class Number, class All>
void copy_lane(All& to, std::size_t lane, const All& from, std::size_t of) {
  using T = typename Number::value_type;
  static_assert(std::is_trivially_copyable_v<All>);
  for (std::size_t at = 0; at + sizeof(Number) <= sizeof(All); at += sizeof(Number))
    std::memcpy(reinterpret_cast<std::byte*>(&to) + at + lane * sizeof(T),
                reinterpret_cast<const std::byte*>(&from) + at + of * sizeof(T), sizeof(T));
}
/// Copies a lane of a state to a state of single numbers.
template <class Number, class Alone, class Together>
void take(Alone& one, const Together& all, std::size_t lane) {
  for (std::size_t i = 0; i < one.size(); ++i) one[i] = all[i][lane];
}

/// Groups of as many bodies as there are lanes.
template <class Alone, class Together>
struct Grouped {
  using P = Pair<Alone, Together>;
  using Number = typename P::Number;

  static std::size_t groups(std::size_t bodies) { return (bodies + P::width - 1) / P::width; }

  /// Copies of the last body fill up the last group.
  static void put_all(const Alone* models, const typename Alone::State* states, std::size_t bodies,
                      Room<Together>* models_in_lanes, typename P::State* states_in_lanes) {
    for (std::size_t i = 0; i < groups(bodies) * P::width; ++i) {
      const std::size_t body = i < bodies ? i : bodies - 1;
      put<Number>(models_in_lanes[i / P::width].model, i % P::width, models[body]);
      put<Number>(states_in_lanes[i / P::width], i % P::width, states[body]);
    }
  }
  static void take_all(const typename P::State* states_in_lanes, typename Alone::State* states,
                       std::size_t bodies) {
    for (std::size_t i = 0; i < bodies; ++i)
      take<Number>(states[i], states_in_lanes[i / P::width], i % P::width);
  }
};

/// Steps of size h from t0; Stepper is one of report/plain. The time is counted in double. Everything is
/// inlined, so that values that depend only on the model are computed once, and states stay in registers.
template <class Stepper, class Together>
[[gnu::flatten]] void fixed_steps(const Room<Together>* models, typename Together::State* states,
                                  std::size_t groups, double t0, double h, long steps) {
  using Number = typename Together::State::value_type;
  using T = typename Number::value_type;
  for (std::size_t group = 0; group < groups; ++group) {
    const Together model = models[group].model;
    auto x = states[group];
    Stepper stepper;
    for (long i = 0; i < steps; ++i)
      stepper.step(model, x, Number(static_cast<T>(t0 + static_cast<double>(i) * h)),
                   Number(static_cast<T>(h)));
    states[group] = x;
  }
}

/// Integrates from t0 to t1 with the error of a step within `tolerance` (relative, and absolute where a state
/// is below 1), each body with its own steps. A lane that has reached the end waits for the others of its
/// group, unless they have far to go. Then these are put aside as late, and late bodies continue as a group.
template <class Together>
class OwnSteps {
  using State = typename Together::State;
  using Number = typename State::value_type;
  using Mask = typename Number::Mask;
  using T = typename Number::value_type;
  static constexpr std::size_t width = Number::size();
  static constexpr long budget = 1'000'000;

 public:
  OwnSteps(T t0, T t1, T tolerance, T first_step)
      : t0_(t0), end_(t1), tolerance_(tolerance), first_step_(first_step) {}

  /// Returns whether all have reached t1. `each`: one for every body of the groups, or null.
  bool run(const Room<Together>* models, State* states, std::size_t groups, Ended* each) {
    bool reached = true;
    for (std::size_t i = 0; i < groups; ++i) {
      Way way{t0_, first_step_, t0_ < end_};
      reached &= go(models[i].model, states[i], way, width, budget, each ? each + i * width : nullptr);
      if (any_of(way.going))
        for (std::size_t lane = 0; lane < width; ++lane)
          if (way.going.bits() >> lane & 1) reached &= leave({i * width + lane, 0}, lane, way, each);
      while (lates_ >= width) reached &= go_on(models, states, each);
    }
    while (lates_ > 0) reached &= go_on(models, states, each);
    return reached;
  }

 private:
  /// Times and next steps of the lanes; `steps` have been tried.
  struct Way {
    Number t, h;
    Mask going;
    long steps = 0;
  };
  /// A body that continues later.
  struct Late {
    std::size_t body = 0;
    long tried = 0;
    T t = 0, h = 0;
  };

  /// Steps `all` lanes until none is going, or less than half of them are and have far to go, or `most` steps
  /// are tried; then `way` is where these are. Returns whether the lanes that stopped have reached the end;
  /// `each` receives how they ended.
  [[gnu::noinline]] bool go(const Together& model, State& states, Way& way, std::size_t all, long most,
                            Ended* each) const {
    State x = states, slope, ahead, slope_ahead;
    Number t = way.t, h = way.h;
    Mask going = way.going;
    const int half = static_cast<int>(all / 2);
    long steps = 0;
    if (each) note(each, ~going.bits(), 0);
    model(x, slope, t);
    while (any_of(going) && steps < most) {
      const Number left = end_ - t;
      if (steps >= far && std::popcount(going.bits()) < half && any_of(going & (left > T(far) * h))) break;
      const auto last = h >= left;
      h = select(last, left, h);
      const Number error = dormand_prince_54(model, x, slope, t, h, tolerance_, ahead, slope_ahead);
      const auto accurate = error <= Number(1), accepted = accurate & going;
      const Number then = select(last, end_, t + h);
      const auto moves = t + h > t;
      // After a branch the next step need not wait for the error. With several registers this would add one
      // more piece of code.
      if (Number::in_one_register && !any_of(!accepted)) {
        x = ahead;
        slope = slope_ahead;
        t = then;
      } else {
        for (std::size_t i = 0; i < x.size(); ++i) {
          x[i] = select(accepted, ahead[i], x[i]);
          slope[i] = select(accepted, slope_ahead[i], slope[i]);
        }
        t = select(accepted, then, t);
      }
      h = h * factor_after(error);
      const auto before = going;
      going = going & (t < end_) & moves;
      ++steps;
      if (each) note(each, before.bits() & ~going.bits(), steps);
    }
    states = x;
    way.going = going;
    if (any_of(going)) way = {t, h, going, steps};
    const auto there = t == end_;
    if (each)
      for (std::size_t lane = 0; lane < width; ++lane) each[lane].reached = there.bits() >> lane & 1;
    return !any_of(!(there | going));
  }
  static constexpr int far = 8;  // steps

  static void note(Ended* each, std::uint64_t over, long steps) {
    for (std::size_t lane = 0; lane < width; ++lane)
      if (over >> lane & 1) each[lane].steps = steps;
  }

  /// Puts aside the body of a lane that is still going. If its steps are spent, returns false and reports it
  /// in `each`.
  bool leave(Late late, std::size_t lane, const Way& way, Ended* each) {
    late.tried += way.steps;
    if (late.tried < budget) {
      late_[lates_++] = {late.body, late.tried, way.t[lane], way.h[lane]};
      return true;
    }
    if (each) each[late.body] = {late.tried, false};
    return false;
  }

  /// Continues the next late bodies as a group. Their slopes are computed again, and equal those of the step
  /// before, to the bit.
  [[gnu::noinline, gnu::cold]] bool go_on(const Room<Together>* models, State* states, Ended* each) {
    Late now[width] = {};
    const std::size_t count = std::min(width, lates_);
    lates_ -= count;
    std::copy_n(late_ + lates_, count, now);
    const std::size_t first = now[0].body / width;
    Together model = models[first].model;
    State x = states[first];
    Way way{end_, first_step_, {}};
    long tried = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
      const auto [group, of] = std::pair{now[lane].body / width, now[lane].body % width};
      copy_lane<Number>(model, lane, models[group].model, of);
      copy_lane<Number>(x, lane, states[group], of);
      way.t.set(lane, now[lane].t), way.h.set(lane, now[lane].h);
      tried = std::max(tried, now[lane].tried);
    }
    way.going = way.t < end_;
    Ended ended[width] = {};
    bool reached = go(model, x, way, count, budget - tried, each ? ended : nullptr);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::size_t body = now[lane].body;
      copy_lane<Number>(states[body / width], body % width, x, lane);
      if (way.going.bits() >> lane & 1)
        reached &= leave(now[lane], lane, way, each);
      else if (each)
        each[body] = {now[lane].tried + ended[lane].steps, ended[lane].reached};
    }
    return reached;
  }

  /// Factor for the next step, from the error of the last. If no lane has an error, as along a parabola, the
  /// root is not computed.
  Number factor_after(const Number& error) const {
    const Number most(T(1e4)), least(T(1e-4)), shortest(T(0.2));
    const auto errs = !(error < least);
    if (!any_of(errs)) return longest_;
    const Number bounded = greater(lesser(error, most), least);
    return greater(T(0.9) * inverse_fifth_root(bounded), shortest);
  }

  Number t0_, end_, tolerance_, first_step_, longest_ = T(0.9) * inverse_fifth_root(Number(T(1e-4)));
  Late late_[2 * width];
  std::size_t lates_ = 0;
};

}  // namespace oddity::lanes
