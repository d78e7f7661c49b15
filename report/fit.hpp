#pragma once

#include <optional>
#include <vector>

#include "report/results.hpp"

/// What the trials of a method say together: how its error follows its knob, and which trials no other beats.
namespace oddity {

/// error = factor * setting^exponent over the trials of the asymptotic range; for a knob that counts (panels,
/// points), error = factor * (1/setting)^exponent.
struct Fit {
  double exponent;
  double factor;
  std::size_t first, last;  ///< the trials fitted, both included
};

/// No error means anything below this: the reference's own error, or rounding.
double error_floor(const QuantityResult&);

/// The fit over the longest run of trials, the finest of equals, whose errors lie between ten times the floor
/// and the true value's size, fall from setting to setting, and follow one power law: within a tenth for a
/// step or count, within a factor of 3 for a tolerance or samples, whose errors scatter. At least three
/// trials, half of those between the bounds, a factor of four in the knob and an exponent of 1/4; else none.
std::optional<Fit> fit(const QuantityResult&, const MethodResult&);

/// "order 3.99", "error ~ tol^0.98"; empty for none.
std::string shown_fit(const MethodResult&, const std::optional<Fit>&);

/// The trial came to its end, and not elsewhere altogether: its error says how good the method is.
bool usable(const TimedTrial&);

enum class Cost { evaluations, time };
double cost(const TimedTrial&, Cost);

/// The trials, of all methods in a row, that no other beats: none costs no more and errs no more, and is
/// better in one of the two. Errors below the floor are equal.
std::vector<bool> pareto_front(const QuantityResult&, Cost);

}  // namespace oddity
