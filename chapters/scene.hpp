#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "reference/reference.hpp"
#include "solvers/ode/all.hpp"

/// Exercises with motion: a ladder of models, each mapping its own state to the same observables.
///
/// A closed form offers            at(t) -> array of observables.
/// A model to be integrated offers State, start() -> State, operator()(x, dxdt, t), observe(x, t) ->
/// observables, and, where there are any,       invariant(x, t) -> double, a conserved quantity;
///                                 acceleration(q, a), for x = (q, v) with forces of position alone.
namespace oddity {

/// The times at which a scene is looked at: `samples` of them, evenly spaced, the last at `end`.
struct Horizon {
  double end;
  int samples = 4;

  /// Zero and the sample times.
  std::vector<double> times() const {
    std::vector<double> all{0};
    for (int k = 1; k <= samples; ++k) all.push_back(end * k / samples);
    return all;
  }
};

template <class Model>
concept ClosedForm = requires(const Model& model, double t) {
  model.at(t);
};

template <class Model>
concept Conservative = requires(const Model& model, const typename Model::State& x) {
  { model.invariant(x, 0.0) } -> std::convertible_to<double>;
};

template <class Model>
concept Partitioned = requires(const Model& model, ode::detail::Halves<typename Model::State>& halves) {
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

/// A closed form at the horizon's times; its cost is one evaluation a time.
template <ClosedForm Model>
Answer observe_closed_form(const Model& model, const Horizon& horizon) {
  std::vector<double> seen;
  const auto times = horizon.times();
  for (std::size_t i = 1; i < times.size(); ++i)
    for (double x : model.at(times[i])) seen.push_back(x);
  return {Value(std::move(seen)), horizon.samples};
}

/// A model integrated to the horizon, observed at its times, its invariant watched.
template <class Algorithm, class Model>
Answer observe_integrated(const Model& model, const Horizon& horizon, double setting) {
  const auto times = horizon.times();
  const auto trajectory =
      ode::integrate<Algorithm>(model, model.start(), std::span<const double>(times), setting);
  Answer answer{{}, trajectory.evaluations, trajectory.error_estimate,
                0,  trajectory.ending,      trajectory.message};
  std::vector<double> seen;
  for (std::size_t i = 1; i < trajectory.value.size(); ++i) {
    for (double x : model.observe(trajectory.value[i], times[i])) seen.push_back(x);
    if constexpr (Conservative<Model>) {
      const double at_start = model.invariant(trajectory.value[0], times[0]);
      const double change = std::abs(model.invariant(trajectory.value[i], times[i]) - at_start);
      answer.drift = std::max(answer.drift, change / std::max(std::abs(at_start), 1e-300));
    }
  }
  answer.value = Value(std::move(seen));
  return answer;
}

/// A scene's models and algorithms as the methods of one quantity.
class Ladder {
 public:
  Ladder(Quantity& quantity, Horizon horizon, Knob steps, Knob tolerances)
      : quantity_(quantity),
        horizon_(horizon),
        steps_(std::move(steps)),
        tolerances_(std::move(tolerances)) {}

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
    quantity_.add(Method{
        std::move(name), std::string(Algorithm::name),
        ode::has_tolerance(Algorithm::kind) ? tolerances_ : steps_,
        [model, horizon](double setting) { return observe_integrated<Algorithm>(model, horizon, setting); },
        expected, std::move(why)});
    return *this;
  }

  /// The model by every algorithm that it allows; those of order 1 and 2 are expected to end `low_order`.
  template <class Model>
  Ladder& by_all(const std::string& name, const Model& model, Outcome first_order = Outcome::inaccurate,
                 Outcome second_order = Outcome::ok) {
    ode::for_each_algorithm([&]<class Algorithm>() {
      if constexpr (Algorithm::kind != ode::Kind::partitioned || Partitioned<Model>) {
        const bool first = low_order<Algorithm>(1), second = low_order<Algorithm>(2);
        by<Algorithm>(name, model,
                      first    ? first_order
                      : second ? second_order
                               : Outcome::ok,
                      first || second ? "its order is too low for this need at this step" : "");
      }
    });
    return *this;
  }

 private:
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
