#include "report/study/tries.hpp"

#include <algorithm>

namespace oddity {

bool holds_with_margin(const Tried& t, const Need& need) { return t.holds() && t.error <= 1 / need.margin(); }

bool came_to_an_end(const Tried& tried) {
  return tried.outcome != Outcome::non_finite && tried.outcome != Outcome::stalled &&
         tried.outcome != Outcome::raised && tried.outcome != Outcome::chattering &&
         tried.outcome != Outcome::grazing;
}

Tries::Tries(const Method& method, const Need& need) : method_(&method), left_(settings(method, need)) {
  std::ranges::reverse(left_);
  is_over_ = left_.empty();
}

double Tries::expected_evaluations() const {
  if (is_over_ || tried.empty()) return 0;
  const Tried& last = tried.back();
  return last.evaluations_per_frame * (last.knob == "step" ? last.setting / left_.back() : 1);
}

void Tries::go_on(double most_evaluations, const std::vector<Start>& starts, const Need& need,
                  const std::function<void()>& check) {
  while (!is_over_ && expected_evaluations() <= most_evaluations) {
    check();
    tried.push_back(attempt(starts, *method_, left_.back(), need, Over::until_one_fails));
    left_.pop_back();
    is_over_ = left_.empty() || holds_with_margin(tried.back(), need) || hopeless(tried.back());
  }
}

void Tries::again(const Need& need) {
  const Tried* first = found(need).first;
  while (first && !tried.empty()) {
    const bool was_first = &tried.back() == first;
    left_.push_back(tried.back().setting);
    tried.pop_back();
    is_over_ = false;
    if (was_first) break;
  }
}

Tries::Found Tries::found(const Need& need) {
  Found found;
  Tried* last = nullptr;
  for (Tried& t : tried) {
    if (t.holds() && !found.first) found.first = &t, found.before = last;
    if (holds_with_margin(t, need) && !found.with_margin) found.with_margin = &t;
    if (came_to_an_end(t) && (!found.best || t.error < found.best->error)) found.best = &t;
    last = came_to_an_end(t) ? &t : nullptr;
  }
  return found;
}

}  // namespace oddity
