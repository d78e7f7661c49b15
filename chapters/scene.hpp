#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "solvers/ode/all.hpp"
#include "solvers/ode/stability.hpp"

/// Exercises with motion: a ladder of models, each mapping its own state to the same observables.
///
/// A closed form offers            at(t) -> array of observables.
/// A model to be integrated offers State, start() -> State, operator()(x, dxdt, t), observe(x, t) ->
/// observables, and, where there are any,       invariant(x, t) -> double, a conserved quantity;
///                                 acceleration(q, a), for x = (q, v) with forces of position alone.
namespace oddity {

/// What a game asks of a position [m] and of an angle [rad].
inline constexpr double centimeter = 0.01, degree = std::numbers::pi / 180;

/// The scene as the book has it.
inline Quantity motion(const Scene& scene, const Parameters& parameters, const Reference& truth) {
  return scene.motion(parameters, {scene.horizon}, truth);
}

template <class Model>
concept ClosedForm = requires(const Model& model, double t) {
  model.at(t);
};

template <class Model>
concept Conservative = requires(const Model& model, const typename Model::State& x) {
  { model.invariant(x, 0.0) } -> std::convertible_to<double>;
};

template <class Model>
concept Partitioned = (std::tuple_size_v<typename Model::State> % 2 == 0) &&
                      requires(const Model& model, ode::detail::Halves<typename Model::State>& halves) {
  model.acceleration(halves.q, halves.v);
};

/// The true observables at a scene's times, one look-up of the table `name` a time: inputs, then the time.
inline Known trajectory(const Reference& truth, std::string_view name, std::vector<double> inputs,
                        const Horizon& horizon) {
  Known all;
  inputs.push_back(0);
  for (double t : horizon.times()) {
    if (t == 0) continue;
    inputs.back() = t;
    const Known known = truth(name, inputs);
    all.value.insert(all.value.end(), known.value.begin(), known.value.end());
    all.error = std::max(all.error, known.error);
    all.source = known.source;
  }
  return all;
}

/// "4 times up to 10 s".
inline std::string times_up_to(const Horizon& horizon, const std::string& unit = "s") {
  const std::string times = horizon.samples == 1 ? " time up to " : " times up to ";
  return std::to_string(horizon.samples) + times + shortest(horizon.end) + " " + unit;
}

/// A method that needs no steps: see(t, answer) gives the observables at each of the horizon's stops, and
/// counts its work in `answer`, which it may also end; those at the times are kept.
template <class See>
Answer observe_at_stops(const Horizon& horizon, const See& see) {
  const auto times = horizon.times(), stops = horizon.stops();
  Answer answer;
  std::vector<double> seen;
  std::size_t next = 1, kept = 0;
  for (std::size_t i = 1; i < stops.size() && answer.reached(); ++i) {
    const auto observables = see(stops[i], answer);
    seen.resize(kept + observables.size());
    std::ranges::copy(observables, seen.begin() + static_cast<std::ptrdiff_t>(kept));
    if (next == times.size() || stops[i] != times[next]) continue;
    kept = seen.size();
    ++next;
  }
  answer.value = Value(std::move(seen));
  return answer;
}

/// Its cost is one evaluation a stop.
template <ClosedForm Model>
Answer observe_closed_form(const Model& model, const Horizon& horizon) {
  return observe_at_stops(horizon, [&](double t, Answer& answer) {
    ++answer.evaluations;
    return model.at(t);
  });
}

/// A motion through the horizon's stops, observed at its times, the model's invariant watched. One function
/// for all algorithms.
template <class Model>
[[gnu::noinline]] Answer observed(const Model& model, const Horizon& horizon, std::span<const double> stops,
                                  const ode::Trajectory<typename Model::State>& trajectory) {
  const auto times = horizon.times();
  Answer answer{{}, trajectory.evaluations, trajectory.error_estimate,
                0,  trajectory.ending,      trajectory.message};
  std::vector<double> seen;
  std::size_t next = 1;
  for (std::size_t i = 1; i < trajectory.value.size(); ++i) {
    if (next == times.size() || stops[i] != times[next]) continue;
    ++next;
    for (double x : model.observe(trajectory.value[i], stops[i])) seen.push_back(x);
    if constexpr (Conservative<Model>) {
      const double at_start = model.invariant(trajectory.value[0], 0);
      const double change = std::abs(model.invariant(trajectory.value[i], stops[i]) - at_start);
      answer.drift = std::max(answer.drift, change / std::max(std::abs(at_start), 1e-300));
    }
  }
  answer.value = Value(std::move(seen));
  return answer;
}

template <class Algorithm, class Model>
Answer observe_integrated(const Model& model, const Horizon& horizon, double setting) {
  const auto stops = horizon.stops();
  return observed(model, horizon, stops,
                  ode::integrate<Algorithm>(model, model.start(), std::span<const double>(stops), setting));
}

/// The eigenvalues of the model's Jacobian along its motion.
template <class Model>
ode::Spectrum spectrum(const Model& model, double end) {
  const auto times = Horizon{end, 32}.times();
  long steps = 0;  // a model that chatters about rest would take millions
  const auto enough = [&](double, const auto&, double, const auto&) { return ++steps > 100'000; };
  const auto motion = ode::integrate<ode::DormandPrince54>(model, model.start(),
                                                           std::span<const double>(times), 1e-8, enough);
  ode::Spectrum spectrum{end / static_cast<double>(times.size()), {}};
  const auto rhs = [&](const double* x, double* dxdt, double t) {
    typename Model::State state{}, derivative{};
    std::copy_n(x, state.size(), state.begin());
    model(state, derivative, t);
    std::ranges::copy(derivative, dxdt);
  };
  for (std::size_t i = 0; i < motion.value.size(); ++i)
    spectrum.at.push_back(ode::eigenvalues_of_jacobian(rhs, motion.value[i], times[i]));
  return spectrum;
}

/// A scene's models and algorithms as the methods of one quantity.
class Ladder {
 public:
  Ladder(Quantity& quantity, Horizon horizon, Knob steps, Knob tolerances)
      : quantity_(quantity), horizon_(horizon), steps_(std::move(steps)), tolerances_(std::move(tolerances)) {
    quantity_.samples = horizon_.samples;
  }

  template <ClosedForm Model>
  Ladder& closed_form(std::string name, const Model& model, Outcome expected = Outcome::ok,
                      std::string why = {}) {
    const Horizon horizon = horizon_;
    quantity_.add(Method{std::move(name), "closed form", no_knob(),
                         [model, horizon](double) { return observe_closed_form(model, horizon); }, expected,
                         std::move(why)});
    return *this;
  }

  /// The model by one algorithm.
  template <class Algorithm, class Model>
  Ladder& by(std::string name, const Model& model, Outcome expected = Outcome::ok, std::string why = {}) {
    const Horizon horizon = horizon_;
    std::function<double()> stable_step;
    if constexpr (!ode::has_tolerance(Algorithm::kind))
      stable_step = [model, horizon] {
        return ode::stable_step(Algorithm::name, spectrum(model, horizon.end));
      };
    return add(
        std::move(name), Algorithm::name, ode::has_tolerance(Algorithm::kind),
        [model, horizon](double setting) { return observe_integrated<Algorithm>(model, horizon, setting); },
        expected, std::move(why), std::move(stable_step));
  }

  /// The model by the explicit algorithms that engines use, as far as it allows them, with what those of
  /// order 1 and of order 2 are expected to end as.
  template <class Model>
  Ladder& by_common(const std::string& name, const Model& model, Outcome first_order = Outcome::inaccurate,
                    Outcome second_order = Outcome::ok) {
    ode::for_each_common_algorithm(
        [&]<class Algorithm>() { by_if_it_can<Algorithm>(name, model, first_order, second_order); });
    return *this;
  }

  /// The same without Cash-Karp and Bulirsch-Stoer, which spares a third of the compile time.
  template <class Model>
  Ladder& by_few(const std::string& name, const Model& model, Outcome first_order = Outcome::inaccurate,
                 Outcome second_order = Outcome::ok) {
    by_if_it_can<ode::ExplicitEuler>(name, model, first_order, second_order);
    by_if_it_can<ode::SymplecticEuler>(name, model, first_order, second_order);
    by_if_it_can<ode::VelocityVerlet>(name, model, first_order, second_order);
    return by<ode::RungeKutta4>(name, model)
        .template by<ode::DormandPrince54>(name, model)
        .template by<ode::Fehlberg78>(name, model);
  }

  /// An algorithm that is not expected to end ok at its finest setting.
  struct Exception {
    std::string_view algorithm;
    Outcome expected;
    std::string why;
  };

  /// The model by the rest of the catalog, as far as it allows it: expected to end ok, but for the
  /// exceptions. Throws std::logic_error for an exception that names none of these algorithms.
  template <class Model>
  Ladder& by_others(const std::string& name, const Model& model,
                    const std::vector<Exception>& exceptions = {}) {
    std::size_t used = 0;
    for (std::string_view optional : ode::optional_algorithms)
      if (!ode::has_sundials) used += named(exceptions, optional) != exceptions.end();
    ode::for_each_other_algorithm([&]<class Algorithm>() {
      if constexpr (Algorithm::kind != ode::Kind::partitioned || Partitioned<Model>) {
        const auto exception = named(exceptions, Algorithm::name);
        if (exception == exceptions.end()) {
          by<Algorithm>(name, model);
        } else {
          ++used;
          by<Algorithm>(name, model, exception->expected, exception->why);
        }
      }
    });
    if (used != exceptions.size())
      throw std::logic_error(name + ": an exception names an algorithm that is not tried");
    return *this;
  }

 private:
  Ladder& add(std::string model, std::string_view algorithm, bool has_tolerance,
              std::function<Answer(double setting)> run, Outcome expected, std::string why,
              std::function<double()> stable_step);

  template <class Algorithm, class Model>
  void by_if_it_can(const std::string& name, const Model& model, Outcome first_order, Outcome second_order) {
    if constexpr (Algorithm::kind != ode::Kind::partitioned || Partitioned<Model>) {
      const bool first = low_order<Algorithm>(1), second = low_order<Algorithm>(2);
      by<Algorithm>(name, model,
                    first    ? first_order
                    : second ? second_order
                             : Outcome::ok,
                    first || second ? "its order is too low for this need at this step" : "");
    }
  }

  static std::vector<Exception>::const_iterator named(const std::vector<Exception>& exceptions,
                                                      std::string_view algorithm) {
    return std::ranges::find(exceptions, algorithm, &Exception::algorithm);
  }

  template <class Algorithm>
  static constexpr bool low_order(int order) {
    if constexpr (ode::has_tolerance(Algorithm::kind))
      return false;
    else
      return Algorithm::order == order;
  }

  Quantity& quantity_;
  Horizon horizon_;
  Knob steps_, tolerances_;
};

}  // namespace oddity
