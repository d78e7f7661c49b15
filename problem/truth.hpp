#pragma once

#include <span>
#include <string>
#include <vector>

#include "problem/model.hpp"

/// True motions, by two routes in long double that share the right-hand side and no algorithm: Taylor series
/// of its operations, and extrapolation of the modified midpoint rule. Both find where a choice changes or an
/// event happens, and begin anew there.
namespace oddity::problem {

struct TrueMotion {
  std::vector<std::vector<long double>> states;  ///< at the times that were reached
  std::string trouble = {};                      ///< why not at all; empty: at all
};

constexpr long most_steps = 100'000;

/// The first of the ascending times is the start's.
TrueMotion by_series(const Numbers&, std::span<const double> times);
/// The same in at most so many steps.
TrueMotion by_series_within(const Numbers&, std::span<const double> times, long most);
TrueMotion by_extrapolation(const Numbers&, std::span<const double> times);

}  // namespace oddity::problem
