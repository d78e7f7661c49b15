#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chapters/02_basic_concepts/shared/limits.hpp"
#include "chapters/claims.hpp"

/// Claims of limits at zero.
namespace oddity::limits {

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
