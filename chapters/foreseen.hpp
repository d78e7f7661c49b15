#pragma once

#include <limits>
#include <string>
#include <utility>

#include "chapters/exercise.hpp"

/// Expected outcomes that are computed from the parameters.
namespace oddity {

/// An error before it is computed: a likely size, and bounds.
struct Estimate {
  double least, likely, most;
};
inline Estimate within_factor(double factor, double error) { return {error / factor, error, error * factor}; }

struct Foreseen {
  Outcome outcome;
  bool is_sure = true;  ///< otherwise roundings or chance may decide
};

/// Ok below the need, diverged above ten times the size of the true value, otherwise inaccurate.
inline Foreseen foreseen(const Estimate& error, double need,
                         double size = std::numeric_limits<double>::infinity()) {
  const auto outcome = [&](double e) {
    return e < need ? Outcome::ok : e > 10 * size ? Outcome::diverged : Outcome::inaccurate;
  };
  return {outcome(error.likely), error.least <= error.most && outcome(error.least) == outcome(error.most)};
}

/// The method with this expected outcome, and the reason if it fails.
inline Method expecting(const Foreseen& expected, std::string why, Method method) {
  method.expected = expected.outcome;
  method.why = expected.outcome == Outcome::ok ? "" : std::move(why);
  method.for_own_parameters = !expected.is_sure;
  return method;
}

/// The method with an outcome that is known at the exercise's own parameters alone: at others chance decides.
inline Method left_to_chance(Method method) {
  method.for_own_parameters = true;
  return method;
}

}  // namespace oddity
