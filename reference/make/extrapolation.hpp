#pragma once

#include <functional>

#include "reference/make/motions.hpp"

/// Initial value problems by extrapolation of the modified midpoint rule in high precision.
namespace oddity::truth {

/// Right-hand sides that one solution may cost: some twenty seconds of work.
constexpr long most_evaluations = 4'000'000;

/// The state at t1 from the state at t0, every step settled to 10^-(digits + 3). Throws std::runtime_error
/// when the step becomes too small, BudgetSpent when it takes more right-hand sides.
Numbers solve_extrapolation(const std::function<Numbers(const Numbers& x, const Number& t)>& rhs, Numbers x,
                            Number t0, const Number& t1, int digits, long budget = most_evaluations);

/// The same where a motion may be asked for at many times: from the last of those asked for before.
Numbers solve_extrapolation(const std::function<Numbers(const Numbers& x, const Number& t)>& rhs,
                            const Numbers& x, const Number& t0, const Number& t1, Precision);

}  // namespace oddity::truth
