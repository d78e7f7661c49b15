#pragma once

#include <string>

#include "chapters/exercise.hpp"
#include "reference/reference.hpp"

/// References for quantities without a table: marked as not independent of the methods that they judge.
namespace oddity {

/// A value from a formula. `error` bounds its roundings.
inline Known closed_form(const Value& value, double error) {
  return {{value.begin(), value.end()}, error, "closed form, not independent"};
}

/// The value of the finest affordable run. `error` is the difference from a run of half its cost. A run that
/// did not reach its end gives no value.
inline Known finest_run(const Answer& answer, double error, const std::string& method) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> value(answer.value.begin(), answer.value.end());
  if (!answer.reached()) value.assign(1, nan);
  return {value, answer.reached() ? error : nan, "finest run of " + method + ", not independent"};
}

}  // namespace oddity
