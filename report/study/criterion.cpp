#include "report/study/criterion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/study/results.hpp"

namespace oddity {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The components at one time.
std::span<const double> at_time(const Value& value, int samples, int k) {
  const std::size_t parts = value.size() / static_cast<std::size_t>(samples);
  return {&*value.begin() + static_cast<std::size_t>(k) * parts, parts};
}

/// The energies at all times; none if the motion did not reach its end.
std::vector<Energy> energies(const Quantity& motion, const Value& places_and_rates) {
  const std::size_t least = 2 * motion.reference.value.size();
  if (places_and_rates.size() < least || !finite(places_and_rates)) return {};
  std::vector<Energy> all;
  for (int k = 0; k < motion.samples; ++k)
    all.push_back(motion.energy(at_time(places_and_rates, motion.samples, k)));
  return all;
}

std::vector<Energy> energies(const Quantity& motion, const Method& method, double setting) {
  return method.places_and_rates ? energies(motion, method.places_and_rates(setting)) : std::vector<Energy>();
}

/// The largest difference of energies; infinite for NaN.
double apart(const std::vector<Energy>& some, const std::vector<double>& others) {
  if (some.size() != others.size()) return infinite;
  double most = 0;
  for (std::size_t k = 0; k < some.size(); ++k) {
    const double off = std::abs(some[k].whole - others[k]);
    if (!(off <= most)) most = std::isnan(off) ? infinite : off;
  }
  return most;
}

double as_part(double off, double moves) { return off == 0 ? 0 : moves > 0 ? off / moves : infinite; }

double energy_off(const Quantity& motion, const Method& method, double setting, const TrueEnergy& truth) {
  const double off = as_part(apart(energies(motion, method, setting), truth.whole), truth.moves);
  return std::max(off, truth.known_to);
}

double mean_of_first(const Quantity& motion) {
  double mean = 0;
  for (int k = 0; k < motion.samples; ++k)
    mean += at_time(motion.reference.value, motion.samples, k)[0] / motion.samples;
  return mean;
}

/// The mean time between the first observable's upward passages through a height, in frames; NaN for fewer
/// than two.
double period(const Value& value, int samples, double height) {
  double first = not_a_number, last = not_a_number;
  int passages = 0;
  for (int k = 1; k < samples; ++k) {
    const double before = at_time(value, samples, k - 1)[0] - height,
                 now = at_time(value, samples, k)[0] - height;
    if (!(before < 0 && now >= 0)) continue;
    last = k - now / (now - before);
    if (++passages == 1) first = last;
  }
  return passages < 2 ? not_a_number : (last - first) / (passages - 1);
}

/// The first observable's largest distance from a height in the second half of the time.
double swing_in_the_end(const Value& value, int samples, double height) {
  double most = 0;
  for (int k = samples / 2; k < samples; ++k)
    most = std::max(most, std::abs(at_time(value, samples, k)[0] - height));
  return most;
}

Off period_off(const Quantity& motion, const Value& value) {
  constexpr double as_large = 1.1;
  const double mean = mean_of_first(motion),
               true_period = period(motion.reference.value, motion.samples, mean);
  if (std::isnan(true_period))
    throw BadInput("the motion has no two periods within the horizon: ask for a longer one");
  const double swing = swing_in_the_end(value, motion.samples, mean) /
                       swing_in_the_end(motion.reference.value, motion.samples, mean);
  if (!(swing <= as_large && swing >= 1 / as_large))
    return {infinite, "its swing is " + format_significant(swing, 2) + " times the true one in the end"};
  return {std::abs(period(value, motion.samples, mean) / true_period - 1)};
}

double constraint_off(const Quantity& motion, const Value& value) {
  double most = 0;
  for (int k = 0; motion.off && k < motion.samples; ++k) {
    const double off = motion.off(at_time(value, motion.samples, k), k);
    if (!(off <= most)) most = off;
    if (std::isnan(most)) break;
  }
  return most;
}

/// An algorithm's motion, by the model that stays nearest to the truth.
struct Followed {
  double error = infinite;
  std::vector<Energy> energies = {};  ///< empty: no model reaches the end
};

Followed followed_by(std::string_view algorithm, const Quantity& motion) {
  constexpr double fine = 1e-13;
  Followed best;
  for (const Method& m : motion.methods) {
    if (m.algorithm != algorithm || !m.places_and_rates) continue;
    const double setting = m.resolution.name == tolerances().name ? fine : m.resolution.settings.back();
    const Trial trial = run(motion, m, setting);
    if (!trial.answer.reached() || !(trial.error < best.error)) continue;
    if (auto at = energies(motion, m, setting); !at.empty()) best = {trial.error, std::move(at)};
  }
  return best;
}

/// The motion by each algorithm that reaches the end: by the accurate ones, or by all if fewer than two of
/// those do, as in a scene of few methods.
std::vector<Followed> followed(const Quantity& motion) {
  constexpr std::array close = {"Fehlberg 7(8)", "GSL rk8pd", "Dormand-Prince 5(4)", "Bulirsch-Stoer",
                                "Cash-Karp 5(4)"};
  std::vector<Followed> all;
  const auto follow = [&](std::string_view algorithm) {
    if (Followed by = followed_by(algorithm, motion); !by.energies.empty()) all.push_back(std::move(by));
  };
  std::ranges::for_each(close, follow);
  if (all.size() >= 2) return all;
  std::set<std::string_view> others;
  for (const Method& m : motion.methods)
    if (std::ranges::find(close, m.algorithm) == close.end()) others.insert(m.algorithm);
  std::ranges::for_each(others, follow);
  return all;
}

std::vector<double> totals(const std::vector<Energy>& energies) {
  std::vector<double> all;
  for (const Energy& now : energies) all.push_back(now.whole);
  return all;
}

}  // namespace

bool needs_energy(const Need& need) {
  return need.criterion == Criterion::energy || need.also.contains(Criterion::energy);
}

TrueEnergy true_energy(const Quantity& motion) {
  if (!motion.energy) throw BadInput("the observables of this motion do not determine an energy");
  std::vector<Followed> all = followed(motion);
  if (all.size() < 2)
    throw BadInput("no two methods here follow the motion's energy to the end of the horizon");
  std::ranges::partial_sort(all, all.begin() + 2, {}, &Followed::error);
  const Followed &best = all[0], &other = all[1];
  TrueEnergy energy{totals(best.energies)};
  for (const Energy& now : best.energies) energy.moves = std::max(energy.moves, std::abs(now.kinetic));
  const double apart_by = as_part(apart(other.energies, energy.whole), energy.moves);
  energy.known_to = std::max(std::numeric_limits<double>::epsilon(), apart_by);
  return energy;
}

Off off_by_observed(Criterion criterion, const Quantity& motion, const Value& observed,
                    const std::vector<double>& errors) {
  if (!finite(observed) || observed.size() != motion.reference.value.size()) return {infinite};
  Off off{infinite};
  switch (criterion) {
    case Criterion::path:
      off.error = motion.in_needs(errors);
      break;
    case Criterion::energy:
      break;
    case Criterion::bounded:
      off.error = size_of(observed) / (10 * size_of(motion.reference.value));
      break;
    case Criterion::constraint:
      off.error = constraint_off(motion, observed);
      break;
    case Criterion::period:
      off = period_off(motion, observed);
      break;
  }
  if (std::isnan(off.error)) off.error = infinite;
  return off;
}

Off off_by(Criterion criterion, const Quantity& motion, const Method& method, const Trial& trial,
           const std::vector<double>& errors, const TrueEnergy* energy) {
  if (!trial.answer.reached()) return {infinite};
  Off off = off_by_observed(criterion, motion, trial.answer.value, errors);
  if (criterion == Criterion::energy && energy)
    off.error = energy_off(motion, method, trial.setting, *energy);
  if (criterion == Criterion::constraint && method.off_constraint && std::isfinite(off.error)) {
    const double redundant = method.off_constraint(trial.setting);
    off.error = std::isnan(redundant) ? infinite : std::max(off.error, redundant);
  }
  return off;
}

std::vector<Criterion> criteria_of(const Need& need) {
  std::vector<Criterion> all{need.criterion};
  for (const auto& [criterion, error] : need.also) all.push_back(criterion);
  return all;
}

bool has_period(const Quantity& motion) {
  return !std::isnan(period(motion.reference.value, motion.samples, mean_of_first(motion)));
}

bool can_be_judged(Criterion criterion, const Quantity& motion, const Method& method) {
  switch (criterion) {
    case Criterion::energy:
      return motion.energy && method.places_and_rates;
    default:
      return true;
  }
}

double rounding_of(Criterion criterion, const Quantity& motion) {
  constexpr double roundings = 64 * std::numeric_limits<double>::epsilon();
  return criterion == Criterion::constraint ? roundings * size_of(motion.reference.value) : 0;
}

}  // namespace oddity
