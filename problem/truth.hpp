#pragma once

#include <span>
#include <string>
#include <vector>

#include "problem/model.hpp"

/// True motions by two routes in long double that share the right-hand side but no algorithm: Taylor series
/// of its operations, and extrapolation of the modified midpoint rule. Both locate changed choices and
/// events, and restart there.
namespace oddity::problem {

struct TrueMotion {
  std::vector<std::vector<long double>> states;  ///< at the times reached
  std::string trouble = {};                      ///< why not all were reached; empty: all were
};

constexpr long most_steps = 100'000;

/// The first of the ascending times is that of the initial condition.
TrueMotion by_series(const Numbers&, std::span<const double> times);
/// As `by_series`, in at most `most` steps.
TrueMotion by_series_within(const Numbers&, std::span<const double> times, long most);
TrueMotion by_extrapolation(const Numbers&, std::span<const double> times);

}  // namespace oddity::problem
