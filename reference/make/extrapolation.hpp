#pragma once

#include <functional>

#include "reference/make/motions.hpp"

/// Initial value problems by extrapolation of the modified midpoint rule in high precision.
namespace oddity::truth {

/// Budget of right-hand sides for one solution: some twenty seconds of work.
constexpr long most_evaluations = 4'000'000;

/// The state at t1 from the state at t0, with every step settled to 10^-(digits + 3). Throws
/// std::runtime_error if the step becomes too small, BudgetSpent if it needs more right-hand sides.
Numbers solve_extrapolation(const std::function<Numbers(const Numbers& x, const Number& t)>& rhs, Numbers x,
                            Number t0, const Number& t1, int digits, long budget = most_evaluations);

/// The state of a motion that may be requested at many times: continues from the last requested one.
Numbers solve_extrapolation(const std::function<Numbers(const Numbers& x, const Number& t)>& rhs,
                            const Numbers& x, const Number& t0, const Number& t1, Precision);

}  // namespace oddity::truth
