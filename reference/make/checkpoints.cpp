#include "reference/make/checkpoints.hpp"

#include <cmath>

namespace oddity::truth {

namespace {

constexpr std::size_t most_motions = 1000;

}  // namespace

std::shared_ptr<Checkpoints::Motion> Checkpoints::find(const std::vector<double>& motion) {
  const std::lock_guard lock(mutex_);
  if (motions_.size() >= most_motions) motions_.clear();
  auto& found = motions_[motion];
  if (!found) found = std::make_shared<Motion>();
  return found;
}

Numbers Checkpoints::state(std::size_t k, const std::vector<double>& motion,
                           const std::function<Numbers()>& start,
                           const std::function<Numbers(const Numbers& x, std::size_t k)>& next) {
  const auto found = find(motion);
  const std::lock_guard lock(found->mutex);
  auto& states = found->states;
  if (states.empty()) states.push_back(start());
  while (states.size() <= k) states.push_back(next(states.back(), states.size()));
  return states[k];
}

Numbers Checkpoints::at(
    double t, Precision precision, const std::vector<double>& motion, const std::function<Numbers()>& start,
    const std::function<Numbers(const Numbers& x, const Number& t0, const Number& t1)>& advance) {
  if (precision.kept) return advance(start(), 0, Number(t));
  const double whole = std::floor(t);
  const Numbers x =
      state(static_cast<std::size_t>(whole), motion, start,
            [&](const Numbers& before, std::size_t k) { return advance(before, Number(k - 1), Number(k)); });
  return t == whole ? x : advance(x, Number(whole), Number(t));
}

}  // namespace oddity::truth
