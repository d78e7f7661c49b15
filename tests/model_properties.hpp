#pragma once

#include "chapters/scene.hpp"
#include "tests/models_in_numbers.hpp"
#include "tests/properties.hpp"

/// What holds of every model of a scene at all of its parameters.
namespace oddity::models_test {

/// Observed are all unknowns. What the model conserves is no matter here.
template <class Model>
struct Bare {
  using State = typename Model::State;
  Model model;
  State start() const { return model.start(); }
  void operator()(const State& x, State& dxdt, double t) const { model(x, dxdt, t); }
  State observe(const State& x, double) const { return x; }
};

/// x' = -f(x, end - t) from the state in which the model is at the end.
template <class Model>
struct FromTheEnd {
  using State = typename Model::State;
  Model model;
  double end;
  State last;
  State start() const { return last; }
  void operator()(const State& x, State& dxdt, double t) const {
    model(x, dxdt, end - t);
    for (double& rate : dxdt) rate = -rate;
  }
  State observe(const State& x, double) const { return x; }
};

/// How long a motion is looked at: the scene's horizon, or as far as a few thousand evaluations go.
template <class Model>
double affordable(const Model& model, double horizon) {
  const auto any = type_erased(model);
  double end = horizon / 0x1p16;
  while (end < horizon) {
    const Answer answer = any->run("Dormand-Prince 5(4)", {2 * end, 1}, 1e-8);
    if (!answer.reached() || answer.evaluations > 4000) break;
    end *= 2;
  }
  return end;
}

/// There by the tolerance and back from that end, times a number about one; nothing where the algorithm does
/// not reach both ends.
template <class Model>
std::optional<Value> there_and_back(const Model& model, double end, double tolerance, double times = 1) {
  const Answer there = type_erased(Bare<Model>{model})->run("Fehlberg 7(8)", {end, 1}, tolerance);
  if (!there.reached()) return {};
  FromTheEnd<Model> back{model, end, {}};
  std::ranges::transform(there.value, back.last.begin(), [&](double x) { return times * x; });
  const Answer again = type_erased(back)->run("Fehlberg 7(8)", {end, 1}, tolerance);
  if (!again.reached()) return {};
  return again.value;
}

template <template <class> class Given>
class AtRandom {
 public:
  explicit AtRandom(std::string_view number) : entry_(properties::entry_of(number)) {}

  void comes_back() const {
    check("run back from its end, a motion comes to its start",
          [this](const auto& model) { return not_back(model); });
  }
  void conserves() const {
    check("what is conserved does not change", [this](const auto& model) { return not_conserved(model); });
  }

 private:
  static auto all(const Parameters& parameters) {
    std::vector<double> values;
    for (const Parameter& p : parameters.declared()) values.push_back(parameters[p.name]);
    return models(given<Given, double>(values));
  }

  template <class Wrong>
  void check(const std::string& says, const Wrong& wrong) const {
    properties::check(entry_, says, 4, [&](const Parameters& parameters) {
      motion(*entry_.exercise.scene, parameters, {1},
             Reference::nothing());  // refuses what does not go together
      std::string all_wrong;
      std::apply([&](const auto&... model) { ((all_wrong += all_wrong.empty() ? wrong(model) : ""), ...); },
                 all(parameters));
      return all_wrong;
    });
  }

  /// A tolerance that is much coarser errs at least as much, and so does a thousand roundings at the end,
  /// whatever the motion makes of either.
  template <class Model>
  std::string not_back(const Model& model) const {
    if constexpr (
        Integrable<Model> && !requires { Model::not_analytic; } &&
        !requires { model.guards(model.start(), 0.0); }) {
      const double end = affordable(Bare<Model>{model}, entry_.exercise.scene->horizon);
      const auto fine = there_and_back(model, end, 1e-13), coarse = there_and_back(model, end, 1e-9);
      const auto nudged = there_and_back(model, end, 1e-13, 1 + 0x1p-42);
      if (!fine || !coarse || !nudged) return "";
      const double off = distance(*fine, Value(model.start()));
      const double allowed =
          2 * distance(*fine, *coarse) + distance(*fine, *nudged) + rounding(size_of(*fine), 4096).allowed;
      if (off <= allowed) return "";
      return "after " + format_shortest(end) + " it is off by " + format_shortest(off) + ", and " +
             format_shortest(allowed) + " is allowed";
    }
    return "";
  }

  template <class Model>
  std::string not_conserved(const Model& model) const {
    if constexpr (Integrable<Model> && Conservative<Model>) {
      const double end = affordable(model, entry_.exercise.scene->horizon);
      const Answer answer = type_erased(model)->run("Fehlberg 7(8)", {end, 4}, 1e-12);
      if (!answer.reached() || answer.drift <= 1e-6) return "";
      return "after " + format_shortest(end) + " it has changed by " + format_shortest(answer.drift) +
             " of what moves in it";
    }
    return "";
  }

  const Entry& entry_;
};

}  // namespace oddity::models_test
