#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/drawing.hpp"
#include "chapters/numbers.hpp"
#include "chapters/off_constraints.hpp"
#include "solvers/ode/any_system.hpp"
#include "solvers/ode/events.hpp"
#include "solvers/ode/in_float.hpp"
#include "solvers/ode/integrate.hpp"

/// The scenes' models for the page: the counterpart of chapters/scene.hpp, without threads, exceptions and
/// judgement. A test replays the program's trials with it.
namespace oddity::module {

/// A motion at the requested times, time after time, until it ends.
struct Motion {
  std::size_t states = 0;  ///< number of times with a state
  std::size_t whole = 0;   ///< number of times reached: without the last state if it broke off
  std::vector<double> observed;
  std::vector<double> drift;  ///< change of the conserved quantities relative to their moving parts; or empty
  std::vector<double> off;    ///< m, off the constraint; or empty
  long evaluations = 0;
  Ending ending = Ending::reached;
  std::string message;
};

enum class Precision { in_double, in_float };

/// A scene's model with its parameters.
class Model {
 public:
  virtual ~Model() = default;
  virtual bool closed_form() const = 0;
  virtual bool partitioned() const = 0;
  /// Some of its unknowns are velocities, or it declares them to be functions of time.
  virtual bool has_velocities() const = 0;
  virtual bool constrained() const = 0;
  virtual bool has_events() const = 0;
  /// The first time is zero. An algorithm that the model does not allow gives a motion that `raised`.
  virtual Motion run(std::string_view algorithm, Precision, double setting,
                     std::span<const double> times) const = 0;
};

/// Closed forms; in float the formula is evaluated in float.
template <class InDouble, class InFloat>
class Formula final : public Model {
 public:
  Formula(const InDouble& in_double, const InFloat& in_float) : in_double_(in_double), in_float_(in_float) {}
  bool closed_form() const override { return true; }
  bool partitioned() const override { return false; }
  bool has_velocities() const override { return false; }
  bool constrained() const override { return false; }
  bool has_events() const override { return false; }
  Motion run(std::string_view, Precision precision, double, std::span<const double> times) const override {
    Motion motion;
    const auto see = [&](const auto& observables) {
      motion.observed.insert(motion.observed.end(), observables.begin(), observables.end());
    };
    for (double t : times)
      precision == Precision::in_float ? see(in_float_.at(static_cast<float>(t))) : see(in_double_.at(t));
    const auto later =
        motion.observed.begin() + static_cast<std::ptrdiff_t>(motion.observed.size() / times.size());
    if (!std::all_of(later, motion.observed.end(), [](double x) { return std::isfinite(x); }))
      motion.ending = Ending::non_finite;
    motion.states = motion.whole = times.size();
    motion.evaluations = static_cast<long>(times.size()) - 1;
    return motion;
  }

 private:
  InDouble in_double_;
  InFloat in_float_;
};

/// A model of n unknowns: compiled once for each n, behind the algorithms' type-erased interface.
template <std::size_t n>
class ModelInterfaceOf : public Model, public ode::AnySystem<n> {
 public:
  using typename ode::AnySystem<n>::State;

  bool closed_form() const final { return false; }
  bool has_velocities() const final { return this->velocities().known; }
  bool has_events() const final { return this->guard_count() > 0; }
  Motion run(std::string_view algorithm, Precision, double setting,
             std::span<const double> times) const final;

 private:
  virtual State start() const = 0;
  virtual void observe(const State&, double t, std::vector<double>& seen) const = 0;
  /// Empty if the model has none.
  virtual std::vector<Conserved<double>> conserved(const State&, double t) const = 0;
  virtual double off_constraint(const State&, double t) const = 0;
  /// In double, with any events.
  virtual ode::Trajectory<State> integrate(std::string_view algorithm, std::span<const double> times,
                                           double setting, const ode::Watch<n>& watch) const = 0;
  virtual const ode::AnySystem<n, float>& system_in_float() const = 0;
  virtual std::array<float, n> start_in_float() const = 0;

  ode::Trajectory<State> moved(std::string_view algorithm, Precision, double setting,
                               std::span<const double> times) const;
  Motion seen(const ode::Trajectory<State>&, std::span<const double> times) const;
  std::vector<double> drift(const ode::Trajectory<State>&, std::span<const double> times) const;
  /// The largest moving part of each conserved quantity along the model's own motion up to `end`.
  const std::vector<double>& moving(double end) const;

  mutable std::map<double, std::vector<double>> moving_;
};

template <class InDouble, class InFloat, std::size_t n>
class Integrated final : public ode::Adapted<ModelInterfaceOf<n>, InDouble> {
  using Base = ode::Adapted<ModelInterfaceOf<n>, InDouble>;

 public:
  using typename Base::State, Base::system;

  Integrated(const InDouble& in_double, const InFloat& in_float) : Base(in_double), in_float_(in_float) {}
  bool partitioned() const override { return ode::Partitioned<InDouble, State>; }
  bool constrained() const override { return is_constrained; }

 private:
  static constexpr bool is_constrained = requires(const InDouble& model, const State& x) {
    model.constraints(x, 0.0)[0];
  };
  static constexpr bool is_conservative = requires(const InDouble& model, const State& x) {
    model.conserved(x, 0.0)[0];
  };

  State start() const override { return system().start(); }
  void observe(const State& x, double t, std::vector<double>& seen) const override {
    const auto observables = system().observe(x, t);
    seen.insert(seen.end(), observables.begin(), observables.end());
  }
  std::vector<Conserved<double>> conserved(const State& x, double t) const override {
    if constexpr (is_conservative) {
      const auto all = system().conserved(x, t);
      return {all.begin(), all.end()};
    } else {
      return {};
    }
  }
  double off_constraint(const State& x, double t) const override {
    if constexpr (is_constrained)
      return off_constraints(system().constraints(x, t));
    else
      return 0;
  }
  /// The search for events is compiled only for numbers of unknowns that need it.
  ode::Trajectory<State> integrate(std::string_view algorithm, std::span<const double> times, double setting,
                                   const ode::Watch<n>& watch) const override {
    if constexpr (ode::Eventful<InDouble, State>)
      return ode::integrate_with_events<n>(algorithm, *this, start(), times, setting, watch).trajectory;
    else
      return ode::precompiled<n>(algorithm)(*this, start(), times, setting, watch);
  }
  const ode::AnySystem<n, float>& system_in_float() const override { return in_float_; }
  std::array<float, n> start_in_float() const override { return in_float_.system().start(); }

  ode::Adapted<ode::AnySystem<n, float>, InFloat> in_float_;
};

template <class InDouble, class InFloat>
std::unique_ptr<const Model> model(const InDouble& in_double, const InFloat& in_float) {
  if constexpr (requires { in_double.at(0.0); })
    return std::make_unique<const Formula<InDouble, InFloat>>(in_double, in_float);
  else
    return std::make_unique<const Integrated<InDouble, InFloat, std::tuple_size_v<typename InDouble::State>>>(
        in_double, in_float);
}

// ---- for a scene's listing (players.cpp), or a problem's file (own/own.cpp) -------------------------------

struct Letter {
  std::string_view name;
  double value;  ///< default
};

struct Listed {
  std::string_view name;
  std::string_view algorithm;  ///< name of a closed form's own algorithm; or empty
  std::function<std::unique_ptr<const Model>(std::span<const double> parameters)> with;
};

/// A scene's parameters by name, for its drawing.
struct Parameters {
  std::span<const Letter> letters;
  std::span<const double> values;

  double operator[](std::string_view name) const {
    for (std::size_t i = 0; i < letters.size(); ++i)
      if (letters[i].name == name) return values[i];
    return std::numeric_limits<double>::quiet_NaN();
  }
};

struct Scene {
  std::string_view number;
  std::size_t observables;
  std::vector<Letter> letters;
  std::vector<Listed> models;
  /// Null if the scene defines no drawing.
  void (*draw)(const Parameters&, double t, std::span<const double> observed, Drawing&);
};

const std::vector<Scene>& scenes();

/// Forgets all models made, as the scenes have changed (exports.cpp).
void forget_models();

}  // namespace oddity::module
