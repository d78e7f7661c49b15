#include "solvers/ode/disturbed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/ode/step_lengths.hpp"
#include "solvers/ode/steps_in.hpp"

namespace oddity::ode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::string_view judge = "Dormand-Prince 5(4)";
constexpr double first_distance = 1e-6;  ///< initial distance of the two motions, in units of their size

template <std::size_t n>
double distance(const std::array<double, n>& a, const std::array<double, n>& b,
                const std::array<double, n>& unit) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (a[i] - b[i]) / unit[i] * ((a[i] - b[i]) / unit[i]);
  return std::sqrt(sum);
}

/// The step nearest to this one that divides the span.
double dividing(double span, double step) { return span / steps_in(0, span, step); }

/// Integrates in steps of h, which must divide the span, and calls `watch` after each. Events do not shift
/// the ends of steps, so that two motions with different events can be compared.
template <std::size_t n>
Trajectory<std::array<double, n>> in_steps(std::string_view algorithm, const AnySystem<n>& system,
                                           const std::array<double, n>& start, double t0, double t1, double h,
                                           const Watch<n>& watch) {
  if (system.guard_count() == 0)
    return precompiled<n>(algorithm)(system, start, std::array{t0, t1}, h, watch);
  const long count = std::lround((t1 - t0) / h);
  std::vector<double> times;
  for (long i = 0; i < count; ++i) times.push_back(t0 + static_cast<double>(i) * h);
  times.push_back(t1);
  auto motion = integrate_with_events<n>(algorithm, system, start, times, h).trajectory;
  for (std::size_t i = 1; i < motion.value.size(); ++i)
    if (watch(times[i - 1], motion.value[i - 1], times[i], motion.value[i])) break;
  return motion;
}

/// In steps of these lengths, again and again, in units of h, watched at each. The last step ends at the end.
template <std::size_t n>
Trajectory<std::array<double, n>> in_steps_of(std::span<const double> lengths, std::string_view algorithm,
                                              const AnySystem<n>& system, const std::array<double, n>& start,
                                              double end, double h, const Watch<n>& watch) {
  std::vector<double> times{0};
  for (std::size_t i = 0; times.back() < end; ++i)
    times.push_back(std::min(times.back() + h * lengths[i % lengths.size()], end));
  const double longest = h * std::ranges::max(lengths);
  if (system.guard_count() == 0) return precompiled<n>(algorithm)(system, start, times, longest, watch);
  auto motion = integrate_with_events<n>(algorithm, system, start, times, longest).trajectory;
  for (std::size_t i = 1; i < motion.value.size(); ++i)
    if (watch(times[i - 1], motion.value[i - 1], times[i], motion.value[i])) break;
  return motion;
}

/// Disturbs every component.
template <std::size_t n>
std::array<double, n> disturbed(std::array<double, n> x, const std::array<double, n>& unit) {
  std::array<double, n> d{};
  for (std::size_t i = 0; i < n; ++i) d[i] = unit[i] * std::cos(static_cast<double>(i * i + 1));
  const double part = first_distance / distance(d, {}, unit);
  for (std::size_t i = 0; i < n; ++i) x[i] += part * d[i];
  return x;
}

}  // namespace

template <std::size_t n>
Disturbed<n>::Disturbed(const AnySystem<n>& system, const State& start, double span, const Criteria& criteria)
    : system_(system), criteria_(criteria), start_(start) {
  constexpr std::size_t pieces = 1000;
  constexpr double tolerance = 1e-10;
  for (std::size_t i = 0; i < pieces; ++i) times_.push_back(span * static_cast<double>(i) / pieces);
  times_.push_back(span);
  long steps = 0;  // a model that chatters near rest would take millions
  const auto enough = [&](double, const State&, double, const State& x) {
    for (std::size_t k = 0; k < n; ++k) sizes_[k] = std::max(sizes_[k], std::abs(x[k]));
    return ++steps > 100'000;
  };
  const auto truth =
      integrate_with_events<n>(judge, system, start, times_, tolerance, Watch<n>(enough)).trajectory;
  const double least = std::ranges::max(sizes_) / 100;
  for (double& size : sizes_) size = std::max(size, least);
  times_.resize(
      std::min(times_.size(), truth.reached() && steps <= 100'000 ? times_.size() : truth.value.size() - 1));
  beside_ = disturbed(start, sizes_);
  const auto next = integrate_with_events<n>(judge, system, beside_, times_, tolerance).trajectory;
  double most = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (i < next.value.size())
      most = std::max(most, std::log(distance(truth.value[i], next.value[i], sizes_) / first_distance));
    parted_.push_back(most);
  }
}

template <std::size_t n>
Loss Disturbed<n>::lost(std::string_view algorithm, double step) const {
  const double h = dividing(span(), step);
  std::vector<State> motion;
  Loss loss{infinity, {}};
  loss.outgrown.fill(infinity);
  const auto keep = [&](double, const State&, double t, const State& x) {
    motion.push_back(x);
    double size = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double part = std::abs(x[k]) / sizes_[k];
      if (!(part <= size)) size = part;
    }
    for (std::size_t i = 0; i < Loss::sizes.size(); ++i)
      if (std::isinf(loss.outgrown[i]) && !(size <= Loss::sizes[i] * criteria_.largest_size))
        loss.outgrown[i] = t;
    return std::isfinite(loss.outgrown.back());
  };
  const auto follow = [&](const State& from, const Watch<n>& watch) {
    if (const auto* lengths = StepLengths::here())
      in_steps_of<n>(*lengths, algorithm, system_, from, span(), step, watch);
    else
      in_steps<n>(algorithm, system_, from, 0, span(), h, watch);
  };
  follow(start_, Watch<n>(keep));
  std::size_t i = 0;
  const auto compare = [&](double, const State&, double t, const State& x) {
    if (i == motion.size()) return true;
    if (!(std::log(distance(x, motion[i++], sizes_) / first_distance) <= allowed(t))) loss.parted = t;
    return std::isfinite(loss.parted);
  };
  follow(beside_, Watch<n>(compare));
  return loss;
}

template <std::size_t n>
double Disturbed<n>::allowed(double t) const {
  const auto piece = static_cast<std::size_t>(t / span() * static_cast<double>(parted_.size() - 1));
  return criteria_.as_fast * parted_[std::min(piece + 1, parted_.size() - 1)] + std::log(criteria_.granted);
}

namespace {

template <std::size_t n>
using StateOf = std::array<double, n>;

template <std::size_t n>
StateOf<n> added(StateOf<n> x, double part, const StateOf<n>& d) {
  for (std::size_t i = 0; i < n; ++i) x[i] += part * d[i];
  return x;
}

/// The disturbance of a motion known at equally spaced times, as a system: d' = J(x(t)) d.
template <std::size_t n>
class Disturbance final : public AnySystem<n> {
 public:
  using typename AnySystem<n>::State, typename AnySystem<n>::Half;

  Disturbance(const AnySystem<n>& system, std::vector<State> motion, double apart, const State& unit)
      : system_(system), motion_(std::move(motion)), apart_(apart), unit_(unit) {
    for (std::size_t i = 0; i < motion_.size(); ++i) {
      slopes_.emplace_back();
      system_(motion_[i], slopes_.back(), static_cast<double>(i) * apart_);
    }
  }

  void operator()(const State& d, State& dddt, double t) const override {
    const double size = distance(d, {}, unit_);
    if (size == 0) return void(dddt = {});
    const State x = at(t);
    const double part = first_distance / size;
    State up, down;
    system_(added(x, part, d), up, t);
    system_(added(x, -part, d), down, t);
    for (std::size_t i = 0; i < n; ++i) dddt[i] = (up[i] - down[i]) / (2 * part);
  }
  void acceleration(const Half&, Half&) const override {
    throw std::logic_error("a disturbance has no parts");
  }
  Velocities<n> velocities() const override {
    Velocities<n> same = system_.velocities();
    same.of.fill(n);  // by differences, no rate equals a velocity exactly
    return same;
  }
  bool differentiable() const override { return false; }
  long jacobian(const State&, double*, double*, double) const override {
    throw std::logic_error("a disturbance is not asked for its Jacobian");
  }

 private:
  /// The motion at t, by Hermite's cubic.
  State at(double t) const {
    const auto i =
        static_cast<std::size_t>(std::clamp(t / apart_, 0.0, static_cast<double>(motion_.size()) - 1.5));
    const double u = t / apart_ - static_cast<double>(i), v = 1 - u;
    State x;
    for (std::size_t k = 0; k < n; ++k)
      x[k] = (1 + 2 * u) * v * v * motion_[i][k] + u * v * v * apart_ * slopes_[i][k] +
             (1 + 2 * v) * u * u * motion_[i + 1][k] - v * u * u * apart_ * slopes_[i + 1][k];
    return x;
  }

  const AnySystem<n>& system_;
  std::vector<State> motion_, slopes_;
  double apart_;
  State unit_;
};

}  // namespace

template <std::size_t n>
auto Disturbed<n>::truth(double apart) const -> std::vector<State> {
  std::vector<double> times;
  for (double i = 0; i * apart <= span() * (1 + 1e-12); ++i) times.push_back(i * apart);
  return integrate_with_events<n>(judge, system_, start_, times, 1e-10).trajectory.value;
}

template <std::size_t n>
double Disturbed<n>::lost_along_truth(std::string_view algorithm, double step) const {
  const double h = dividing(span(), step);
  State d = added(beside_, -1, start_);
  double lost = infinity;
  if (is_multistep(algorithm)) {
    constexpr int pieces = 8;
    const Disturbance<n> disturbance(system_, truth(h / pieces), h / pieces, sizes_);
    const auto watch = [&](double, const State&, double t, const State& x) {
      if (!(std::log(distance(x, {}, sizes_) / first_distance) <= allowed(t))) lost = t;
      return std::isfinite(lost);
    };
    precompiled<n>(algorithm)(disturbance, d, std::array{0.0, span()}, h, Watch<n>(watch));
    return lost;
  }
  const std::vector<State> motion = truth(h);
  double grown = 0;
  for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
    const double t = static_cast<double>(i) * h;
    const auto stepped = [&](double part) {
      return in_steps<n>(algorithm, system_, added(motion[i], part, d), t, t + h, h, {}).value.back();
    };
    const State up = stepped(0.5), down = stepped(-0.5);
    d = added(up, -1, down);
    const double size = distance(d, {}, sizes_) / first_distance;
    grown += std::log(size);
    if (!(grown <= allowed(t + h))) return t + h;
    for (double& component : d) component /= size;
  }
  return lost;
}

template <std::size_t n>
double Disturbed<n>::turns_in_a_step(std::string_view algorithm, double step) const {
  const std::vector<State> states = motion(algorithm, step, span());
  double most = 0, turns = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double mean = 0, square = 0, upward = 0;
    for (const State& x : states) mean += x[k] / static_cast<double>(states.size());
    for (const State& x : states) square += (x[k] - mean) / sizes_[k] * ((x[k] - mean) / sizes_[k]);
    for (std::size_t i = 1; i < states.size(); ++i) upward += states[i - 1][k] < mean && states[i][k] >= mean;
    if (square > most) most = square, turns = upward;
  }
  return turns / static_cast<double>(states.size() - 1);
}

template <std::size_t n>
auto Disturbed<n>::motion(std::string_view algorithm, double step, double until) const -> std::vector<State> {
  std::vector<State> motion{start_};
  const auto keep = [&](double, const State&, double t, const State& x) {
    if (t <= until) motion.push_back(x);
    return t >= until;
  };
  in_steps<n>(algorithm, system_, start_, 0, span(), dividing(span(), step), Watch<n>(keep));
  return motion;
}

#define ODDITY_DISTURBED(n, type) template class type<n>;
ODDITY_FOR_UNKNOWNS(ODDITY_DISTURBED, Disturbed)

}  // namespace oddity::ode
