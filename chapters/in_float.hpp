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

/// A scene's parameters, a struct of numbers only, each rounded to the other number type.
template <class To, class From, template <class> class Given>
Given<To> rounded_to(const Given<From>& given) {
  constexpr std::size_t n = sizeof(Given<From>) / sizeof(From);
  static_assert(sizeof(Given<To>) == n * sizeof(To));
  const auto numbers = std::bit_cast<std::array<From, n>>(given);
  std::array<To, n> rounded;
  for (std::size_t i = 0; i < n; ++i) rounded[i] = static_cast<To>(numbers[i]);
  return std::bit_cast<Given<To>>(rounded);
}

/// Effect of roundings on a motion, measured with the model in double.
struct Roundings {
  double of_parameters = 0;  ///< error of the motion with the parameters rounded to float
  double of_each_step = 0;   ///< final size of one rounding of each unknown; for a closed form, of its terms

  /// Bound for this number of steps, each with at most eight roundings per unknown. For a formula, the bound
  /// for at most 16 roundings.
  double at_most(double steps) const { return of_parameters + 8 * steps * of_each_step; }
  double at_most() const { return of_parameters + 16 * of_each_step; }
};

/// A model in float, together with the same model in double. The latter computes the observables and
/// conserved quantities, so that their roundings are not mistaken for errors of the motion.
class ModelInFloat {
 public:
  explicit ModelInFloat(const Horizon& horizon) : horizon_(horizon) {}
  virtual ~ModelInFloat() = default;
  /// False if the algorithm exists in double only.
  virtual bool has(std::string_view algorithm) const = 0;
  virtual Answer run(std::string_view algorithm, double setting) const = 0;
  /// See Method.
  virtual Value places_and_rates(std::string_view algorithm, double setting) const = 0;
  virtual bool constrained() const { return false; }
  virtual double off_constraint(std::string_view, double) const { return 0; }
  /// Bound on the errors that roundings add to the observables; infinity if the motion cannot be computed.
  virtual double roundings(double setting) const = 0;

 protected:
  const Horizon& horizon() const { return horizon_; }
  /// Measured at the first call.
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
  /// The motion's states, converted to double.
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

/// A closed form computes its observables by its formula in float.
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
  /// The rates come from the formula with rounded parameters.
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

/// A scene's motion with its models in float added. Each model gets the algorithms in float of those that the
/// model of its name has in double, at the same settings. `names` lists the names of models(given) in the
/// motion, in order: the model's, or "model, algorithm" for a closed form with its own algorithm. A name is
/// empty for a model that the motion omits. `at_finest` is the expected outcome of Runge-Kutta 4 in float on
/// the richest model at its finest step. Unless ok, it makes a breakdown with double as its cure. Throws
/// std::logic_error for a name that is not found.
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
