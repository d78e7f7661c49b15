#include "chapters/in_float.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "reference/text.hpp"

namespace oddity::detail {

namespace {

template <std::size_t n>
using Motion = ode::Trajectory<std::array<double, n>>;

/// Motion to twelve digits, for at most 100,000 steps. A model that chatters around rest would take millions.
template <std::size_t n>
Motion<n> accurate(const ModelInterfaceOf<n>& model, const std::array<double, n>& start,
                   std::span<const double> times) {
  using State = std::array<double, n>;
  long steps = 0;
  const auto enough = [&](double, const State&, double, const State&) { return ++steps > 100'000; };
  return ode::precompiled<n>("Fehlberg 7(8)")(model, start, times, 1e-12, ode::Watch<n>(enough));
}

/// Largest difference between the observables of two motions; infinity if one of them ends early.
template <std::size_t n>
double apart(const ModelInterfaceOf<n>& model, const Motion<n>& a, const Motion<n>& b,
             std::span<const double> times) {
  if (a.value.size() != times.size() || b.value.size() != times.size() || !a.reached() || !b.reached())
    return std::numeric_limits<double>::infinity();
  std::vector<double> here, there;
  for (std::size_t i = 1; i < times.size(); ++i) {
    model.observe(a.value[i], times[i], here);
    model.observe(b.value[i], times[i], there);
  }
  return distance(Value(std::move(here)), Value(std::move(there)));
}

}  // namespace

template <std::size_t n>
bool IntegratedInFloat<n>::has(std::string_view algorithm) const {
  return exact_->guard_count() == 0 && ode::in_float<n>(algorithm) != nullptr;
}

template <std::size_t n>
auto IntegratedInFloat<n>::widened(std::string_view algorithm, double setting) const -> Motion<n> {
  const auto motion = (*ode::in_float<n>(algorithm))(system(), start(), horizon().times(), setting);
  Motion<n> widened{{}, motion.evaluations, motion.error_estimate, 0, motion.ending, motion.message};
  for (const std::array<float, n>& x : motion.value) {
    widened.value.emplace_back();
    std::ranges::copy(x, widened.value.back().begin());
  }
  return widened;
}

template <std::size_t n>
Answer IntegratedInFloat<n>::run(std::string_view algorithm, double setting) const {
  Answer answer = exact_->observed(horizon().times(), widened(algorithm, setting));
  if (answer.reached() && answer.drift > another_motion)
    answer.comes_back = exact_->comes_back(algorithm, horizon().times(), setting);
  return answer;
}

template <std::size_t n>
Value IntegratedInFloat<n>::places_and_rates(std::string_view algorithm, double setting) const {
  return exact_->places_and_rates(horizon().times(), widened(algorithm, setting).value);
}

template <std::size_t n>
double IntegratedInFloat<n>::off_constraint(std::string_view algorithm, double setting) const {
  return exact_->off_constraint(horizon().times(), widened(algorithm, setting).value);
}

template <std::size_t n>
double IntegratedInFloat<n>::roundings(double setting) const {
  const double frame = horizon().end / horizon().count();
  return measured().at_most(horizon().count() * std::ceil(frame / setting));
}

template <std::size_t n>
Roundings IntegratedInFloat<n>::measure() const {
  const auto times = horizon().times();
  const auto start = exact_->start();
  const Motion<n> motion = accurate(*exact_, start, times);
  Roundings most{apart(*exact_, motion, accurate(*rounded_, rounded_->start(), times), times)};
  for (std::size_t i = 0; i < n; ++i) {
    double size = 0;
    for (const auto& x : motion.value) size = std::max(size, std::abs(x[i]));
    auto beside = start;
    beside[i] += unit_roundoff<float> * size;
    most.of_each_step += apart(*exact_, motion, accurate(*exact_, beside, times), times);
  }
  return most;
}

#define ODDITY_IN_FLOAT(n, type) template class type<n>;
ODDITY_FOR_UNKNOWNS(ODDITY_IN_FLOAT, IntegratedInFloat)

void add_in_float(Quantity& motion, const std::vector<std::string_view>& names,
                  const std::vector<std::shared_ptr<const ModelInFloat>>& models, Outcome at_finest) {
  if (names.size() != models.size()) throw std::logic_error(motion.name + ": not one name for each model");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t before = motion.methods_in_float.size();
    for (const Method& m : motion.methods) {
      const bool by_any = m.model == names[i] && models[i]->has(m.algorithm);
      if (!by_any && m.model + ", " + m.algorithm != names[i]) continue;
      Method single{m.model, in_float(m.algorithm), m.resolution,
                    [model = models[i], algorithm = m.algorithm](double setting) {
                      return model->run(algorithm, setting);
                    }};
      single.precision = Precision::in_float;
      single.state_size = m.state_size;
      single.places_and_rates = [model = models[i], algorithm = m.algorithm](double setting) {
        return model->places_and_rates(algorithm, setting);
      };
      if (models[i]->constrained())
        single.off_constraint = [model = models[i], algorithm = m.algorithm](double setting) {
          return model->off_constraint(algorithm, setting);
        };
      single.roundings = [model = models[i]](double setting) { return model->roundings(setting); };
      motion.add(std::move(single));
    }
    if (!names[i].empty() && motion.methods_in_float.size() == before)
      throw std::logic_error(motion.name + " has no '" + std::string(names[i]) + "' to compute in float");
  }
  if (at_finest == Outcome::ok) return;
  const std::string algorithm = in_float("Runge-Kutta 4");
  const auto richest = std::ranges::find(motion.methods_in_float.rbegin(), motion.methods_in_float.rend(),
                                         algorithm, &Method::algorithm);
  if (richest == motion.methods_in_float.rend())
    throw std::logic_error(motion.name + " has no Runge-Kutta 4 in float");
  const double finest = richest->resolution.settings.back();
  const std::string model = richest->model;
  motion.add(Breakdown{"In float, Runge-Kutta 4 misses the need at its finest step.",
                       model + ", " + algorithm, finest, at_finest, model + ", Runge-Kutta 4", finest});
}

}  // namespace oddity::detail
