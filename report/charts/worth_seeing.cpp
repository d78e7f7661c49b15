// Selects the charts that are worth seeing, and the curves in them.

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "report/charts/chart_parts.hpp"

namespace oddity {

namespace {

constexpr std::size_t most_curves = 8;

/// Whether two points of the front look the same.
bool look_the_same(const Frame& frame, const TimedTrial& a, const TimedTrial& b) {
  return std::abs(std::log10(frame.x(a) / frame.x(b))) < 0.05 &&
         std::abs(std::log10(frame.y(a) / frame.y(b))) < 0.3;
}

/// The methods of the front's trials, preferable trials first. Of trials that look the same it takes one.
std::vector<std::size_t> methods_on_front(const QuantityResult& q, const Frame& frame, Cost kind) {
  const std::vector<bool> front = pareto_front(q, kind);
  std::vector<std::pair<const TimedTrial*, std::size_t>> seen;
  std::size_t trial = 0;
  for (std::size_t i = 0; i < q.methods.size(); ++i)
    for (const TimedTrial& t : q.methods[i].trials)
      if (front[trial++] && std::ranges::none_of(seen, [&](const auto& other) {
            return look_the_same(frame, t, *other.first);
          }))
        seen.emplace_back(&t, i);
  std::ranges::stable_sort(
      seen, [kind](const auto& a, const auto& b) { return preferable(*a.first, *b.first, kind); });
  std::vector<std::size_t> methods;
  for (const auto& [t, i] : seen) methods.push_back(i);
  return methods;
}

/// The best method of each key, in order of first appearance.
template <class Key>
std::vector<std::size_t> best_of_each(const QuantityResult& q, const std::vector<std::size_t>& among,
                                      Cost kind, const Key& key) {
  std::vector<std::size_t> best;
  for (std::size_t i : among) {
    const auto same = std::ranges::find_if(
        best, [&](std::size_t other) { return key(q.methods[other]) == key(q.methods[i]); });
    if (same == best.end())
      best.push_back(i);
    else if (preferable(best_of(q.methods[i], kind), best_of(q.methods[*same], kind), kind))
      *same = i;
  }
  return best;
}

}  // namespace

bool preferable(const TimedTrial& a, const TimedTrial& b, Cost kind) {
  const bool a_ok = a.outcome == Outcome::ok, b_ok = b.outcome == Outcome::ok;
  if (a_ok != b_ok) return a_ok;
  if (!a_ok) return a.error < b.error || (std::isfinite(a.error) && !std::isfinite(b.error));
  return std::pair(cost(a, kind), a.error) < std::pair(cost(b, kind), b.error);
}

const TimedTrial& best_of(const MethodResult& m, Cost kind) {
  return *std::ranges::min_element(
      m.trials, [kind](const TimedTrial& a, const TimedTrial& b) { return preferable(a, b, kind); });
}

std::vector<std::size_t> worth_seeing(const QuantityResult& q, Across across) {
  constexpr std::size_t most_of_front = 4;
  const Cost kind = cost_of(across);
  const Frame frame(q, across);
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < q.methods.size(); ++i)
    if (frame.shows(q.methods[i])) shown.push_back(i);
  if (shown.size() <= most_curves) return shown;
  std::vector<std::size_t> wanted;
  if (across != Across::setting) wanted = methods_on_front(q, frame, kind);
  if (wanted.size() > most_of_front) wanted.resize(most_of_front);
  const auto append = [&](const std::vector<std::size_t>& more) {
    wanted.insert(wanted.end(), more.begin(), more.end());
  };
  append(best_of_each(q, shown, kind, [](const MethodResult& m) { return m.model; }));
  std::vector<std::size_t> good;
  for (std::size_t i : shown)
    if (family_of(q.methods[i].algorithm) != Family::none &&
        best_of(q.methods[i], kind).outcome == Outcome::ok)
      good.push_back(i);
  append(best_of_each(q, good, kind, [](const MethodResult& m) { return family_of(m.algorithm); }));
  std::set<std::size_t> chosen;
  for (std::size_t i : wanted)
    if (chosen.size() < most_curves) chosen.insert(i);
  return {chosen.begin(), chosen.end()};
}

bool has_chart(const QuantityResult& q) {
  std::set<double> errors;
  bool whole = true, curves = false;
  for (const MethodResult& m : q.methods) {
    curves |= m.trials.size() > 2;
    for (const TimedTrial& t : m.trials)
      if (std::isfinite(t.error)) {
        errors.insert(t.error);
        whole &= t.error == std::round(t.error);
      }
  }
  return curves && !whole && errors.size() > 3;
}

std::vector<Across> charts_of(const QuantityResult& q) {
  if (!has_chart(q)) return {};
  const auto with_resolution =
      std::ranges::count_if(q.methods, [](const auto& m) { return m.trials.size() > 1; });
  const auto varying = std::ranges::count_if(q.methods, [](const MethodResult& m) {
    return std::ranges::any_of(
        m.trials, [&](const TimedTrial& t) { return t.evaluations != m.trials.front().evaluations; });
  });
  const bool work_varies = 2 * varying >= with_resolution;
  if (!work_varies) return {Across::setting};
  const bool steps = q.trajectory && main_resolution(q) == "step";
  return steps ? std::vector{Across::evaluations, Across::setting, Across::time}
               : std::vector{Across::evaluations, Across::time};
}

}  // namespace oddity
