#include "reference/make/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "reference/text.hpp"
#include "solvers/stop.hpp"

namespace oddity::truth {

namespace {

using Rhs = std::function<Numbers(const Numbers& x, const Number& t)>;

/// The modified midpoint rule (Gragg) over one big step in n substeps, n even. Its error has only even
/// powers.
Numbers modified_midpoint(const Rhs& rhs, const Numbers& x0, const Number& t, const Number& big, int n) {
  const Number h = big / n;
  const auto move = [](Numbers& x, const Number& by, const Numbers& v) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * v[i];
  };
  Numbers before = x0, now = x0;
  move(now, h, rhs(x0, t));
  for (int k = 1; k < n; ++k) {
    check_stop_at_times();
    move(before, 2 * h, rhs(now, Number(t + k * h)));
    swap(before, now);
  }
  move(before, h, rhs(now, Number(t + big)));
  for (std::size_t i = 0; i < now.size(); ++i) before[i] = (before[i] + now[i]) / 2;
  return before;
}

/// With many digits a step should settle a few columns before the last. A step that does not settle costs as
/// much as one that does (measured on a pendulum at 26 to 50 digits). In long double it should settle early,
/// as every column adds its roundings (measured on Foucault's pendulum over ten minutes).
constexpr bool has_many_digits = std::numeric_limits<Number>::digits10 > 30;
constexpr int columns = has_many_digits ? 24 : 12, wanted = has_many_digits ? 21 : 8;

/// The smallest change at which a state of this size can settle.
Number roundings(const Numbers& x) {
  Number size = 0;
  for (const Number& component : x) size = std::max<Number>(size, abs(component));
  return 256 * std::numeric_limits<Number>::epsilon() * size;
}

/// One big step, extrapolated to zero substep (Aitken-Neville in h^2), until the change is within the
/// tolerance or the roundings. Returns the column at which it settled; columns + 1 if it did not.
/// count(n) is called before n right-hand sides.
template <class Count>
int extrapolated_step(const Rhs& rhs, const Count& count, Numbers& x, const Number& t, const Number& big,
                      const Number& tolerance) {
  const Number enough = std::max(tolerance, roundings(x));
  std::vector<Numbers> row;
  Numbers before;
  for (int k = 1; k <= columns; ++k) {
    count(2 * k + 1);
    Numbers best = modified_midpoint(rhs, x, t, big, 2 * k);
    for (int j = 1; j < k; ++j) {
      const Number ratio = Number(k) / (k - j), less = ratio * ratio - 1;
      Numbers& above = row[static_cast<std::size_t>(j - 1)];
      for (std::size_t i = 0; i < x.size(); ++i) {
        const Number better = best[i] + (best[i] - above[i]) / less;
        above[i] = best[i];
        best[i] = better;
      }
    }
    if (k > 3) {
      bool settled = true;  // false for a NaN
      for (std::size_t i = 0; i < x.size(); ++i) settled = settled && abs(best[i] - before[i]) <= enough;
      if (settled) {
        x = std::move(best);
        return k;
      }
    }
    before = best;
    row.push_back(std::move(best));
  }
  return columns + 1;
}

Number next_step(const Number& step, int settled_at) {
  return settled_at > columns ? Number(step / 2) : Number(step * std::pow(1.1, wanted - settled_at));
}

}  // namespace

namespace {

Number first_step(const Number& t0, const Number& t1) { return (t1 - t0) / 4; }

/// Counted right-hand sides.
struct Budget {
  long all, spent = 0;
};

/// `big` is the step to try first, and afterwards the one to continue with.
Numbers advance(const Rhs& rhs, Numbers x, Number t0, const Number& t1, int digits, Budget& budget,
                Number& big) {
  const Number tolerance = pow(Number(10), -digits - 3);
  const auto count = [&](int evaluations) {
    if ((budget.spent += evaluations) > budget.all)
      throw BudgetSpent(
          "extrapolation: the budget of " + std::to_string(budget.all) +
          " right-hand sides is spent at t = " + format_significant(static_cast<double>(t0), 6) + " of " +
          format_significant(static_cast<double>(t1), 6));
  };
  while (t0 != t1) {
    const bool last = abs(big) >= abs(Number(t1 - t0));
    const Number step = last ? Number(t1 - t0) : big;
    const int settled_at = extrapolated_step(rhs, count, x, t0, step, tolerance);
    if (settled_at <= columns) t0 = last ? t1 : Number(t0 + step);
    const Number next = next_step(step, settled_at);
    if (!last || settled_at > columns || abs(next) > abs(big)) big = next;
    if (abs(big) < pow(Number(10), -20)) throw std::runtime_error("extrapolation: the step became too small");
  }
  return x;
}

}  // namespace

Numbers solve_extrapolation(const Rhs& rhs, Numbers x, Number t0, const Number& t1, int digits, long budget) {
  Budget counted{budget};
  Number big = first_step(t0, t1);
  return advance(rhs, std::move(x), std::move(t0), t1, digits, counted, big);
}

namespace {

/// Budget of right-hand sides for a motion that nobody watches: some twenty seconds of work.
constexpr long most_of_a_motion = 1'000'000;

/// A motion by its states at the requested times.
struct ExtrapolatedPath : Path {
  struct State {
    Number t;
    Numbers x;
  };
  std::vector<State> known;
  Budget budget;
  Number big = 0;

  ExtrapolatedPath(const Numbers& x0, const Number& t0, long evaluations)
      : known{{t0, x0}}, budget{evaluations} {}

  Numbers at(const Number& t, const Rhs& rhs, int digits) {
    const auto comes_before = [&](const State& s) { return abs(s.t - known[0].t) <= abs(t - known[0].t); };
    const State from = *std::ranges::find_if(known.rbegin(), known.rend(), comes_before);
    if (from.t == t) return from.x;
    if (big == 0) big = first_step(from.t, t);
    known.push_back({t, advance(rhs, from.x, from.t, t, digits, budget, big)});
    return known.back().x;
  }
};

}  // namespace

Numbers solve_extrapolation(const Rhs& rhs, const Numbers& x, const Number& t0, const Number& t1,
                            Precision precision) {
  const int digits = precision.digits;
  if (!precision.kept) return solve_extrapolation(rhs, x, t0, t1, digits);
  precision.kept->tick();
  return precision.kept
      ->path(rhs.target_type(), x, t0, t1, digits,
             [&] {
               return std::make_unique<ExtrapolatedPath>(x, t0,
                                                         most_of_a_motion * precision.kept->allowance());
             })
      .at(t1, rhs, digits);
}

}  // namespace oddity::truth
