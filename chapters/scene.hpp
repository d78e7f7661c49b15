#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/numbers.hpp"
#include "chapters/off_constraints.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/ode/stability.hpp"
#include "solvers/stop.hpp"

/// Exercises with motion: a ladder of models, each mapping its own state to the same observables.
///
/// A closed form offers at(t) -> array of observables, and optionally place(t), as below.
/// A model to be integrated offers State, start() -> State, operator()(x, dxdt, t), observe(x, t) ->
/// observables, and optionally
/// - conserved(x, t) -> array of Conserved
/// - place(x, t)                  if a scene's laws need more than the observables
/// - acceleration(q, a)           for x = (q, v) with forces that depend on position alone
/// - constraints(x, t) -> array   m, all zero where redundant coordinates fit together
/// - guards(x, t) -> array, at_event(i, x, t) -> Happening
///                                an event is where a guard falls through zero
///
/// chapters/examples/bouncing_ball/scene.hpp is a complete scene in 50 lines.
namespace oddity {

/// Tolerances of a game for a position [m] and an angle [rad].
inline constexpr double centimeter = 0.01, degree = std::numbers::pi / 180;

/// The scene's motion, with its observables judged by its norms.
inline Quantity motion(const Scene& scene, const Parameters& parameters, const Horizon& horizon,
                       const Reference& truth) {
  Quantity seen = scene.motion(parameters, horizon, truth);
  seen.samples = horizon.count();
  seen.norms = scene.axes.norms;
  if (scene.laws.energy)
    seen.energy = [law = scene.laws.energy, parameters](std::span<const double> places_and_rates) {
      return law(parameters, places_and_rates);
    };
  if (scene.laws.off)
    seen.off = [law = scene.laws.off, parameters, times = horizon.times()](std::span<const double> observed,
                                                                           int k) {
      return law(parameters, observed, times[static_cast<std::size_t>(k) + 1]);
    };
  return seen;
}
/// With the book's horizon.
inline Quantity motion(const Scene& scene, const Parameters& parameters, const Reference& truth) {
  return motion(scene, parameters, {scene.horizon}, truth);
}

template <class Model>
concept ClosedForm = requires(const Model& model, double t) {
  model.at(t);
};

template <class Model>
concept Conservative = requires(const Model& model, const typename Model::State& x) {
  { model.conserved(x, 0.0)[0] } -> std::convertible_to<Conserved<double>>;
};

template <class Model>
concept Constrained = requires(const Model& model, const typename Model::State& x) {
  { model.constraints(x, 0.0)[0] } -> std::convertible_to<double>;
};

template <class Model, class State>
concept Placed = requires(const Model& model, const State& x) {
  model.place(x, 0.0)[0];
};

/// Rates of `at`(h) at h = 0, by sixth-order central differences. At a spacing of `step` their error is (w
/// step)^6/140 of a rate of frequency w, plus a rounding over the step.
template <class At>
std::vector<double> rates(const At& at, double step) {
  constexpr double weights[]{0.75, -0.15, 1.0 / 60};
  std::vector<double> rates;
  for (int k = 1; k <= 3; ++k) {
    const auto later = at(k * step), before = at(-k * step);
    rates.resize(later.size(), 0);
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] += weights[k - 1] * (later[i] - before[i]) / step;
  }
  return rates;
}
/// In a scene's unit of time: the rates are right to 1e-10 if a body turns by a hundred rad in it.
inline constexpr double step_of_rates = 1.0 / 2048;

/// Appends places and their rates.
inline void add_placed(const auto& places, const std::vector<double>& rates, std::vector<double>& to) {
  to.insert(to.end(), places.begin(), places.end());
  to.insert(to.end(), rates.begin(), rates.end());
}

/// The true observables at a scene's times, from the table `name`, whose last input is the time.
inline Known trajectory(const Reference& truth, std::string_view name, const std::vector<double>& inputs,
                        const Horizon& horizon) {
  const auto times = horizon.times();
  return truth.motion(name, inputs, std::span(times).subspan(1));
}

/// "4 times up to 10 s".
inline std::string times_up_to(const Horizon& horizon, const std::string& unit = "s") {
  const std::string times = horizon.count() == 1 ? " time up to " : " times up to ";
  return std::to_string(horizon.count()) + times + format_shortest(horizon.end) + " " + unit;
}

/// Runs a method that needs no steps. see(t, answer) returns the observables at a time, and counts its work
/// in `answer`, which it may also end.
template <class See>
Answer observe_at_times(const Horizon& horizon, const See& see) {
  const auto times = horizon.times();
  Answer answer;
  std::vector<double> seen;
  for (std::size_t i = 1; i < times.size() && answer.reached(); ++i) {
    check_stop_at_times();
    const auto observables = see(times[i], answer);
    seen.insert(seen.end(), observables.begin(), observables.end());
  }
  answer.value = Value(std::move(seen));
  return answer;
}

/// Costs one evaluation per time.
template <ClosedForm Model>
Answer observe_closed_form(const Model& model, const Horizon& horizon) {
  return observe_at_times(horizon, [&](double t, Answer& answer) {
    ++answer.evaluations;
    return model.at(t);
  });
}

/// Places and rates of a closed form.
Value places_and_rates_of(const auto& model, const Horizon& horizon) {
  const auto place = [&](double t) {
    if constexpr (requires { model.place(t); })
      return model.place(t);
    else
      return model.at(t);
  };
  const auto times = horizon.times();
  std::vector<double> seen;
  for (std::size_t i = 1; i < times.size(); ++i) {
    check_stop_at_times();
    add_placed(place(times[i]), rates([&](double h) { return place(times[i] + h); }, step_of_rates), seen);
  }
  return Value(std::move(seen));
}

/// A separate method that computes the place at a time.
template <class At>
struct AtTimes {
  At at;
};

/// A model's interface for the precompiled algorithms.
class ModelInterface {
 public:
  virtual ~ModelInterface() = default;
  virtual std::size_t unknowns() const = 0;
  virtual bool partitioned() const = 0;
  /// Whether some of its unknowns are velocities, or it declares them to be functions of time.
  virtual bool has_velocities() const = 0;
  /// Whether at least one of its unknowns changes at a rate that is a function of time alone.
  virtual bool has_rates_of_time() const = 0;
  virtual bool constrained() const = 0;
  /// Whether it can be recorded for Taylor series.
  virtual bool analytic() const = 0;
  /// Runs a precompiled algorithm.
  virtual Answer run(std::string_view algorithm, const Horizon&, double setting) const = 0;
  /// m, the largest violation of the model's constraint along that motion; NaN if there is no motion.
  virtual double off_constraint(std::string_view algorithm, const Horizon&, double setting) const = 0;
  /// Places and rates of that motion.
  virtual Value places_and_rates(std::string_view algorithm, const Horizon&, double setting) const = 0;
  /// The eigenvalues of the Jacobian along the motion.
  virtual ode::Spectrum spectrum(double end) const = 0;
  /// Treatment of small disturbances of the motion. The model must outlive the result.
  virtual Disturbances disturbances(std::string_view algorithm, double end, const ode::Criteria&) const = 0;
};

/// A model of n unknowns.
template <std::size_t n>
class ModelInterfaceOf : public ModelInterface, public ode::AnySystem<n> {
 public:
  using typename ode::AnySystem<n>::State;

  std::size_t unknowns() const final { return n; }
  bool has_velocities() const final { return this->velocities().known; }
  bool has_rates_of_time() const final { return ode::has_rates_of_time<State>(*this); }
  virtual State start() const = 0;
  /// Appends the observables to `seen`.
  virtual void observe(const State& x, double t, std::vector<double>& seen) const = 0;
  /// The places that the scene's laws refer to.
  virtual std::vector<double> place(const State& x, double t) const = 0;
  /// Empty if the model conserves nothing.
  virtual std::vector<Conserved<double>> conserved(const State& x, double t) const = 0;
  /// m, the violation of all constraints; 0 if the model has none.
  virtual double off_constraint_at(const State& x, double t) const = 0;
  /// m, each of them; empty if the model has none.
  virtual std::vector<double> constraints_at(const State& x, double t) const = 0;

  Answer run(std::string_view algorithm, const Horizon&, double setting) const final;
  double off_constraint(std::string_view algorithm, const Horizon&, double setting) const final;
  Value places_and_rates(std::string_view algorithm, const Horizon&, double setting) const final;
  ode::Spectrum spectrum(double end) const final;
  Disturbances disturbances(std::string_view algorithm, double end, const ode::Criteria&) const final;
  /// Observes a motion at the times and measures the drift of its conserved quantities.
  Answer observed(std::span<const double> times, const ode::Trajectory<State>&) const;
  /// Whether the conserved quantities come back, watched at every step. In the later half of the time their
  /// largest change exceeds the earlier one by at most a quarter, and their smallest is at most half the
  /// largest.
  bool comes_back(std::string_view algorithm, std::span<const double> times, double setting) const;
  /// m, the largest violation of the constraint at the times; NaN for NaN states or without states.
  double off_constraint(std::span<const double> times, std::span<const State> motion) const;
  /// Places and rates of the states at the times, the rates by the model's own equations.
  Value places_and_rates(std::span<const double> times, std::span<const State> motion) const;

 private:
  /// The eigenvalues at these states, each for an equal part of the time.
  ode::Spectrum spectrum_along(std::span<const double> times, std::span<const State> states) const;
  /// Its motion with its events.
  ode::Trajectory<State> moved(std::string_view algorithm, std::span<const double> times,
                               double setting) const;
  /// Its motion as drawn at the times.
  ode::Trajectory<State> moved(std::string_view algorithm, std::span<const double> times, Stepping,
                               double setting) const;
  /// The state drawn at a time, of a motion through the steps' ends up to there.
  State drawn(double time, std::span<const double> ends, std::span<const State> motion, Stepping) const;
  /// The model's motion to eight digits, as far as it comes in 100,000 steps.
  ode::Trajectory<State> accurate_motion(std::span<const double> times) const;
  /// The largest change of the conserved quantities along a motion, each relative to its moving part.
  double drift(std::span<const double> times, std::span<const State> motion) const;
  /// The largest moving part of each conserved quantity along the model's own motion up to `end`.
  std::vector<double> moving(double end) const;

  /// The motion up to `end` and its disturbances, as long as they are watched.
  struct Watched;
  const Watched& watched(double end, const ode::Criteria&) const;
  /// Computed once; the same for every algorithm.
  template <class Key, class T>
  struct Known {
    std::mutex mutex;
    std::map<Key, T> all;
  };
  mutable Known<double, std::vector<double>> moving_;
  mutable Known<double, ode::Spectrum> spectra_;
  mutable Known<std::array<double, 5>, std::shared_ptr<const Watched>> watched_;
};

template <class Model>
using ModelLike = ModelInterfaceOf<std::tuple_size_v<typename Model::State>>;

template <class Model>
class TypeErased final : public ode::Adapted<ModelLike<Model>, Model> {
 public:
  using typename ModelLike<Model>::State;
  using ode::Adapted<ModelLike<Model>, Model>::Adapted, ode::Adapted<ModelLike<Model>, Model>::system;

  bool partitioned() const override { return ode::Partitioned<Model, State>; }
  bool constrained() const override { return Constrained<Model>; }
  State start() const override { return system().start(); }
  void observe(const State& x, double t, std::vector<double>& seen) const override {
    const auto observables = system().observe(x, t);
    seen.insert(seen.end(), observables.begin(), observables.end());
  }
  std::vector<double> place(const State& x, double t) const override {
    std::vector<double> places;
    if constexpr (Placed<Model, State>) {
      const auto all = system().place(x, t);
      places.assign(all.begin(), all.end());
    } else {
      observe(x, t, places);
    }
    return places;
  }
  std::vector<Conserved<double>> conserved(const State& x, double t) const override {
    if constexpr (Conservative<Model>) {
      const auto all = system().conserved(x, t);
      return {all.begin(), all.end()};
    } else {
      return {};
    }
  }
  std::vector<double> constraints_at(const State& x, double t) const override {
    if constexpr (Constrained<Model>) {
      const auto all = system().constraints(x, t);
      return {all.begin(), all.end()};
    } else {
      return {};
    }
  }
  double off_constraint_at(const State& x, double t) const override {
    if constexpr (Constrained<Model>)
      return off_constraints(system().constraints(x, t));
    else
      return 0;
  }
};

template <class Model>
std::shared_ptr<const TypeErased<Model>> type_erased(const Model& model) {
  static_assert(
      ode::is_precompiled<typename Model::State>,
      "declare the model's state as `using State = std::array<T, 4>;` with a number, and run CMake: "
      "it compiles the algorithms for the numbers of unknowns that it finds so");
  return std::make_shared<const TypeErased<Model>>(model);
}

/// Runs one algorithm on the model.
template <class Algorithm, class Model>
Answer observe_integrated(const Model& model, const Horizon& horizon, double setting) {
  return type_erased(model)->run(ode::info<Algorithm>().name, horizon, setting);
}

/// Whether SceneMethods::by_remaining_integrators tries this algorithm.
bool is_other_algorithm(std::string_view name);

/// A scene's models and algorithms as the methods of one quantity. A model with a rate that depends on time
/// alone is not tried by an algorithm whose error estimate cannot detect it.
class SceneMethods {
 public:
  SceneMethods(Quantity& quantity, Horizon horizon, Resolution steps, Resolution tolerances)
      : quantity_(quantity), horizon_(horizon), steps_(std::move(steps)), tolerances_(std::move(tolerances)) {
    quantity_.samples = horizon_.count();
    quantity_.for_own_parameters = true;
  }

  template <ClosedForm Model>
  SceneMethods& closed_form(std::string name, const Model& model, Outcome expected = Outcome::ok,
                            std::string why = {}) {
    const Horizon horizon = horizon_;
    Method method{std::move(name), "closed form",
                  no_resolution(), [model, horizon](double) { return observe_closed_form(model, horizon); },
                  expected,        std::move(why)};
    method.places_and_rates = [model, horizon](double) { return places_and_rates_of(model, horizon); };
    quantity_.add(std::move(method));
    return *this;
  }

  /// Adds the model with one algorithm.
  template <class Algorithm, class Model>
  SceneMethods& by(std::string name, const Model& model, Outcome expected = Outcome::ok,
                   std::string why = {}) {
    return by<Algorithm>(std::move(name), any(model), expected, std::move(why));
  }

  /// Adds the model with the explicit algorithms that engines use, as far as it allows them. `first_order`
  /// and `second_order` are the expected outcomes for those of order 1 and 2.
  template <class Model>
  SceneMethods& by_engine_integrators(const std::string& name, const Model& model,
                                      Outcome first_order = Outcome::inaccurate,
                                      Outcome second_order = Outcome::ok) {
    return by_engine_integrators(name, any(model), first_order, second_order);
  }

  /// Adds the same methods without Cash-Karp and Bulirsch-Stoer.
  template <class Model>
  SceneMethods& by_core_integrators(const std::string& name, const Model& model,
                                    Outcome first_order = Outcome::inaccurate,
                                    Outcome second_order = Outcome::ok) {
    return by_core_integrators(name, any(model), first_order, second_order);
  }

  /// An algorithm that is expected to fail at its finest setting.
  struct ExpectedFailure {
    std::string_view algorithm;
    Outcome expected;
    std::string why;
  };

  /// Adds the model with the rest of the catalog, as far as it allows it. All are expected to end ok, except
  /// the exceptions. Throws std::logic_error for an exception that names none of these algorithms.
  template <class Model>
  SceneMethods& by_remaining_integrators(const std::string& name, const Model& model,
                                         const std::vector<ExpectedFailure>& exceptions = {}) {
    return by_remaining_integrators(name, any(model), exceptions);
  }

 private:
  using Any = std::shared_ptr<const ModelInterface>;
  template <class Model>
  static Any any(const Model& model) {
    return type_erased(model);
  }

  template <class Algorithm>
  SceneMethods& by(std::string name, Any model, Outcome expected = Outcome::ok, std::string why = {}) {
    return add(std::move(name), std::move(model), ode::info<Algorithm>(), expected, std::move(why));
  }
  SceneMethods& by_engine_integrators(const std::string& name, const Any&, Outcome first_order,
                                      Outcome second_order);
  SceneMethods& by_core_integrators(const std::string& name, const Any&, Outcome first_order,
                                    Outcome second_order);
  SceneMethods& by_fixed_steps(const std::string& name, const Any&, Outcome first_order,
                               Outcome second_order);
  SceneMethods& by_remaining_integrators(const std::string& name, const Any&,
                                         const std::vector<ExpectedFailure>&);
  SceneMethods& add(std::string name, Any model, ode::AlgorithmInfo algorithm, Outcome expected,
                    std::string why);

  Quantity& quantity_;
  Horizon horizon_;
  Resolution steps_, tolerances_;
};

}  // namespace oddity
