#pragma once

// How far ahead the triple pendulum of exercise 3.25 can be predicted: in which precision, and how fast
// neighbours part.

#include <limits>

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/stops.hpp"
#include "solvers/counted_calls.hpp"

namespace oddity::chain {

// ---- in other precisions ----------------------------------------------------------------------------------

/// Gragg's modified midpoint rule with 2, 4, ..., 20 substeps, extrapolated: order 20 in the number type T,
/// and 120 evaluations per step. What is left of the error is rounding.
template <class T, std::size_t N, class Rhs>
void extrapolated_step(const Rhs& system, std::array<T, N>& x, T step, long& evaluations) {
  const auto rhs = counted_calls(system, evaluations);
  constexpr int columns = 10;
  std::array<std::array<T, N>, columns> table;
  for (int k = 1; k <= columns; ++k) {
    const T h = step / static_cast<T>(2 * k);
    std::array<T, N> before = x, now = x, slope{};
    rhs(x, slope, 0);
    for (std::size_t i = 0; i < N; ++i) now[i] += h * slope[i];
    for (int j = 1; j <= 2 * k; ++j) {
      rhs(now, slope, 0);
      for (std::size_t i = 0; i < N; ++i) {
        const T next = before[i] + (j < 2 * k ? 2 * h : h) * slope[i];
        before[i] = now[i];
        now[i] = next;
      }
    }
    auto& row = table[static_cast<std::size_t>(k - 1)];
    for (std::size_t i = 0; i < N; ++i) row[i] = (now[i] + before[i]) / 2;
    for (int j = k - 1; j > 0; --j) {
      const T ratio = static_cast<T>(k) / static_cast<T>(j), less = 1 / (ratio * ratio - 1);
      const auto c = static_cast<std::size_t>(j - 1);
      for (std::size_t i = 0; i < N; ++i)
        table[c][i] = table[c + 1][i] + (table[c + 1][i] - table[c][i]) * less;
    }
  }
  x = table[0];
}

/// Positions at the horizon's times, the state carried in T.
template <class T>
Answer in_precision(const Triple& c, const Horizon& horizon, double step) {
  const Angles<Equations::tensions> model{c};
  std::array<T, 6> x;
  for (std::size_t i = 0; i < 6; ++i) x[i] = static_cast<T>(model.start()[i]);
  Answer answer;
  std::vector<double> seen;
  const auto go_on = [&](double from, double to) {
    const int steps = static_cast<int>(count_of_steps(to - from, step));
    for (int i = 0; i < steps; ++i)
      extrapolated_step(model, x, static_cast<T>(to - from) / static_cast<T>(steps), answer.evaluations);
    return true;
  };
  through_times(horizon, go_on, [&](double) {
    for (const T& y : positions(c, x)) seen.push_back(static_cast<double>(y));
  });
  answer.value = Value(std::move(seen));
  return answer;
}

/// The time at which the positions in T, at whole seconds, have come to be `close` off the true ones: the
/// error's logarithm is taken as linear from one second to the next.
template <class T>
double predicted_until(const Triple& c, const Horizon& seconds, const Value& truth, double close, double step,
                       long& evaluations) {
  const Answer answer = in_precision<T>(c, seconds, step);
  evaluations += answer.evaluations;
  const auto times = seconds.times();
  double before = std::numeric_limits<T>::epsilon();
  for (std::size_t i = 1; i < times.size(); ++i) {
    double error = 0;
    for (std::size_t k = 6 * (i - 1); k < 6 * i; ++k)
      error = std::max(error, std::abs(answer.value[k] - truth[k]));
    if (error > close)
      return times[i - 1] + (times[i] - times[i - 1]) * std::log(close / before) / std::log(error / before);
    before = std::max(error, before);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Seconds that each decimal digit adds to the prediction, from the precision A to B.
template <class A, class B>
Answer seconds_per_digit(const Triple& c, const Horizon& seconds, const Value& truth, double close,
                         double step) {
  Answer answer;
  const double less = predicted_until<A>(c, seconds, truth, close, step, answer.evaluations);
  const double more = predicted_until<B>(c, seconds, truth, close, step, answer.evaluations);
  answer.value = (more - less) / std::log10(static_cast<double>(std::numeric_limits<A>::epsilon()) /
                                            static_cast<double>(std::numeric_limits<B>::epsilon()));
  return answer;
}

// ---- how fast neighbours part -----------------------------------------------------------------------------

/// The state and its derivative by theta1(0), carried along by dual numbers.
struct Variational : Angles<Equations::tensions> {
  using State = std::array<double, 12>;
  void operator()(const State& x, State& dxdt, double t) const {
    std::array<Dual<double>, 6> y, slope;
    for (std::size_t i = 0; i < 6; ++i) y[i] = {x[i], x[i + 6]};
    Angles::operator()(y, slope, t);
    for (std::size_t i = 0; i < 6; ++i) {
      dxdt[i] = slope[i].value;
      dxdt[i + 6] = slope[i].slope;
    }
  }
};

inline double rate_of(const Value& change, double t) { return std::log(size_of(change)) / t; }

inline Answer growth_by_variation(const Triple& c, double t, double tolerance) {
  const Variational model{{c}};
  Variational::State x{};
  for (std::size_t i = 0; i < 6; ++i) x[i] = model.start()[i];
  x[6] = 1;
  const auto end = ode::integrate<ode::Fehlberg78>(model, x, 0, t, tolerance);
  return answer(end, [&](const Variational::State& y) {
    std::array<Dual<double>, 3> q;
    for (std::size_t i = 0; i < 3; ++i) q[i] = {y[i], y[i + 6]};
    std::vector<double> change;
    for (const auto& p : positions(c, q)) change.push_back(p.slope);
    return rate_of(change, t);
  });
}

inline Answer growth_by_neighbours(const Triple& c, double t, double apart) {
  const auto end = [&](double by) {
    Angles<Equations::tensions> model{c};
    model.theta[0] += by;
    return ode::integrate<ode::Fehlberg78>(model, model.start(), 0, t, 1e-14);
  };
  const auto above = end(apart / 2), below = end(-apart / 2);
  const auto p = positions(c, above.value), q = positions(c, below.value);
  std::vector<double> change;
  for (std::size_t i = 0; i < 6; ++i) change.push_back((p[i] - q[i]) / apart);
  return {rate_of(change, t), above.evaluations + below.evaluations};
}

}  // namespace oddity::chain
