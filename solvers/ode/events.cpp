#include "solvers/ode/events.hpp"

#include <cmath>

#include "solvers/roots.hpp"

namespace oddity::ode::detail {

namespace {

/// The cubic through two states with their derivatives, at the fraction s of the step h between them.
template <class State>
State hermite(const State& x0, const State& d0, const State& x1, const State& d1, double h, double s) {
  const double a = (1 + 2 * s) * (1 - s) * (1 - s), b = s * (1 - s) * (1 - s) * h;
  const double c = s * s * (3 - 2 * s), d = -s * s * (1 - s) * h;
  State x{};
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = a * x0[i] + b * d0[i] + c * x1[i] + d * d1[i];
  return x;
}

}  // namespace

template <std::size_t n>
Solved<Event<std::array<double, n>>> find_event(
    const AnySystem<n>& system, Integrate<n>& integrate, Step<n>& step, const std::array<double, n>& start,
    double t0, double t1, double setting,
    const std::function<double(const std::array<double, n>&, double)>& g) {
  using State = std::array<double, n>;
  constexpr int samples = 4;
  Solved<Event<State>> event;
  long inside = 0;
  bool found = false, whole = true;

  const auto counted = [&](const State& x, State& dxdt, double t) {
    ++inside;
    system(x, dxdt, t);
  };
  const auto state_after = [&](State x, double t, double s) {
    whole = step(system, x, t, s, setting, inside) && whole;
    return x;
  };

  double before = g(start, t0);  // g where it last was not zero
  double at_start = before;      // g at the start of the step

  const auto watch = [&](double t, const State& x, double t_next, const State& x_next) {
    const double h = t_next - t;
    State d0{}, d1{};
    counted(x, d0, t);
    counted(x_next, d1, t_next);
    const auto event_after = [&](double s) -> Event<State> {
      if (s == h) return {t_next, x_next};
      if (s == 0) return {t, x};
      return {t + s, state_after(x, t, s)};
    };
    const auto miss = [&](double s) {
      const auto candidate = event_after(s);
      return g(candidate.state, candidate.time);
    };
    const auto refine = [&](double a, double b) {
      const Solved<double> root = brent(miss, a, b, 4e-16 * (1 + std::abs(t)));
      if (root.ending == Ending::raised) return false;
      event.value = event_after(root.value);
      event.ending = whole ? root.ending : Ending::stalled;
      event.message = whole ? root.message : "the algorithm did not reach a time inside a step";
      return true;
    };

    double left = 0;
    for (int k = 1; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples, s = part * h;
      double now = k == samples ? g(x_next, t_next) : g(hermite(x, d0, x_next, d1, h, part), t + s);
      if (before * now < 0 || (now == 0 && before != 0)) {
        found = refine(left, s) || (left != 0 && at_start != 0 && refine(0, s));
        if (found) return true;
        now = miss(s);  // what the cubic saw is not there
      }
      if (now != 0) before = now;
      left = s;
    }
    at_start = g(x_next, t_next);
    return false;
  };

  const std::array times{t0, t1};
  const auto trajectory = integrate(system, start, times, setting, Watch<n>(watch));
  event.evaluations = trajectory.evaluations + inside;
  if (found) return event;
  if (trajectory.reached()) event.value = {t1, trajectory.value.back()};
  event.ending = trajectory.reached() ? Ending::raised : trajectory.ending;
  event.message = trajectory.reached() ? "the event does not happen in the time given" : trajectory.message;
  return event;
}

#define ODDITY_FIND_EVENT(n, name)                                                                        \
  template Solved<Event<std::array<double, n>>> name<n>(                                                  \
      const AnySystem<n>&, Integrate<n>&, Step<n>&, const std::array<double, n>&, double, double, double, \
      const std::function<double(const std::array<double, n>&, double)>&);
ODDITY_FOR_UNKNOWNS(ODDITY_FIND_EVENT, find_event)

}  // namespace oddity::ode::detail
