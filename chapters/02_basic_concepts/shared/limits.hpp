#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "chapters/claims.hpp"

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

/// Checks the text's limit of f(h), h -> 0, by Richardson extrapolation from the distance h. A limit of zero
/// is on the right.
template <class F>
Check limit(std::string what, const Value& said, double h, const F& f) {
  const auto found = limit_at_zero([&](double x) { return Value(f(x)); }, h, 10);
  const Route extrapolated{"Richardson's extrapolation from a distance", found.value};
  const bool zero = size_of(said) == 0;
  return {std::move(what),
          zero ? extrapolated : Route{"the value as it is written", said},
          zero ? Route{"zero", said} : extrapolated,
          {found.error_estimate + 0x1p-52, "the extrapolation's error estimate, and one rounding of 1"},
          1};
}

/// The limit of f(h), h -> 0, by Richardson extrapolation from a distance: a claim's only sample.
struct Limit {
  std::string from;
  Solved<Value> at_zero;

  template <class F>
  Limit(std::string from_, double h, const F& f)
      : from(std::move(from_)), at_zero(limit_at_zero([&](double x) { return Value(f(x)); }, h, 10)) {}
  double size() const { return 1; }
  Tolerance tolerance(double) const {
    return {at_zero.error_estimate + 0x1p-52, "the extrapolation's error estimate, and one rounding of 1"};
  }
  TypesetLetters typeset() const { return {{"h", 0}}; }
  std::string where() const { return from; }
};

/// Claims the limits of `what`. The text is $0$ or $x\to0$.
inline void tends(Claims& claims, std::string_view slug, int line, std::string says, const std::string& what,
                  const std::vector<Limit>& limits, const std::string& text) {
  claims.formula<Limit>(
      slug, line, std::move(says), limits,
      {.quantity = "the limit of " + what,
       .truth = {"Richardson's extrapolation from a distance",
                 [](const Limit& limit) { return limit.at_zero.value; }},
       .printed = {text},
       .changes_that_hold = text.ends_with(R"(\to0$)") ? "a multiple of zero is zero" : ""});
}

}  // namespace oddity::limits
