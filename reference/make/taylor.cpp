#include "reference/make/taylor.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/text.hpp"
#include "solvers/stop.hpp"

namespace oddity::truth {

namespace {

/// The step that the last quarter of the terms allows for a remainder of 10^-digits: fewer terms might all
/// vanish, as for exp(t^5) about zero.
Number length_of(const std::vector<Numbers>& series, int order, int digits) {
  double growth = -std::numeric_limits<double>::infinity();  // log of the coefficients' growth per order
  for (int k = order - order / 4; k <= order; ++k) {
    Number largest = 0;
    for (const Numbers& one : series)
      largest = std::max<Number>(largest, abs(one[static_cast<std::size_t>(k)]));
    if (largest > 0) growth = std::max(growth, static_cast<double>(log(largest)) / k);
  }
  return Number(0.9 * std::exp(-digits * std::numbers::ln10 / order - growth));
}

}  // namespace

TaylorProblem::Step TaylorProblem::step(const Numbers& x, const Number& t, const Number& t1, int digits) {
  check_stop();
  const int order = digits + digits / 4 + 4;
  recorded_.expand(x, t, order);
  Step step{t, 0, recorded_.series()};
  step.length = length_of(step.series, order, digits + 4);
  if (step.length < abs(Number(t1 - t)) * 1e-20)
    throw std::runtime_error("Taylor series: the step became too small");
  return step;
}

Numbers TaylorProblem::Step::at(const Number& t) const {
  const Number h = t - t0;
  Numbers x;
  x.reserve(series.size());
  for (const Numbers& c : series) {
    Number sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;) sum = sum * h + c[k];
    x.push_back(sum);
  }
  return x;
}

namespace {

void require_budget(long spent, long budget, const Number& t, const Number& t1) {
  if (spent >= budget)
    throw BudgetSpent("Taylor series: the budget of " + std::to_string(budget) +
                      " expansions of the right-hand side is spent at t = " +
                      format_significant(static_cast<double>(t), 6) + " of " +
                      format_significant(static_cast<double>(t1), 6));
}

}  // namespace

Numbers TaylorProblem::solve(Numbers x, Number t0, const Number& t1, int digits, long budget) {
  for (long spent = 0; t0 != t1; ++spent) {
    require_budget(spent, budget, t0, t1);
    const Step next = step(x, t0, t1, digits);
    const Number left = t1 - t0;
    const bool last = abs(left) <= next.length;
    const Number end = last ? t1 : left > 0 ? Number(t0 + next.length) : Number(t0 - next.length);
    x = next.at(end);
    t0 = end;
  }
  return x;
}

Numbers TaylorPath::at(const Number& t, const Motions& request) {
  const Number start = steps_.empty() ? t_ : steps_.front().t0;
  while (steps_.empty() || abs(t - start) > abs(t_ - start)) {
    request.tick();
    require_budget(static_cast<long>(steps_.size()), most_expansions * request.allowance(), t_, t);
    steps_.push_back(problem_.step(x_, t_, t, digits_));
    const Number& length = steps_.back().length;
    t_ = t > start ? Number(t_ + length) : Number(t_ - length);
    x_ = steps_.back().at(t_);
  }
  const auto begins_before = [&](const TaylorProblem::Step& step) {
    return abs(step.t0 - start) <= abs(t - start);
  };
  return std::prev(std::ranges::partition_point(steps_, begins_before))->at(t);
}

}  // namespace oddity::truth
