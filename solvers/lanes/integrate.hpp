#pragma once

#include <cstring>
#include <tuple>

#include "solvers/lanes/compiled.hpp"
#include "solvers/lanes/dormand_prince_54.hpp"

/// Many bodies of one model in lanes. A body is the model with its own parameters, and its state, both of
/// single numbers; its motion has the same bits in lanes as alone.
namespace oddity::lanes {

/// A model of single numbers, and the same of lanes.
template <class Alone, class Together>
struct Pair {
  using State = typename Together::State;
  using StateAlone = typename Alone::State;
  using Number = typename State::value_type;
  using T = typename Number::value_type;
  static constexpr std::size_t width = Number::size();
};

/// Room for a model, which is made lane by lane.
template <class Model>
union Room {
  Model model;
  Room() {}
};

/// Puts what is made of single numbers into a lane of what is made of lanes. What else both have, such as a
/// flag, is the same for all, and is put with the first.
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
/// The other way, of a state.
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

  /// The last body stands in for those that there are not.
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

/// Steps of the size h from t0; Stepper is such as those of report/plain. The time is counted in double.
template <class Stepper, class Together>
void fixed_steps(const Room<Together>* models, typename Together::State* states, std::size_t groups,
                 double t0, double h, long steps) {
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

/// From t0 to t1 with the error of a step held at `tolerance` (relative, and absolute where a state is below
/// 1), each body by its own steps. A lane whose body has come to the end takes the next one.
template <class Alone, class Together>
class OwnSteps {
  using P = Pair<Alone, Together>;
  using Number = typename P::Number;
  using T = typename P::T;
  static constexpr long budget = 1'000'000;

 public:
  OwnSteps(const Alone* models, typename Alone::State* states, Ended* ended, std::size_t bodies)
      : models_(models), states_(states), ended_(ended), bodies_(bodies) {}

  void run(T t0, T t1, T tolerance, T first_step) {
    t0_ = t0, t1_ = t1, first_step_ = first_step;
    for (std::size_t lane = 0; lane < P::width; ++lane) {
      body_[lane] = 0;
      put<Number>(room_.model, lane, models_[0]);
      put<Number>(x_, lane, states_[0]);
      begin(lane);
    }
    room_.model(x_, slope_, t_);
    while (active_) {
      const unsigned over = step(tolerance) & active_;
      if (over) replace(over);
    }
  }

 private:
  /// A bit for each lane that is at its end.
  unsigned step(const Number& tolerance) {
    const Number end(t1_), left = end - t_;
    const auto last = h_ >= left;
    const Number h = select(last, left, h_);
    const auto tried = dormand_prince_54(room_.model, x_, slope_, t_, h, tolerance);
    const Number error = select(tried.error < Number(T(1e4)), tried.error, Number(T(1e4)));
    const Number factor =
        T(0.9) * inverse_fifth_root(select(error > Number(T(1e-4)), error, Number(T(1e-4))));
    const Number next = h * select(factor > Number(T(0.2)), factor, Number(T(0.2)));
    const auto accepted = tried.error <= Number(1);
    const Number then = select(last, end, t_ + h);
    const auto stuck = (t_ + h == t_) & (t_ < end);
    x_ = select(accepted, tried.x, x_);
    slope_ = select(accepted, tried.slope, slope_);
    t_ = select(accepted, then, t_);
    h_ = next;
    steps_ += Number(1);
    return ((t_ == end) | stuck | (steps_ > Number(T(budget)))).bits();
  }

  void begin(std::size_t lane) {
    t_.set(lane, t0_), h_.set(lane, first_step_), steps_.set(lane, T(0));
    if (next_ < bodies_) {
      body_[lane] = next_++;
      put<Number>(room_.model, lane, models_[body_[lane]]);
      put<Number>(x_, lane, states_[body_[lane]]);
      active_ |= 1u << lane;
    } else {
      active_ &= ~(1u << lane);
    }
  }
  void replace(unsigned over) {
    for (std::size_t lane = 0; lane < P::width; ++lane) {
      if (!(over >> lane & 1)) continue;
      take<Number>(states_[body_[lane]], x_, lane);
      ended_[body_[lane]] = {static_cast<long>(steps_[lane]), t_[lane] == t1_};
      begin(lane);
    }
    // The slopes of those that go on stay what they were, to the bit.
    typename P::State slope;
    room_.model(x_, slope, t_);
    slope_ = select(t_ == Number(t0_), slope, slope_);
  }

  const Alone* models_;
  typename Alone::State* states_;
  Ended* ended_;
  std::size_t bodies_, next_ = 0, body_[P::width];
  unsigned active_ = 0;
  T t0_, t1_, first_step_;
  Room<Together> room_;
  typename P::State x_, slope_;
  Number t_, h_, steps_;
};

}  // namespace oddity::lanes
