#pragma once

#include <optional>
#include <span>
#include <vector>

#include "report/study/results.hpp"

/// What the trials of a method say together: how its error follows its knob, and which trials no other beats.
namespace oddity {

/// y = factor * x^exponent by least squares of the logarithms.
struct PowerLaw {
  double exponent, factor;
  double operator()(double x) const;
};
PowerLaw power_law(std::span<const double> x, std::span<const double> y);

/// error = factor * setting^exponent; for a knob that counts (panels, points), factor * (1/setting)^exponent.
struct Fit : PowerLaw {
  std::size_t first, last;  ///< the trials fitted, both included
};

/// No error means anything below this: the reference's own error, or rounding.
double error_floor(const QuantityResult&);

/// The fit over the longest run of trials, the finest of equals, that show a power law. Their errors lie
/// between ten times what the floor leaves after so many evaluations and the true value's size.
///
/// Tolerances and samples scatter: at least three trials, half of those between the bounds, and a factor of
/// four in the knob, whose errors fall and stay within a factor of 3 of the law.
///
/// All else has an order only in its asymptotic range: at least four trials whose slopes, from one to the
/// next, agree within 0.05; and what the finer trials err beyond the law, rounding or the model's own error,
/// is at most a thirtieth of the error of the finest fitted.
///
/// None where the exponent is below 1/4.
std::optional<Fit> fit(const QuantityResult&, const MethodResult&);

/// The law of y over x, both from coarse to fine, in its asymptotic range: under the same terms.
std::optional<Fit> asymptotic_law(std::span<const double> x, std::span<const double> y);

/// "order 3.99", "error ~ tol^0.98", "error ~ (1/samples)^0.51"; empty for none.
std::string shown_fit(const MethodResult&, const std::optional<Fit>&);

/// The trial came to its end, and not elsewhere altogether: its error says how good the method is.
bool usable(const TimedTrial&);

enum class Cost { evaluations, time };
double cost(const TimedTrial&, Cost);

/// The trials, of all methods in a row, that no other beats: none costs no more and errs no more, and is
/// better in one of the two. Errors below the floor are equal.
std::vector<bool> pareto_front(const QuantityResult&, Cost);

}  // namespace oddity
