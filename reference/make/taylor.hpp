#pragma once

#ifdef ODDITY_BALLS
#include "reference/enclosures/motion.hpp"
#else
#include <vector>

#include "reference/make/motions.hpp"
#include "reference/make/recorded.hpp"

/// Initial value problems by Taylor series in high precision.
namespace oddity::truth {

/// Budget of expansions for one solution: some ten seconds of work.
constexpr long most_expansions = 6'000;

/// An initial value problem recorded on a tape: rhs(x, t) returns the derivatives of x.
class TaylorProblem {
 public:
  template <class Rhs>
  TaylorProblem(const Rhs& rhs, std::size_t dimension) {
    recorded_.record(rhs, dimension);
  }

  /// The state at t1 from the state at t0, with each step's remainder below 10^-digits. Throws
  /// std::runtime_error if a pole stops it, BudgetSpent if it needs more expansions.
  Numbers solve(Numbers x, Number t0, const Number& t1, int digits, long budget = most_expansions);

  /// One step of a motion: its polynomials about t0, valid for |t - t0| <= length.
  struct Step {
    Number t0, length;
    std::vector<Numbers> series;  ///< one per unknown, from order 0 on
    Numbers at(const Number& t) const;
  };
  /// The longest step from (x, t) towards t1 whose remainder is below 10^-digits. Throws like `solve`.
  Step step(const Numbers& x, const Number& t, const Number& t1, int digits);

 private:
  Recorded recorded_;
};

/// A motion by the polynomials of its steps.
class TaylorPath final : public Path {
 public:
  TaylorPath(TaylorProblem problem, Numbers x0, Number t0, int digits)
      : problem_(std::move(problem)), x_(std::move(x0)), t_(std::move(t0)), digits_(digits) {}

  /// The state at t; integrates further if necessary. Throws BudgetSpent.
  Numbers at(const Number& t, const Motions& request);

 private:
  TaylorProblem problem_;
  Numbers x_;  ///< the state at the end of the last step, t_
  Number t_;
  int digits_;
  std::vector<TaylorProblem::Step> steps_;
};

/// rhs(const std::vector<T>& x, const T& t) -> std::vector<T>, for T = Number and T = Jet.
template <class Rhs>
Numbers solve_taylor(const Rhs& rhs, const Numbers& x0, const Number& t0, const Number& t1,
                     Precision precision) {
  const int digits = precision.digits;
  if (!precision.kept) return TaylorProblem(rhs, x0.size()).solve(x0, t0, t1, digits);
  auto& path = precision.kept->path(typeid(Rhs), x0, t0, t1, digits, [&] {
    return std::make_unique<TaylorPath>(TaylorProblem(rhs, x0.size()), x0, t0, digits);
  });
  return path.at(t1, *precision.kept);
}

}  // namespace oddity::truth
#endif
