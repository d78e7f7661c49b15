#include "report/study/tries.hpp"

#include <algorithm>

#include "solvers/ode/catalog.hpp"

namespace oddity {

bool holds_with_margin(const Candidate& t, const Need& need) {
  return t.holds() && t.error <= 1 / need.margin();
}

bool came_to_an_end(const Candidate& candidate) {
  return candidate.outcome != Outcome::non_finite && candidate.outcome != Outcome::stalled &&
         candidate.outcome != Outcome::raised && candidate.outcome != Outcome::chattering &&
         candidate.outcome != Outcome::grazing;
}

Tries::Tries(const Method& method, const Need& need) : method_(&method), left_(settings(method, need)) {
  std::ranges::reverse(left_);
  is_over_ = left_.empty();
}

double Tries::expected_evaluations() const {
  if (is_over_ || candidates.empty()) return 0;
  if (is_given_up()) return given_up_at_;
  const Candidate& last = candidates.back();
  return last.evaluations_per_frame * (last.knob == "step" ? last.setting / left_.back() : 1);
}

void Tries::go_on(double most_evaluations, const std::vector<Start>& starts, const Need& need,
                  const std::function<void()>& check) {
  constexpr double far_more = 16;
  const double limit = far_more * most_evaluations;
  while (!is_over_ && expected_evaluations() <= most_evaluations) {
    check();
    if (is_given_up()) step_back();
    const bool is_limited = limit * need.frames() < static_cast<double>(ode::budget);
    const ode::EvaluationLimit limited(limit * need.frames());
    candidates.push_back(evaluate(starts, *method_, left_.back(), need, Over::until_one_fails));
    left_.pop_back();
    const Candidate& last = candidates.back();
    given_up_at_ = is_limited && last.outcome == Outcome::stalled ? limit : 0;
    is_over_ = !is_given_up() && (left_.empty() || holds_with_margin(last, need) || hopeless(last));
  }
}

void Tries::step_back() {
  left_.push_back(candidates.back().setting);
  candidates.pop_back();
  is_over_ = false;
  given_up_at_ = 0;
}

void Tries::again(const Need& need) {
  const Candidate* first = found(need).first;
  while (first && !candidates.empty()) {
    const bool was_first = &candidates.back() == first;
    step_back();
    if (was_first) break;
  }
}

Tries::Found Tries::found(const Need& need) {
  Found found;
  Candidate* last = nullptr;
  for (Candidate& t : candidates) {
    if (t.holds() && !found.first) found.first = &t, found.before = last;
    if (holds_with_margin(t, need) && !found.with_margin) found.with_margin = &t;
    if (came_to_an_end(t) && (!found.best || t.error < found.best->error)) found.best = &t;
    last = came_to_an_end(t) ? &t : nullptr;
  }
  return found;
}

}  // namespace oddity
