#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "chapters/scene.hpp"
#include "solvers/ode/in_float.hpp"

/// A scene's models in float, as games compute.
namespace oddity {

/// A scene's parameters, which are nothing but numbers, each rounded to the other number type.
template <class To, class From, template <class> class Given>
Given<To> rounded_to(const Given<From>& given) {
  constexpr std::size_t n = sizeof(Given<From>) / sizeof(From);
  static_assert(sizeof(Given<To>) == n * sizeof(To));
  const auto numbers = std::bit_cast<std::array<From, n>>(given);
  std::array<To, n> rounded;
  for (std::size_t i = 0; i < n; ++i) rounded[i] = static_cast<To>(numbers[i]);
  return std::bit_cast<Given<To>>(rounded);
}

/// What roundings do to a motion, as the model in double shows it.
struct Roundings {
  double of_parameters = 0;  ///< how far the motion from parameters rounded to float is off
  double of_each_step = 0;   ///< to what one rounding of each unknown grows; of a closed form, of its terms

  /// The most that they may add in so many steps, each with at most eight roundings of an unknown, or in a
  /// formula with at most 16.
  double at_most(double steps) const { return of_parameters + 8 * steps * of_each_step; }
  double at_most() const { return of_parameters + 16 * of_each_step; }
};

/// One model in float beside itself in double, which observes it and computes its conserved quantities: a
/// rounding of these is not taken for an error of the motion.
class ModelInFloat {
 public:
  explicit ModelInFloat(const Horizon& horizon) : horizon_(horizon) {}
  virtual ~ModelInFloat() = default;
  /// False where the algorithm is in double only.
  virtual bool has(std::string_view algorithm) const = 0;
  virtual Answer run(std::string_view algorithm, double setting) const = 0;
  /// As Method has them.
  virtual Value places_and_rates(std::string_view algorithm, double setting) const = 0;
  virtual bool constrained() const { return false; }
  virtual double off_constraint(std::string_view, double) const { return 0; }
  /// What roundings may add to the observables' errors at most; infinity where the motion cannot be followed.
  virtual double roundings(double setting) const = 0;

 protected:
  const Horizon& horizon() const { return horizon_; }
  /// As measured at the first call.
  const Roundings& measured() const {
    std::call_once(once_, [this] { roundings_ = measure(); });
    return roundings_;
  }

 private:
  virtual Roundings measure() const = 0;

  Horizon horizon_;
  mutable std::once_flag once_;
  mutable Roundings roundings_;
};

namespace detail {

template <std::size_t n>
class IntegratedInFloat : public ModelInFloat {
 public:
  using InDouble = std::shared_ptr<const ModelInterfaceOf<n>>;

  IntegratedInFloat(const Horizon& horizon, InDouble exact, InDouble rounded)
      : ModelInFloat(horizon), exact_(std::move(exact)), rounded_(std::move(rounded)) {}
  bool has(std::string_view algorithm) const final;
  Answer run(std::string_view algorithm, double setting) const final;
  Value places_and_rates(std::string_view algorithm, double setting) const final;
  bool constrained() const final { return exact_->constrained(); }
  double off_constraint(std::string_view algorithm, double setting) const final;
  double roundings(double setting) const final;

 private:
  Roundings measure() const final;
  /// The motion's states in double.
  ode::Trajectory<std::array<double, n>> widened(std::string_view algorithm, double setting) const;
  virtual const ode::AnySystem<n, float>& system() const = 0;
  virtual std::array<float, n> start() const = 0;

  InDouble exact_, rounded_;
};

template <class InFloat, class InDouble>
class Integrated final : public IntegratedInFloat<std::tuple_size_v<typename InDouble::State>> {
  static constexpr std::size_t n = std::tuple_size_v<typename InDouble::State>;

 public:
  Integrated(const Horizon& horizon, const InFloat& model, const InDouble& exact, const InDouble& rounded)
      : IntegratedInFloat<n>(horizon, type_erased(exact), type_erased(rounded)), model_(model) {}

 private:
  const ode::AnySystem<n, float>& system() const override { return model_; }
  std::array<float, n> start() const override { return model_.system().start(); }

  ode::Adapted<ode::AnySystem<n, float>, InFloat> model_;
};

/// A closed form's observables are of its formula and in float.
template <class InFloat, class InDouble>
class ClosedFormInFloat final : public ModelInFloat {
 public:
  ClosedFormInFloat(const Horizon& horizon, const InFloat& model, const InDouble& exact,
                    const InDouble& rounded)
      : ModelInFloat(horizon), model_(model), exact_(exact), rounded_(rounded) {}
  bool has(std::string_view algorithm) const override { return algorithm == "closed form"; }
  Answer run(std::string_view, double) const override {
    return observe_at_times(horizon(), [this](double t, Answer& answer) {
      ++answer.evaluations;
      return model_.at(static_cast<float>(t));
    });
  }
  /// The rates are those of the formula with its parameters rounded.
  Value places_and_rates(std::string_view, double) const override {
    const std::size_t times = static_cast<std::size_t>(horizon().count());
    Value seen = places_and_rates_of(rounded_, horizon());
    const Value observed = run({}, 0).value;
    const std::size_t stride = seen.size() / times, parts = observed.size() / times;
    for (std::size_t k = 0; 2 * parts == stride && k < times; ++k)
      for (std::size_t i = 0; i < parts; ++i) seen[k * stride + i] = observed[k * parts + i];
    return seen;
  }
  double roundings(double) const override { return measured().at_most(); }

 private:
  Roundings measure() const override {
    constexpr double later = 1 + unit_roundoff<float>;
    Roundings most;
    for (double t : horizon().times()) {
      const Value there = exact_.at(t);
      most.of_parameters = std::max(most.of_parameters, distance(rounded_.at(t), there));
      most.of_each_step = std::max(
          most.of_each_step, distance(exact_.at(t * later), there) + unit_roundoff<float> * size_of(there));
    }
    return most;
  }

  InFloat model_;
  InDouble exact_, rounded_;
};

template <class InFloat, class InDouble>
std::shared_ptr<const ModelInFloat> model_in_float(const Horizon& horizon, const InFloat& model,
                                                   const InDouble& exact, const InDouble& rounded) {
  if constexpr (ClosedForm<InDouble>)
    return std::make_shared<const ClosedFormInFloat<InFloat, InDouble>>(horizon, model, exact, rounded);
  else
    return std::make_shared<const Integrated<InFloat, InDouble>>(horizon, model, exact, rounded);
}

void add_in_float(Quantity&, const std::vector<std::string_view>& names,
                  const std::vector<std::shared_ptr<const ModelInFloat>>&, Outcome at_finest);

}  // namespace detail

/// A scene's motion with its models in float too, each by every algorithm in float of those that the model of
/// its name has in double, at the same settings. `names` are those that the motion gives to models(given), in
/// their order: a model's, "model, algorithm" for a closed form with an algorithm of its own, empty for one
/// that it leaves out. `at_finest` is how Runge-Kutta 4 on the richest model is expected to end in float at
/// its finest step; unless ok, that is a breakdown, with double as its cure. Throws std::logic_error for a
/// name under which nothing is found.
template <template <class> class Given>
Quantity with_float(Quantity motion, const Horizon& horizon, const Given<double>& given,
                    const std::vector<std::string_view>& names, Outcome at_finest = Outcome::inaccurate) {
  const auto in_float = rounded_to<float>(given);
  const auto floats = models(in_float);
  const auto exact = models(given), rounded = models(rounded_to<double>(in_float));
  std::vector<std::shared_ptr<const ModelInFloat>> all;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (all.push_back(
         detail::model_in_float(horizon, std::get<i>(floats), std::get<i>(exact), std::get<i>(rounded))),
     ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(exact)>>());
  detail::add_in_float(motion, names, all, at_finest);
  return motion;
}

}  // namespace oddity
