#include "solvers/ode/events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solvers/ode/all.hpp"

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

bool same_side(double f, double g) { return (f < 0 && g < 0) || (f > 0 && g > 0); }

/// The bracket of a root, narrowed by Brent's method (Algorithms for Minimization without Derivatives, 1973,
/// ch. 4): by a secant or an inverse parabola where these help, else by bisection. Takes the same steps as
/// solvers/roots.hpp, but without GSL, since the WebAssembly module searches for events too.
struct Bracket {
  double a, fa;  ///< previous point
  double b, fb;  ///< best point
  double c, fc;  ///< point on the other side of the root
  double step, step_before;

  Bracket(double low, double f_low, double high, double f_high)
      : a(low), fa(f_low), b(high), fb(f_high), c(high), fc(f_high), step(high - low), step_before(step) {}

  double other() const { return same_side(fb, fc) ? a : c; }

  /// Moves to the next estimate of the root; false if the bracket has converged.
  bool move() {
    bool secant = false;
    if (same_side(fb, fc)) {
      c = a, fc = fa, step = step_before = b - a;
      secant = true;
    }
    if (std::abs(fc) < std::abs(fb)) {
      a = b, b = c, c = a, fa = fb, fb = fc, fc = fa;
      secant = true;
    }
    const double little = 0.5 * std::numeric_limits<double>::epsilon() * std::abs(b), half = 0.5 * (c - b);
    if (fb == 0) c = b;
    if (fb == 0 || std::abs(half) <= little) return false;
    if (std::abs(step_before) < little || std::abs(fa) <= std::abs(fb) || !interpolate(half, little, secant))
      step = step_before = half;
    a = b, fa = fb;
    b += std::abs(step) > little ? step : half > 0 ? little : -little;
    return true;
  }

 private:
  /// Interpolates if this shortens the bracket by more than bisection would.
  bool interpolate(double half, double little, bool secant) {
    const double s = fb / fa, u = fa / fc, r = fb / fc;
    double p = secant ? 2 * half * s : s * (2 * half * u * (u - r) - (b - a) * (r - 1));
    double q = secant ? 1 - s : (u - 1) * (r - 1) * (s - 1);
    (p > 0 ? q : p) *= -1;
    if (!(2 * p < std::min(3 * half * q - std::abs(little * q), std::abs(step_before * q)))) return false;
    step_before = std::exchange(step, p / q);
    return true;
  }
};

/// A root of f between a and b, by the same method as `brent` of solvers/roots.hpp.
template <class F>
Solved<double> root_between(const F& f, double a, double b, double tolerance) {
  const double fa = f(a), fb = f(b), size_at_ends = std::max(std::abs(fa), std::abs(fb));
  Solved<double> root{b};
  const auto failed = [&](Ending ending, const char* why) {
    root.ending = ending;
    root.message = why;
    return root;
  };
  if (!std::isfinite(fa) || !std::isfinite(fb) || same_side(fa, fb))
    return failed(Ending::raised, "no bracket");
  Bracket bracket(a, fa, b, fb);
  for (int i = 0; i < 200; ++i) {
    if (bracket.move()) bracket.fb = f(bracket.b);
    root.value = bracket.b;
    if (!std::isfinite(bracket.fb)) return failed(Ending::raised, "the function is not finite");
    const auto [low, high] = std::minmax({bracket.b, bracket.other()});
    if (!(high - low <= tolerance) && std::nextafter(low, high) < high) continue;
    if (low == high || std::abs(f(bracket.b)) <= size_at_ends) return root;
    return failed(Ending::raised, "f changes its sign at a pole and not at a root");
  }
  return failed(Ending::stalled, "the bracket is still wider than the tolerance after 200 iterations");
}

}  // namespace

template <std::size_t n>
Solved<Event<std::array<double, n>>> find_event(
    const AnySystem<n>& moving, Keep<n>& keep, Integrate<n>& integrate, Step<n>& step,
    const std::array<double, n>& start, double t0, double t1, double setting,
    const std::function<double(const std::array<double, n>&, double)>& g) {
  using State = std::array<double, n>;
  constexpr int samples = 4;
  const auto with_series = keep(moving, setting);
  const AnySystem<n>& system = with_series ? *with_series : moving;
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

  double before = g(start, t0);  // the last value of g that was not zero
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
      const Solved<double> root = root_between(miss, a, b, 4e-16 * (1 + std::abs(t)));
      if (root.ending == Ending::raised) return false;
      event.value = event_after(root.value);
      event.ending = whole ? root.ending : Ending::stalled;
      event.message = whole ? root.message : "the algorithm did not reach a time inside a step";
      return true;
    };

    double left = 0;
    for (int k = 1; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples, s = part * h;
      double now = k == samples  ? g(x_next, t_next)
                   : with_series ? miss(s)
                                 : g(hermite(x, d0, x_next, d1, h, part), t + s);
      if ((before < 0 && now >= 0) || (before > 0 && now <= 0)) {
        found = refine(left, s) || (left != 0 && at_start != 0 && refine(0, s));
        if (found) return true;
        now = miss(s);  // the cubic crossed zero, but g does not
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

#define ODDITY_FIND_EVENT(n, name)                                                                          \
  template Solved<Event<std::array<double, n>>> name<n>(                                                    \
      const AnySystem<n>&, Keep<n>&, Integrate<n>&, Step<n>&, const std::array<double, n>&, double, double, \
      double, const std::function<double(const std::array<double, n>&, double)>&);
ODDITY_FOR_UNKNOWNS(ODDITY_FIND_EVENT, find_event)

}  // namespace oddity::ode::detail

namespace oddity::ode {

namespace {

/// The functions of an algorithm that the search for events uses.
template <std::size_t n>
struct Stepping {
  Integrate<n>* through = nullptr;
  detail::Step<n>* once = nullptr;
  detail::Keep<n>* keep = nullptr;
  bool has_tolerance = false, by_series = false;
};

template <std::size_t n>
Stepping<n> stepping(std::string_view algorithm) {
  Stepping<n> found{&precompiled<n>(algorithm)};
  for_each_algorithm([&]<class Algorithm>() {
    if (Algorithm::name != algorithm) return;
    found.once = step_precompiled<Algorithm, n>;
    found.has_tolerance = has_tolerance(Algorithm::kind);
    found.keep = with_series_precompiled<Algorithm, n>;
    found.by_series = info<Algorithm>().by_series;
  });
  return found;
}

/// The fraction of a step at which the cubic with these values and slopes (per step) at its ends is smallest.
/// The first slope must be falling and the second rising.
double least_at(double g0, double slope0, double g1, double slope1) {
  const double a = 3 * (slope0 + slope1 - 2 * (g1 - g0)), b = 6 * (g1 - g0) - 4 * slope0 - 2 * slope1;
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    ((a * middle + b) * middle + slope0 < 0 ? low : high) = middle;
  }
  return high;
}

/// Searches one step after another for events, from the start of a motion or from an event on.
template <std::size_t n>
class Lookout {
 public:
  using State = std::array<double, n>;
  enum class Seen { nothing, event, grazing, failure };

  Lookout(const AnySystem<n>& system, const Stepping<n>& algorithm, double setting, double time_rounding)
      : system_(system),
        algorithm_(algorithm),
        setting_(setting),
        time_rounding_(time_rounding),
        guards_(system.guard_count()),
        above_(guards_),
        on_(guards_) {}

  Seen seen = Seen::nothing;
  Happened<State> event;  ///< or the grazing point
  long evaluations = 0;   ///< evaluations inside steps

  void start(const State& x, double t) {
    const auto g = guards(x, t);
    for (std::size_t i = 0; i < guards_; ++i) {
      above_[i] = g[i] >= 0;
      on_[i] = g[i] == 0;
    }
  }

  /// Continues after `event`. Returns another guard that was above zero and no longer is: its event happens
  /// at once.
  std::optional<std::size_t> go_on(bool passed) {
    const auto before = guards(event.before, event.time), after = guards(event.after, event.time);
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < guards_; ++i) {
      if (i == event.guard) {
        above_[i] = on_[i] = !passed;
        continue;
      }
      on_[i] = on_[i] && !(before[i] > 0);
      above_[i] = above_[i] || before[i] > 0 || after[i] > 0;
      if (above_[i] && !on_[i] && after[i] < 0 && !next) next = i;
    }
    seen = Seen::nothing;
    return next;
  }

  /// Searches a step; true if it ends the piece: an event, a grazing guard or a failure.
  bool operator()(double t, const State& x, double t_next, const State& x_next) {
    step_ = {t, t_next - t, x, x_next};
    State d0{}, d1{};
    derivative(x, d0, t);
    derivative(x_next, d1, t_next);
    sample(d0, d1);
    double first = nowhere;
    for (std::size_t i = 0; i < guards_; ++i) {
      const std::optional<double> root = above_[i] ? fall(i, d0, d1) : climb_and_fall(i);
      if (seen == Seen::failure) event.time = t, event.before = x;
      if (seen != Seen::nothing) return true;
      if (!root || std::abs(*root) >= std::abs(first)) continue;
      first = *root;
      event.guard = i;
    }
    if (std::isinf(first)) {
      for (std::size_t i = 0; i < guards_; ++i) {
        above_[i] = samples_.back()[i] > 0;
        on_[i] = false;
      }
      return false;
    }
    event.time = first == step_.h ? t_next : t + first;
    event.before = state_after(first);
    if (seen == Seen::nothing) seen = Seen::event;
    return true;
  }

 private:
  static constexpr std::size_t pieces = 4;
  static constexpr double nowhere = std::numeric_limits<double>::infinity();

  std::vector<double> guards(const State& x, double t) const {
    std::vector<double> values(guards_);
    system_.guards(x, t, values.data());
    return values;
  }
  void derivative(const State& x, State& dxdt, double t) {
    ++evaluations;
    system_(x, dxdt, t);
  }
  /// The state after s, computed by the algorithm itself from the step's start.
  State state_after(double s) {
    if (s == step_.h) return step_.x_next;
    State x = step_.x;
    if (s != 0 && !algorithm_.once(system_, x, step_.t, s, setting_, evaluations)) seen = Seen::failure;
    return x;
  }
  double guard_after(std::size_t i, double s) {
    return guards(state_after(s), s == step_.h ? step_.t + step_.h : step_.t + s)[i];
  }
  double part(std::size_t k) const { return static_cast<double>(k) / pieces * step_.h; }

  void sample(const State& d0, const State& d1) {
    samples_.front() = guards(step_.x, step_.t);
    samples_.back() = guards(step_.x_next, step_.t + step_.h);
    for (std::size_t k = 1; k < pieces; ++k)
      samples_[k] = guards(algorithm_.by_series
                               ? state_after(part(k))
                               : detail::hermite(step_.x, d0, step_.x_next, d1, step_.h, part(k) / step_.h),
                           step_.t + part(k));
  }

  /// The time in the step at which guard i, above zero at its start, first falls through zero.
  std::optional<double> fall(std::size_t i, const State& d0, const State& d1) {
    const double low = !on_[i] ? least(i, d0, d1) : nowhere;
    if (seen != Seen::nothing) return {};
    for (std::size_t k = 1; k <= pieces; ++k) {
      if (std::abs(low) <= std::abs(part(k))) return locate(i, 0, low);
      if (!(samples_[k][i] <= 0)) continue;
      if (const auto root = locate(i, part(k - 1), part(k))) return root;
    }
    return {};
  }
  /// The time in the step at which guard i falls through zero after it has risen above it.
  std::optional<double> climb_and_fall(std::size_t i) {
    bool above = false;
    for (std::size_t k = 1; k <= pieces; ++k) {
      if (above && samples_[k][i] <= 0)
        if (const auto root = locate(i, part(k - 1), part(k))) return root;
      above = above || samples_[k][i] > 0;
    }
    return {};
  }

  /// The time in the step at which guard i has a minimum below zero. Ends the search if the sign of the
  /// minimum is within the error (grazing).
  double least(std::size_t i, const State& d0, const State& d1) {
    const double t = step_.t, h = step_.h, g0 = samples_.front()[i], g1 = samples_.back()[i];
    const double slope0 = slope(i, step_.x, d0, t), slope1 = slope(i, step_.x_next, d1, t + h);
    if (!(slope0 < 0 && slope1 > 0)) return nowhere;
    const double u = least_at(g0, slope0, g1, slope1), s = u * h;
    constexpr double near =
        0.125;  // fraction of the guard's fall: an error that large leaves no correct digit
    const double cubic = g0 * (1 + 2 * u) * (1 - u) * (1 - u) + slope0 * u * (1 - u) * (1 - u) +
                         g1 * u * u * (3 - 2 * u) - slope1 * u * u * (1 - u);
    if (cubic > near * std::max(g0, g1)) return nowhere;
    const double value = guard_after(i, s);
    if (std::abs(value) <= error_of(i, s)) {
      seen = Seen::grazing;
      event = {i, t + s, state_after(s), state_after(s)};
      return nowhere;
    }
    if (value > 0) return nowhere;
    return s;
  }
  /// The guard's change along the motion, per step.
  double slope(std::size_t i, const State& x, const State& dxdt, double t) const {
    const double little = 1e-6 * step_.h;
    State ahead = x, behind = x;
    for (std::size_t c = 0; c < n; ++c) {
      ahead[c] += little * dxdt[c];
      behind[c] -= little * dxdt[c];
    }
    return (guards(ahead, t + little)[i] - guards(behind, t - little)[i]) / 2e-6;
  }
  /// Error of guard i after s, from the step's error.
  double error_of(std::size_t i, double s) {
    State one = step_.x, two = step_.x;
    const double t = step_.t, h = step_.h;
    if (!algorithm_.has_tolerance) {
      algorithm_.once(system_, one, t, h, setting_, evaluations);
      algorithm_.once(system_, two, t, h / 2, setting_, evaluations);
      algorithm_.once(system_, two, t + h / 2, h / 2, setting_, evaluations);
    }
    const State x = state_after(s);
    const double g = guards(x, t + s)[i];
    constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();
    double error = 0;
    for (std::size_t c = 0; c < n; ++c) {
      State off = x;
      off[c] += roundings * std::abs(x[c]) +
                (algorithm_.has_tolerance ? setting_ * (1 + std::abs(x[c])) : std::abs(one[c] - two[c]));
      error += std::abs(guards(off, t + s)[i] - g);
    }
    return error;
  }

  /// The root of guard i between `left` and `right`, after which it is no longer above zero; none if only the
  /// cubic crosses zero. A motion that starts on the guard has to leave it first: 0 if it does not.
  std::optional<double> locate(std::size_t i, double left, double right) {
    const bool on_guard = on_[i];
    if (left != 0 || !on_guard) {
      if (const auto root = between(i, left, right, 4e-16 * (1 + std::abs(step_.t)))) return root;
      if (left == 0) return {};
      if (!on_guard) return between(i, 0, right, 4e-16 * (1 + std::abs(step_.t)));
    }
    if (!(guard_after(i, right) <= 0)) return {};
    for (double high = right; std::abs(high) > time_rounding_; high /= 2)
      if (guard_after(i, high / 2) > 0) return between(i, high / 2, high, 4e-16 * std::abs(high));
    return 0;
  }
  std::optional<double> between(std::size_t i, double left, double right, double tolerance) {
    const auto miss = [&](double s) { return guard_after(i, s); };
    const Solved<double> root = detail::root_between(miss, left, right, tolerance);
    if (root.ending == Ending::raised) return {};
    return root.value;
  }

  const AnySystem<n>& system_;
  Stepping<n> algorithm_;
  double setting_, time_rounding_;
  std::size_t guards_;
  std::vector<bool> above_;  ///< the guard can fall
  std::vector<bool> on_;     ///< the motion starts on the guard: its sign there is rounding
  struct {
    double t, h;
    State x, x_next;
  } step_{};
  std::array<std::vector<double>, pieces + 1> samples_;
};

/// Whether the last 16 events for each guard happened without the time moving.
template <class State>
bool accumulate(const std::vector<Happened<State>>& events, std::size_t guards, double time_rounding) {
  const std::size_t many = 16 * guards;
  constexpr double roundings = 64;
  return events.size() >= many &&
         std::abs(events.back().time - events[events.size() - many].time) <= roundings * time_rounding;
}

}  // namespace

template <std::size_t n>
MotionWithEvents<std::array<double, n>> integrate_with_events(
    std::string_view algorithm, const AnySystem<n>& moving, const std::array<double, n>& start,
    std::span<const double> times, double setting, const Watch<n>& watch, std::size_t most_events) {
  using State = std::array<double, n>;
  using Seen = typename Lookout<n>::Seen;
  using Next = typename AnySystem<n>::Next;
  if (moving.guard_count() == 0) return {precompiled<n>(algorithm)(moving, start, times, setting, watch), {}};

  const Stepping<n> by = stepping<n>(algorithm);
  const auto with_series = by.keep(moving, setting);
  const AnySystem<n>& system = with_series ? *with_series : moving;
  double latest = 0;
  for (double t : times) latest = std::max(latest, std::abs(t));
  const double time_rounding = std::numeric_limits<double>::epsilon() * latest;
  Lookout<n> lookout(system, by, setting, time_rounding);
  Happened<State>& event = lookout.event;
  bool stopped = false;  // by `watch`
  const auto on_step = [&](double t, const State& x, double t_next, const State& x_next) {
    const bool seen = lookout(t, x, t_next, x_next);
    stopped = seen ? watch(t, x, event.time, event.before) : watch(t, x, t_next, x_next);
    return seen || stopped;
  };

  MotionWithEvents<State> all;
  Trajectory<State>& whole = all.trajectory;
  const auto end = [&](Ending ending, const char* what) {
    detail::fail(whole, ending, what, event.time);
    whole.value.push_back(ending == Ending::chattering ? event.after : event.before);
    return all;
  };
  State x = start;
  std::vector<double> left(times.begin(), times.end());  // the current time, and the times to come
  if (!left.empty()) lookout.start(x, left[0]);
  for (;;) {
    const auto piece = by.through(system, x, left, setting, Watch<n>(on_step));
    whole.evaluations += piece.evaluations + std::exchange(lookout.evaluations, 0);
    const auto known =
        piece.value.end() - (lookout.seen == Seen::nothing ? 0 : 1);  // without the event's step
    const auto first = piece.value.begin() + (whole.value.empty() ? 0 : 1);
    if (first < known) whole.value.insert(whole.value.end(), first, known);
    if (lookout.seen == Seen::nothing) {
      whole.ending = piece.ending;
      whole.message = piece.message;
      return all;
    }
    if (lookout.seen == Seen::failure)
      return end(Ending::stalled, "the algorithm did not reach a time inside a step");
    if (lookout.seen == Seen::grazing) return end(Ending::grazing, "a guard touches zero");
    if (whole.evaluations > most_evaluations)
      return end(Ending::stalled, "the budget of evaluations is spent");
    left.erase(left.begin(), left.begin() + (known - piece.value.begin() - 1));
    left[0] = event.time;

    for (std::optional<std::size_t> guard = event.guard; guard;) {
      if (*guard != event.guard) event.before = event.after;
      event.guard = *guard;
      event.after = event.before;
      const auto next = system.happen(*guard, event.after, event.time);
      all.events.push_back(event);
      if (stopped || all.events.size() == most_events) return all;
      if (next == Next::end) {
        whole.value.insert(whole.value.end(), left.size() - 1, event.after);
        return all;
      }
      if (accumulate(all.events, system.guard_count(), time_rounding))
        return end(Ending::chattering, "events without end while the time does not move");
      guard = lookout.go_on(next == Next::pass);
    }
    x = event.after;
  }
}

#define ODDITY_WITH_EVENTS(n, name)                                                                         \
  template MotionWithEvents<std::array<double, n>> name<n>(                                                 \
      std::string_view, const AnySystem<n>&, const std::array<double, n>&, std::span<const double>, double, \
      const Watch<n>&, std::size_t);
ODDITY_FOR_UNKNOWNS(ODDITY_WITH_EVENTS, integrate_with_events)

}  // namespace oddity::ode
