#pragma once

#include <optional>
#include <span>
#include <vector>

#include "report/study/results.hpp"

/// Evaluates a method's trials together: the dependence of its error on its setting, and the trials that no
/// other beats.
namespace oddity {

/// y = factor * x^exponent by least squares of the logarithms.
struct PowerLaw {
  double exponent, factor;
  double operator()(double x) const;
};
PowerLaw power_law(std::span<const double> x, std::span<const double> y);

/// error = factor * setting^exponent. If the setting is a count (panels, points): factor *
/// (1/setting)^exponent.
struct Fit : PowerLaw {
  std::size_t first, last;  ///< the trials fitted, both included
};

/// Errors below this mean nothing: the reference's own error, or rounding.
double error_floor(const QuantityResult&);

/// Fits the longest run of trials that show a power law, the finest of equals. Their errors lie between ten
/// times the floor after so many evaluations and the true value's size.
///
/// Tolerances and samples scatter: the run needs at least three trials, half of those between the bounds, and
/// a factor of four in the setting. Its errors fall and stay within a factor of 3 of the law.
///
/// All other settings have an order only in the asymptotic range: the run needs at least four trials whose
/// slopes, from one to the next, agree within 0.05. The error of the finer trials beyond the law (rounding or
/// the model's own error) is at most a thirtieth of the error of the finest fitted.
///
/// Empty if the exponent is below 1/4.
std::optional<Fit> fit(const QuantityResult&, const MethodResult&);

/// The law of y over x, both from coarse to fine, in its asymptotic range, on the same conditions.
std::optional<Fit> asymptotic_law(std::span<const double> x, std::span<const double> y);

/// "order 3.99", "error ~ tol^0.98", "error ~ (1/samples)^0.51"; empty for none.
std::string shown_fit(const MethodResult&, const std::optional<Fit>&);

/// The trial finished, and near the right motion: its error measures the method.
bool usable(const TimedTrial&);

enum class Cost { evaluations, time };
double cost(const TimedTrial&, Cost);

/// The trials, of all methods in a row, that no other beats: none is at most as large in both cost and error,
/// and smaller in one of them. Errors below the floor are equal.
std::vector<bool> pareto_front(const QuantityResult&, Cost);

}  // namespace oddity
