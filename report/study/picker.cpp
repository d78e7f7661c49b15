#include "report/study/picker.hpp"

#include <algorithm>
#include <ranges>
#include <tuple>

#include "chapters/scene.hpp"
#include "report/study/frames.hpp"
#include "report/study/policy.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

/// Place of an algorithm in the catalog, which begins with the simplest; 0: a closed form.
std::size_t simplicity(std::string_view algorithm) {
  const std::string_view plain = without_stepping(algorithm);
  const auto all = ode::catalog();
  const auto found = std::ranges::find_if(all, [&](const ode::CatalogEntry& entry) {
    return entry.name == plain || in_float(entry.name) == plain;
  });
  return found == all.end() ? 0 : 1 + static_cast<std::size_t>(found - all.begin());
}

bool is_simple(std::string_view resolution, std::string_view algorithm) {
  return (resolution.empty() || resolution == "step") && !is_multistep(algorithm);
}
bool is_simple(const Candidate& t) { return is_simple(t.resolution, t.algorithm); }

bool ties_with(const Candidate& t, const Candidate& fastest) {
  if (t.seconds_per_frame <= fastest.seconds_per_frame) return true;  // equal times, also 0 and infinity
  const double times = t.seconds_per_frame / fastest.seconds_per_frame;
  return times <= policy.near_tie ||
         (times <= policy.noisy_tie &&
          t.seconds_per_frame - t.spread <= fastest.seconds_per_frame + fastest.spread);
}

}  // namespace

bool is_multistep(std::string_view algorithm) {
  const std::string_view plain = without_stepping(algorithm);
  return std::ranges::any_of(ode::catalog(), [&](const ode::CatalogEntry& entry) {
    return entry.history && (entry.name == plain || in_float(entry.name) == plain);
  });
}

bool have_same_cost(const Candidate& a, const Candidate& b) { return ties_with(a, b) && ties_with(b, a); }

bool Picker::is_faulted(std::string_view model) const {
  return std::ranges::find(scene_.faulted, model) != scene_.faulted.end();
}

bool Picker::meets_objective(const Candidate& t) const {
  return t.holds() && !is_faulted(t.model) &&
         (need_.objective == Objective::cheapest || (is_simple(t) && holds_with_margin(t, need_)));
}

bool Picker::may_meet_objective(const Ladder& ladder) const {
  const Method& m = ladder.method();
  return ladder.may_hold_with_margin() &&
         (need_.objective == Objective::cheapest || is_simple(m.resolution.name, m.algorithm));
}

bool Picker::is_eligible(const Candidate& t, bool by_objective) const {
  return !is_faulted(t.model) && t.seconds_per_frame <= need_.budget &&
         (by_objective ? meets_objective(t) : t.holds());
}

Picked Picker::pick(const std::vector<Candidate>& all, bool by_objective) const {
  Picked picked{.by_objective = by_objective};
  const auto eligible = [&](const Candidate& t) { return is_eligible(t, by_objective); };
  const auto fastest = cheapest(all, eligible);
  if (!fastest) return picked;
  std::ranges::copy_if(all, std::back_inserter(picked.ties),
                       [&](const Candidate& t) { return eligible(t) && ties_with(t, *fastest); });
  const double error = std::ranges::min_element(picked.ties, {}, &Candidate::error)->error;
  const auto best = std::ranges::min_element(picked.ties, {}, [&](const Candidate& t) {
    return std::tuple(t.error > policy.as_accurate * error, !is_simple(t), simplicity(t.algorithm), t.error);
  });
  picked.chosen = *best;
  picked.ties.erase(best);
  return picked;
}

}  // namespace oddity
