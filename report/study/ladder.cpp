#include "report/study/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "report/study/frames.hpp"
#include "report/study/policy.hpp"
#include "solvers/ode/catalog.hpp"
#include "solvers/stop.hpp"

namespace oddity {

bool holds_with_margin(const Candidate& t, const Need& need) {
  return t.holds() && t.error <= 1 / need.margin();
}

bool came_to_an_end(const Candidate& candidate) {
  return candidate.outcome != Outcome::non_finite && candidate.outcome != Outcome::stalled &&
         candidate.outcome != Outcome::raised && candidate.outcome != Outcome::chattering &&
         candidate.outcome != Outcome::grazing;
}

namespace {

/// One more than the order, as errors of symmetric methods may fall. For a tolerance, more than proportional.
double most_power(const Method& method) {
  if (method.resolution.name == "tolerance") return 1.25;
  const std::string_view algorithm = without_stepping(method.algorithm);
  for (const ode::CatalogEntry& entry : ode::catalog())
    if (entry.order > 0 && (entry.name == algorithm || in_float(entry.name) == algorithm))
      return entry.order + 1;
  return std::numeric_limits<double>::infinity();
}

}  // namespace

Ladder::Ladder(const Method& method, const Need& need)
    : method_(&method), power_(most_power(method)), left_(settings(method, need)) {
  std::ranges::reverse(left_);
  is_over_ = left_.empty();
}

double Ladder::expected_evaluations() const {
  if (is_over_ || candidates.empty()) return 0;
  if (is_given_up()) return given_up_at_;
  const Candidate& last = candidates.back();
  if (last.resolution == "step") return last.evaluations_per_frame * last.setting / left_.back();
  if (candidates.size() < 2 || !(candidates.end()[-2].evaluations_per_frame > 0))
    return last.evaluations_per_frame;
  const Candidate& before = candidates.end()[-2];
  const double more = std::max(1.0, last.evaluations_per_frame / before.evaluations_per_frame);
  const double steps = std::log(last.setting / left_.back()) / std::log(before.setting / last.setting);
  return last.evaluations_per_frame * std::pow(more, steps);
}

double Ladder::expected_seconds(const Candidate& candidate) const {
  if (!std::isnan(candidate.seconds_per_frame)) return candidate.seconds_per_frame;
  double times = not_a_number, seconds = not_a_number;
  for (const Candidate& timed : candidates) {
    if (std::isnan(timed.seconds_per_frame)) continue;
    const double ratio = candidate.evaluations_per_frame / timed.evaluations_per_frame;
    const double apart = std::abs(std::log(ratio));
    if (times <= apart) continue;
    times = apart;
    seconds = ratio * timed.seconds_per_frame;
  }
  return seconds;
}

double Ladder::expected_seconds() const {
  const Candidate& last = candidates.back();
  return expected_seconds(last) * expected_evaluations() / last.evaluations_per_frame;
}

void Ladder::go_on(double most_evaluations, const std::vector<Start>& starts, const Need& need,
                   const std::vector<std::string>& hardest, double most_of_all) {
  hardest_ = hardest;
  const double limit = std::min(policy.far_more_work * most_evaluations, most_of_all);
  while (!is_over_ && expected_evaluations() <= most_evaluations && expected_evaluations() < most_of_all) {
    check_stop();
    if (is_given_up()) step_back();
    const bool is_limited = limit * need.frames() < static_cast<double>(ode::budget);
    candidates.push_back(
        evaluate_until_one_fails(order_of(starts), *method_, left_.back(), need, limit * need.frames()));
    left_.pop_back();
    const Candidate& last = candidates.back();
    given_up_at_ = is_limited && last.outcome == Outcome::stalled ? limit : 0;
    if (is_given_up()) return;
    if (!last.holds())
      skip_what_cannot_hold(need);
    else if (!skipped_.empty())
      look_among_skipped(starts, need);
    is_over_ = left_.empty() || holds_with_margin(candidates.back(), need) || hopeless(candidates.back()) ||
               (candidates.back().holds() && changed_nothing());
  }
}

/// True of a method that ignores its tolerance.
bool Ladder::changed_nothing() const {
  if (candidates.size() < 2) return false;
  const Candidate &last = candidates.back(), &before = candidates.end()[-2];
  return last.error == before.error && last.evaluations_per_frame == before.evaluations_per_frame;
}

/// Extrapolates the error: an error as large as the motion falls more slowly, unless its growth is known.
/// Keeps the finest setting otherwise.
void Ladder::skip_what_cannot_hold(const Need& need) {
  skipped_.clear();
  const Candidate& last = candidates.back();
  if (need.thorough || need.criterion != Criterion::path || !std::isfinite(last.error)) return;
  const auto cannot_hold = [&](double setting) {
    return last.unbounded_error * std::pow(setting / last.setting, power_) > policy.luck;
  };
  const bool is_deaf = changed_nothing();
  while (left_.size() > 1 && (is_deaf || cannot_hold(left_.back()))) {
    skipped_.push_back(left_.back());
    left_.pop_back();
  }
  const bool is_foreseen = last.resolution == "step" && last.unbounded_error > last.error;
  if (left_.size() == 1 && is_foreseen && cannot_hold(left_.back())) left_.clear();
}

void Ladder::look_among_skipped(const std::vector<Start>& starts, const Need& need) {
  Candidate holds = std::move(candidates.back());
  candidates.pop_back();
  std::vector<double> between = std::exchange(skipped_, {});
  while (!between.empty()) {
    check_stop();
    const auto middle = between.begin() + static_cast<std::ptrdiff_t>(between.size() / 2);
    Candidate tried = evaluate_until_one_fails(order_of(starts), *method_, *middle, need);
    if (tried.holds()) {
      left_.push_back(holds.setting);
      left_.insert(left_.end(), between.rbegin(), std::make_reverse_iterator(middle + 1));
      holds = std::move(tried);
      between.erase(middle, between.end());
    } else {
      candidates.push_back(std::move(tried));
      between.erase(between.begin(), middle + 1);
    }
  }
  candidates.push_back(std::move(holds));
}

Order Ladder::order_of(const std::vector<Start>& starts) const {
  std::vector<std::string> first = hardest_;
  const std::string own = candidates.empty() ? "" : candidates.back().where;
  if (own != starts.front().says) first.insert(first.begin(), own);
  return in_order(starts, first);
}

void Ladder::step_back() {
  left_.push_back(candidates.back().setting);
  candidates.pop_back();
  is_over_ = false;
  given_up_at_ = 0;
}

void Ladder::again(const Need& need) {
  skipped_.clear();
  const Found held = found(need);
  has_no_margin_ = has_no_margin_ || (is_over_ && !held.with_margin);
  while (held.first) {
    const bool was_first = &candidates.back() == held.first;
    step_back();
    if (was_first) break;
  }
}

Ladder::Found Ladder::found(const Need& need) {
  Found found;
  for (Candidate& t : candidates) {
    if (t.holds() && !found.first) found.first = &t;
    if (holds_with_margin(t, need)) found.with_margin = &t;  // no finer one is tried
    if (came_to_an_end(t) && (!found.best || t.error < found.best->error)) found.best = &t;
  }
  return found;
}

}  // namespace oddity
