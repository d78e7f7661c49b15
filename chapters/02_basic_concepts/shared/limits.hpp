#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"

/// Limits at zero, and concatenated numbers.
namespace oddity::limits {

/// Concatenates the numbers of all parts.
template <class... Parts>
Value joined(const Parts&... parts) {
  std::vector<double> all;
  const auto append = [&](const Value& part) { all.insert(all.end(), part.begin(), part.end()); };
  (append(Value(parts)), ...);
  return Value(std::move(all));
}

/// The limit of f(h), h -> 0, from f(h), f(h/2), ..., by Richardson extrapolation in all powers of h.
/// `error_estimate` is the last change plus the roundings amplified by the extrapolation's weights (sum of
/// absolute values below 9).
template <class F>
Solved<Value> limit_at_zero(const F& f, double h, int halvings) {
  Solved<Value> limit;
  std::vector<Value> row;
  for (int k = 0; k <= halvings; ++k) {
    std::vector<Value> next{f(std::ldexp(h, -k))};
    ++limit.evaluations;
    for (int j = 1; j <= k; ++j) {
      Value better = next.back();
      for (std::size_t i = 0; i < better.size(); ++i)
        better[i] += (better[i] - row[static_cast<std::size_t>(j - 1)][i]) / (std::ldexp(1.0, j) - 1);
      next.push_back(std::move(better));
    }
    if (k > 0)
      limit.error_estimate = distance(next.back(), row.back()) + 9 * 8 * 0x1p-52 * size_of(next.front());
    row = std::move(next);
  }
  limit.value = row.back();
  return limit;
}

}  // namespace oddity::limits
