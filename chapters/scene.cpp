#include "chapters/scene.hpp"

#include <numeric>
#include <utility>

#include "chapters/drift.hpp"
#include "chapters/kicked_state.hpp"
#include "chapters/kicks.hpp"
#include "chapters/no_event.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/disturbed.hpp"
#include "solvers/ode/events.hpp"

namespace oddity {

namespace {

/// Relative to a time: a step that ends this little after a frame counts as ending with it.
constexpr double step_rounding = 1e-12;

/// The two last ends of steps of one length, counted from the first of the times, before each of the others.
std::vector<double> ends_of_steps(std::span<const double> times, double step) {
  const double begin = times.front();
  std::vector<double> stops{begin};
  double last = 0;
  for (const double t : times.subspan(1)) {
    const double steps = std::floor((t - begin) / step * (1 + step_rounding));
    for (const double i : {steps - 1, steps})
      if (i > last) stops.push_back(begin + (last = i) * step);
  }
  return stops;
}

/// `begin`, and those of the later times that come up to `end`.
std::vector<double> from_until(std::span<const double> later, double begin, double end) {
  std::vector<double> times{begin};
  times.insert(times.end(), later.begin(), std::ranges::upper_bound(later, end));
  return times;
}

}  // namespace

template <std::size_t n>
Answer ModelInterfaceOf<n>::run(std::string_view algorithm, const Horizon& horizon, double setting) const {
  const auto times = horizon.times();
  Answer answer = observed(times, moved(algorithm, times, horizon.stepping, setting));
  if (KicksHere::take()) answer.drift = 0;  // a kick changes the conserved quantities
  if (answer.reached() && answer.drift > another_motion)
    answer.comes_back = horizon.stepping == Stepping::divided
                            ? comes_back(algorithm, times, setting)
                            : comes_back(algorithm, ends_of_steps(times, setting), setting);
  return answer;
}

template <std::size_t n>
bool ModelInterfaceOf<n>::comes_back(std::string_view algorithm, std::span<const double> times,
                                     double setting) const {
  const std::vector<Conserved<double>> at_start = conserved(start(), times.front());
  const std::vector<double> scale = moving(times.back());
  const double half = std::midpoint(times.front(), times.back());
  double most_before = 0, most_after = 0, least_after = std::numeric_limits<double>::infinity();
  const auto stays = [&] { return most_after <= 1.25 * most_before; };
  const auto watch = [&](double, const State&, double t, const State& x) {
    const double change = oddity::drift(at_start, conserved(x, t), scale);
    double& most = t < half ? most_before : most_after;
    if (!(change <= most)) most = change;
    if (t >= half) least_after = std::min(least_after, change);
    return !stays();
  };
  ode::integrate_with_events<n>(algorithm, *this, start(), times, setting, ode::Watch<n>(watch));
  return stays() && least_after <= most_after / 2;
}

namespace {

/// The model's motion from a state at the first of the times; its events are counted.
template <std::size_t n>
ode::Trajectory<std::array<double, n>> moved_from(const ModelInterfaceOf<n>& model,
                                                  const std::array<double, n>& from,
                                                  std::string_view algorithm, std::span<const double> times,
                                                  double setting, long& events) {
  auto motion = ode::integrate_with_events<n>(algorithm, model, from, times, setting);
  events += static_cast<long>(motion.events.size());
  return std::move(motion.trajectory);
}

/// A motion as it is drawn at times, and its state at the end.
template <class State>
struct Part {
  ode::Trajectory<State> motion;
  State at_end;
};

/// A motion through the times, restarted after each of the kicks by draw(from, times, end). A frame at a kick
/// shows the state before it.
template <std::size_t n, class Draw>
ode::Trajectory<std::array<double, n>> with_kicks(const ModelInterfaceOf<n>& model,
                                                  std::span<const double> times, const Kicks& kicks,
                                                  const Draw& draw) {
  ode::Trajectory<std::array<double, n>> whole{{model.start()}};
  std::array<double, n> from = model.start();
  double begin = times.front();
  for (auto kick = kicks.begin();;) {
    const bool is_last = kick == kicks.end() || kick->time >= times.back();
    const double end = is_last ? times.back() : kick->time;
    const auto part = draw(from, from_until(times.subspan(whole.value.size()), begin, end), end);
    const auto& motion = part.motion;
    if (!motion.value.empty())
      whole.value.insert(whole.value.end(), motion.value.begin() + 1, motion.value.end());
    whole.evaluations += motion.evaluations;
    whole.ending = motion.ending;
    whole.message = motion.message;
    if (is_last || !whole.reached()) return whole;
    const auto next = std::find_if(kick, kicks.end(), [&](const Kick& k) { return k.time > kick->time; });
    const KickedState<n> after = kicked(model, part.at_end, kick->time, std::span(kick, next));
    if (!after.why_none.empty()) {
      whole.ending = Ending::raised;
      whole.message = after.why_none;
      return whole;
    }
    from = after.state;
    begin = std::exchange(kick, next)->time;
  }
}

}  // namespace

template <std::size_t n>
auto ModelInterfaceOf<n>::moved(std::string_view algorithm, std::span<const double> times,
                                double setting) const -> ode::Trajectory<State> {
  return moved(algorithm, times, Stepping::divided, setting);
}

template <std::size_t n>
auto ModelInterfaceOf<n>::moved(std::string_view algorithm, std::span<const double> times, Stepping stepping,
                                double setting) const -> ode::Trajectory<State> {
  long events = 0;
  const auto draw = [&](const State& from, std::span<const double> through, double end) {
    std::vector<double> stops(through.begin(), through.end());
    if (stops.back() < end) stops.push_back(end);
    if (stepping != Stepping::divided) stops = ends_of_steps(stops, setting);
    const bool is_kicked_there = end < times.back();
    if (is_kicked_there && stops.back() < end * (1 - step_rounding)) stops.push_back(end);  // a shorter step
    Part<State> part{moved_from(*this, from, algorithm, stops, setting, events), from};
    auto& motion = part.motion;
    if (!motion.value.empty()) part.at_end = motion.value.back();
    if (stepping == Stepping::divided) {
      motion.value.resize(std::min(motion.value.size(), through.size()));
      return part;
    }
    const std::vector<State> steps = std::exchange(motion.value, {});
    for (std::size_t i = 0, last = 1; i < through.size(); ++i) {
      while (last < stops.size() && stops[last] <= through[i] * (1 + step_rounding)) ++last;
      if (last > steps.size()) break;  // the motion ended earlier
      if (i > 0 && stepping == Stepping::extrapolated) ++motion.evaluations;
      motion.value.push_back(
          drawn(through[i], std::span(stops).first(last), std::span(steps).first(last), stepping));
    }
    return part;
  };
  const Kicks* kicks = KicksHere::take();
  auto motion = kicks ? with_kicks<n>(*this, times, *kicks, draw) : draw(start(), times, times.back()).motion;
  if (this->guard_count() > 0 && events == 0 && motion.reached()) motion.message = no_event;
  return motion;
}

template <std::size_t n>
auto ModelInterfaceOf<n>::drawn(double time, std::span<const double> ends, std::span<const State> motion,
                                Stepping stepping) const -> State {
  State x = motion.back();
  const double late = time - ends.back();
  if (stepping == Stepping::extrapolated) {
    State rate{};
    (*this)(x, rate, ends.back());
    for (std::size_t i = 0; i < n; ++i) x[i] += late * rate[i];
  } else if (stepping == Stepping::interpolated && motion.size() > 1) {
    const State& before = motion[motion.size() - 2];
    const double part = late / (ends.back() - ends[ends.size() - 2]);
    for (std::size_t i = 0; i < n; ++i) x[i] = before[i] + part * (x[i] - before[i]);
  }
  return x;
}

template <std::size_t n>
double ModelInterfaceOf<n>::off_constraint(std::string_view algorithm, const Horizon& horizon,
                                           double setting) const {
  const auto times = horizon.times();
  return off_constraint(times, moved(algorithm, times, horizon.stepping, setting).value);
}

template <std::size_t n>
double ModelInterfaceOf<n>::off_constraint(std::span<const double> times,
                                           std::span<const State> motion) const {
  double most = motion.empty() ? std::numeric_limits<double>::quiet_NaN() : 0;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const double off = off_constraint_at(motion[i], times[i]);
    if (!(off <= most)) most = off;  // NaN stays
    if (std::isnan(most)) break;
  }
  return most;
}

template <std::size_t n>
Value ModelInterfaceOf<n>::places_and_rates(std::string_view algorithm, const Horizon& horizon,
                                            double setting) const {
  const auto times = horizon.times();
  return places_and_rates(times, moved(algorithm, times, horizon.stepping, setting).value);
}

template <std::size_t n>
Value ModelInterfaceOf<n>::places_and_rates(std::span<const double> times,
                                            std::span<const State> motion) const {
  std::vector<double> seen;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    State rate{};
    (*this)(motion[i], rate, times[i]);
    const auto at = [&](double h) {
      State moved = motion[i];
      for (std::size_t j = 0; j < n; ++j) moved[j] += h * rate[j];
      return place(moved, times[i] + h);
    };
    add_placed(at(0), rates(at, step_of_rates), seen);
  }
  return Value(std::move(seen));
}

template <std::size_t n>
Answer ModelInterfaceOf<n>::observed(std::span<const double> times,
                                     const ode::Trajectory<State>& trajectory) const {
  Answer answer{{}, trajectory.evaluations, trajectory.error_estimate,
                0,  trajectory.ending,      trajectory.message};
  std::vector<double> seen;
  for (std::size_t i = 1; i < trajectory.value.size(); ++i) observe(trajectory.value[i], times[i], seen);
  answer.value = Value(std::move(seen));
  answer.drift = drift(times, trajectory.value);
  return answer;
}

template <std::size_t n>
double ModelInterfaceOf<n>::drift(std::span<const double> times, std::span<const State> motion) const {
  if (motion.empty()) return 0;
  const std::vector<Conserved<double>> at_start = conserved(motion[0], times[0]);
  if (at_start.empty()) return 0;
  const std::vector<double> scale = moving(times.back());
  double most = 0;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    const double drift = oddity::drift(at_start, conserved(motion[i], times[i]), scale);
    if (std::isnan(drift)) return drift;
    most = std::max(most, drift);
  }
  return most;
}

template <std::size_t n>
auto ModelInterfaceOf<n>::accurate_motion(std::span<const double> times) const -> ode::Trajectory<State> {
  long steps = 0;  // a model that chatters around rest would take millions
  const auto enough = [&](double, const State&, double, const State&) { return ++steps > 100'000; };
  constexpr std::string_view algorithm = "Dormand-Prince 5(4)";
  return ode::integrate_with_events<n>(algorithm, *this, start(), times, 1e-8, ode::Watch<n>(enough))
      .trajectory;
}

template <std::size_t n>
std::vector<double> ModelInterfaceOf<n>::moving(double end) const {
  const std::lock_guard lock(moving_.mutex);
  auto& most = moving_.all[end];
  if (!most.empty()) return most;
  const auto times = Horizon{end, 128}.times();
  const auto motion = accurate_motion(times);
  most.resize(conserved(start(), 0).size());
  for (std::size_t i = 0; i < motion.value.size(); ++i) {
    const std::vector<Conserved<double>> now = conserved(motion.value[i], times[i]);
    for (std::size_t k = 0; k < most.size(); ++k)
      if (now[k].moving > most[k]) most[k] = now[k].moving;
  }
  return most;
}

template <std::size_t n>
ode::Spectrum ModelInterfaceOf<n>::spectrum(double end) const {
  const std::lock_guard lock(spectra_.mutex);
  const auto known = spectra_.all.find(end);
  if (known != spectra_.all.end()) return known->second;
  const auto times = Horizon{end, 64}.times();
  return spectra_.all.emplace(end, spectrum_along(times, accurate_motion(times).value)).first->second;
}

template <std::size_t n>
ode::Spectrum ModelInterfaceOf<n>::spectrum_along(std::span<const double> times,
                                                  std::span<const State> states) const {
  ode::Spectrum spectrum{times.back() / static_cast<double>(times.size()), {}};
  const auto rhs = [&](const double* x, double* dxdt, double t) {
    State state{}, derivative{};
    std::copy_n(x, n, state.begin());
    (*this)(state, derivative, t);
    std::ranges::copy(derivative, dxdt);
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    spectrum.jacobians.push_back(ode::jacobian_at(rhs, states[i], times[i]));
    spectrum.at.push_back(ode::eigenvalues_of(spectrum.jacobians.back()));
  }
  const auto velocities = this->velocities().is;
  spectrum.velocities.assign(velocities.begin(), velocities.end());
  return spectrum;
}

template <std::size_t n>
struct ModelInterfaceOf<n>::Watched {
  ode::Spectrum shown;
  double fastest = 0, span = 0;
  bool goes_on = false;
  std::shared_ptr<const ode::Disturbed<n>> disturbed = nullptr;
};

template <std::size_t n>
auto ModelInterfaceOf<n>::watched(double end, const ode::Criteria& criteria) const -> const Watched& {
  const std::lock_guard lock(watched_.mutex);
  auto& known =
      watched_.all[{end, criteria.radians, criteria.granted, criteria.as_fast, criteria.largest_size}];
  if (known) return *known;
  Watched watched{spectrum(end)};
  watched.fastest = ode::fastest(watched.shown);
  const double later = criteria.radians / watched.fastest, longest = 2 * later;
  watched.disturbed = std::make_shared<const ode::Disturbed<n>>(*this, start(), end, criteria);
  bool goes_on = later > end && watched.fastest > 0 &&
                 ode::largest(spectrum(longest)) <= 1.05 * ode::largest(watched.shown);
  if (goes_on) {
    const auto long_run = std::make_shared<const ode::Disturbed<n>>(*this, start(), longest, criteria);
    goes_on = long_run->span() == longest;  // the size grows no faster than the time
    for (std::size_t i = 0; i < n; ++i)
      goes_on = goes_on && long_run->sizes()[i] <= 1.5 * longest / end * watched.disturbed->sizes()[i];
    if (goes_on) watched.disturbed = long_run;
  }
  watched.goes_on = goes_on;
  watched.span = goes_on ? later : watched.disturbed->span();
  known = std::make_shared<const Watched>(std::move(watched));
  return *known;
}

template <std::size_t n>
Disturbances ModelInterfaceOf<n>::disturbances(std::string_view algorithm, double end,
                                               const ode::Criteria& criteria) const {
  const Watched& watched = this->watched(end, criteria);
  const auto& disturbed = watched.disturbed;
  const auto own_theory = [this, disturbed, algorithm](double step, double until) {
    const auto motion = disturbed->motion(algorithm, step, until);
    const std::size_t points = std::min<std::size_t>(motion.size(), 257);
    std::vector<double> times;
    std::vector<State> states;
    for (std::size_t i = 0; i < points; ++i) {
      const std::size_t at = points == 1 ? 0 : i * (motion.size() - 1) / (points - 1);
      times.push_back(static_cast<double>(at) * step);
      states.push_back(motion[at]);
    }
    return ode::stable_step(algorithm, spectrum_along(times, states));
  };
  return {watched.span,
          disturbed->span(),
          watched.fastest,
          watched.goes_on,
          [disturbed, algorithm](double step) { return disturbed->lost(algorithm, step); },
          [algorithm, &watched, as_fast = criteria.as_fast](double step) {
            return ode::added_growth(algorithm, watched.shown, step, watched.span, as_fast);
          },
          own_theory,
          [disturbed, algorithm](double step) { return disturbed->lost_along_truth(algorithm, step); },
          [disturbed, algorithm](double step) { return disturbed->turns_in_a_step(algorithm, step); }};
}

#define ODDITY_MODEL(n, type) template class type<n>;
ODDITY_FOR_UNKNOWNS(ODDITY_MODEL, ModelInterfaceOf)

bool is_other_algorithm(std::string_view name) {
  bool found = false;
  ode::for_each_other_algorithm(
      [&]<class Algorithm>() { found = found || ode::info<Algorithm>().name == name; });
  return found;
}

SceneMethods& SceneMethods::add(std::string name, Any model, ode::AlgorithmInfo algorithm, Outcome expected,
                                std::string why) {
  if (algorithm.blind_to_time && model->has_rates_of_time()) return *this;
  std::function<std::vector<ode::Tongue>()> unstable_steps;
  std::function<Disturbances(const ode::Criteria&)> disturbances;
  const bool has_tolerance = ode::has_tolerance(algorithm.kind);
  if (!has_tolerance) {
    unstable_steps = [model, algorithm, end = horizon_.end] {
      return ode::unstable_steps(algorithm.name, model->spectrum(end));
    };
    disturbances = [model, algorithm, end = horizon_.end](const ode::Criteria& criteria) {
      return model->disturbances(algorithm.name, end, criteria);
    };
  }
  const auto run = [model, algorithm, horizon = horizon_](double setting) {
    return model->run(algorithm.name, horizon, setting);
  };
  std::function<double(double)> off_constraint;
  const auto places_and_rates = [model, algorithm, horizon = horizon_](double setting) {
    return model->places_and_rates(algorithm.name, horizon, setting);
  };
  if (model->constrained())
    off_constraint = [model, algorithm, horizon = horizon_](double setting) {
      return model->off_constraint(algorithm.name, horizon, setting);
    };
  Method method{std::move(name),
                std::string(algorithm.name),
                has_tolerance ? tolerances_ : steps_,
                run,
                expected,
                std::move(why),
                std::move(unstable_steps),
                std::move(disturbances),
                std::move(off_constraint)};
  method.state_size = model->unknowns();
  method.places_and_rates = places_and_rates;
  quantity_.add(std::move(method));
  return *this;
}

SceneMethods& SceneMethods::by_fixed_steps(const std::string& name, const Any& model, Outcome first_order,
                                           Outcome second_order) {
  const auto too_low = [](Outcome expected) -> std::string {
    return expected == Outcome::ok ? "" : "its order is too low for this need at this step";
  };
  by<ode::ExplicitEuler>(name, model, first_order, too_low(first_order));
  const Outcome symplectic = first_order == Outcome::drifted ? Outcome::inaccurate : first_order;
  if (model->partitioned())
    by<ode::SymplecticEuler>(name, model, symplectic, too_low(symplectic))
        .by<ode::VelocityVerlet>(name, model, second_order, too_low(second_order));
  else if (model->has_velocities())
    by<ode::SemiImplicitEuler>(name, model, first_order, too_low(first_order));
  return by<ode::RungeKutta4>(name, model);
}

SceneMethods& SceneMethods::by_engine_integrators(const std::string& name, const Any& model,
                                                  Outcome first_order, Outcome second_order) {
  return by_fixed_steps(name, model, first_order, second_order)
      .by<ode::CashKarp54>(name, model)
      .by<ode::DormandPrince54>(name, model)
      .by<ode::Fehlberg78>(name, model)
      .by<ode::BulirschStoer>(name, model);
}

SceneMethods& SceneMethods::by_core_integrators(const std::string& name, const Any& model,
                                                Outcome first_order, Outcome second_order) {
  return by_fixed_steps(name, model, first_order, second_order)
      .by<ode::DormandPrince54>(name, model)
      .by<ode::Fehlberg78>(name, model);
}

SceneMethods& SceneMethods::by_remaining_integrators(const std::string& name, const Any& model,
                                                     const std::vector<ExpectedFailure>& exceptions) {
  const auto named = [&](std::string_view algorithm) {
    return std::ranges::find(exceptions, algorithm, &ExpectedFailure::algorithm);
  };
  std::size_t used = 0;
  for (std::string_view optional : ode::optional_algorithms)
    if (!ode::has_sundials) used += named(optional) != exceptions.end();
  ode::for_each_other_algorithm([&]<class Algorithm>() {
    const ode::AlgorithmInfo algorithm = ode::info<Algorithm>();
    if (algorithm.kind == ode::Kind::partitioned && !model->partitioned()) return;
    if (algorithm.by_series && !model->analytic()) return;
    const auto exception = named(algorithm.name);
    if (exception == exceptions.end()) {
      by<Algorithm>(name, model);
    } else {
      ++used;
      by<Algorithm>(name, model, exception->expected, exception->why);
    }
  });
  if (used != exceptions.size())
    throw std::logic_error(name + ": an exception names an algorithm that is not tried");
  return *this;
}

}  // namespace oddity
