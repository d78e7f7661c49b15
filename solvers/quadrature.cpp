#include "solvers/quadrature.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace oddity {

namespace {

constexpr std::size_t intervals = 1000;

/// The most evaluations that CQUAD may take. It has no limit itself, and took 265 million on 1/x over [-1,
/// 2].
constexpr long cquad_budget = 1'000'000;

/// The integral with its ending, from GSL's status, the value and the estimate.
Integral with_ending(int status, double value, double estimate, double tolerance, long evaluations) {
  Integral integral{value, evaluations, estimate};
  if (!std::isfinite(value)) {
    integral.ending = Ending::non_finite;
    integral.message = "the result is not finite";
  } else if (status == GSL_EMAXITER) {
    integral.ending = Ending::stalled;
    integral.message = gsl_strerror(status);
  } else if (status != GSL_SUCCESS) {
    integral.ending = Ending::raised;
    integral.message = gsl_strerror(status);
  } else if (!(estimate <= std::max(tolerance, tolerance * std::abs(value)))) {
    integral.ending = Ending::stalled;
    integral.message = "GSL reports success, but its error estimate is above the request";
  }
  return integral;
}

/// Runs one of GSL's adaptive rules on its workspace.
template <class Call>
Integral adaptive(FunctionOfOne f, double tolerance, const Call& call) {
  disable_gsl_abort();
  const std::unique_ptr<gsl_integration_workspace, Free<gsl_integration_workspace_free>> workspace(
      allocated(gsl_integration_workspace_alloc(intervals)));
  CountedFunction counted{f};
  const gsl_function function{&CountedFunction::call, &counted};
  double value = 0, estimate = 0;
  const int status = call(&function, workspace.get(), &value, &estimate);
  counted.rethrow();
  return with_ending(status, value, estimate, tolerance, counted.calls);
}

Integral fixed_rule(double value, long evaluations) {
  Integral integral{value, evaluations};
  if (!std::isfinite(value)) {
    integral.ending = Ending::non_finite;
    integral.message = "the integrand is not finite at a node";
  }
  return integral;
}

Integral failed(const std::string& message) {
  Integral integral;
  integral.ending = Ending::raised;
  integral.message = message;
  return integral;
}

}  // namespace

Integral qag(FunctionOfOne f, double a, double b, double tolerance) {
  return adaptive(
      f, tolerance, [&](const gsl_function* g, gsl_integration_workspace* w, double* value, double* e) {
        return gsl_integration_qag(g, a, b, tolerance, tolerance, intervals, GSL_INTEG_GAUSS21, w, value, e);
      });
}

Integral qags(FunctionOfOne f, double a, double b, double tolerance) {
  return adaptive(f, tolerance,
                  [&](const gsl_function* g, gsl_integration_workspace* w, double* value, double* e) {
                    return gsl_integration_qags(g, a, b, tolerance, tolerance, intervals, w, value, e);
                  });
}

Integral qagp(FunctionOfOne f, std::vector<double> points, double tolerance) {
  if (points.size() < 2) return failed("QAGP needs the two ends of the interval");
  return adaptive(f, tolerance,
                  [&](const gsl_function* g, gsl_integration_workspace* w, double* value, double* e) {
                    return gsl_integration_qagp(g, points.data(), points.size(), tolerance, tolerance,
                                                intervals, w, value, e);
                  });
}

Integral cquad(FunctionOfOne f, double a, double b, double tolerance) {
  if (b < a) {  // GSL's estimate would be negative, and so below any tolerance
    Integral reversed = cquad(f, b, a, tolerance);
    reversed.value = -reversed.value;
    return reversed;
  }
  disable_gsl_abort();
  const std::unique_ptr<gsl_integration_cquad_workspace, Free<gsl_integration_cquad_workspace_free>>
      workspace(allocated(gsl_integration_cquad_workspace_alloc(intervals)));
  long evaluations = 0;
  bool undefined = false, spent = false;
  const auto watched = [&](double x) -> double {
    spent = spent || evaluations == cquad_budget;
    if (spent) return std::numeric_limits<double>::max();  // its error estimate overflows, which ends CQUAD
    ++evaluations;
    const double y = f(x);
    undefined = undefined || (std::isnan(y) && x != a && x != b);
    return y;
  };
  CountedFunction counted{watched};
  const gsl_function function{&CountedFunction::call, &counted};
  double value = 0, estimate = 0;
  const int status = gsl_integration_cquad(&function, a, b, tolerance, tolerance, workspace.get(), &value,
                                           &estimate, nullptr);
  counted.rethrow();
  Integral integral = with_ending(status, value, estimate, tolerance, evaluations);
  if (spent) {
    integral = {};
    integral.evaluations = evaluations;
    integral.ending = Ending::stalled;
    integral.message = "the budget of evaluations is spent";
  }
  if (undefined) {
    integral.ending = Ending::non_finite;
    integral.message = "the integrand is not a number at a node inside the interval";
  }
  return integral;
}

namespace {

/// Improves the weights of sizes for which GSL has no table. GSL computes these to ten digits only, from the
/// slope before its last correction of the node. Newton's method on the Legendre polynomial, from GSL's
/// nodes, gives all digits. Weights by [Abramowitz, Stegun 25.4.29].
void polish(gsl_integration_glfixed_table& table) {
  const auto n = static_cast<double>(table.n);
  for (std::size_t node = 0; node < (table.n + 1) / 2; ++node) {
    double& x = table.x[node];
    double slope = 0;
    for (int step = 0; step < 3; ++step) {
      double before = 1, p = x;
      for (std::size_t i = 2; i <= table.n; ++i) {
        const auto k = static_cast<double>(i);
        before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
      }
      slope = n * (before - x * p) / (1 - x * x);
      if (step < 2) x -= p / slope;
    }
    table.w[node] = 2 / ((1 - x * x) * slope * slope);
  }
}

/// The rule with this number of points. Each thread caches its rules, as nested integrals use them again and
/// again.
const gsl_integration_glfixed_table& rule_of(int points) {
  thread_local std::map<
      int, std::unique_ptr<gsl_integration_glfixed_table, Free<gsl_integration_glfixed_table_free>>>
      rules;
  auto& rule = rules[points];
  if (!rule) {
    rule.reset(allocated(gsl_integration_glfixed_table_alloc(static_cast<std::size_t>(points))));
    if (!rule->precomputed) polish(*rule);
  }
  return *rule;
}

}  // namespace

Integral gauss_legendre(FunctionOfOne f, double a, double b, int points) {
  if (points < 1) return failed("Gauss-Legendre needs at least one point");
  disable_gsl_abort();
  CountedFunction counted{f};
  const gsl_function function{&CountedFunction::call, &counted};
  const double value = gsl_integration_glfixed(&function, a, b, &rule_of(points));
  counted.rethrow();
  return fixed_rule(value, counted.calls);
}

Integral simpson(FunctionOfOne f, double a, double b, int panels) {
  if (panels < 2 || panels % 2 != 0) return failed("Simpson's rule needs an even number of panels");
  const double h = (b - a) / panels;
  double odd = 0, even = 0;
  for (int i = 1; i < panels; i += 2) odd += f(a + i * h);
  for (int i = 2; i < panels; i += 2) even += f(a + i * h);
  return fixed_rule(h / 3 * (f(a) + 4 * odd + 2 * even + f(b)), panels + 1);
}

Integral trapezoid(FunctionOfOne f, double a, double b, int panels) {
  if (panels < 1) return failed("the trapezoid rule needs at least one panel");
  const double h = (b - a) / panels;
  double inside = 0;
  for (int i = 1; i < panels; ++i) inside += f(a + i * h);
  return fixed_rule(h * (0.5 * f(a) + inside + 0.5 * f(b)), panels + 1);
}

namespace {

/// Adds an inner integral's work to a total, and keeps the first failure.
double accumulate(const Integral& inner, Integral& total) {
  total.evaluations += inner.evaluations;
  if (!inner.reached() && total.reached()) {
    total.ending = inner.ending;
    total.message = inner.message;
  }
  return inner.value;
}

Integral merged(const Integral& outer, const Integral& inner) {
  Integral total = outer;
  total.evaluations = inner.evaluations;
  if (!inner.reached()) {
    total.ending = inner.ending;
    total.message = "inner integral: " + inner.message;
  }
  return total;
}

}  // namespace

Integral nested(const Rule& rule, const std::function<double(double, double)>& f, double a, double b,
                const Bound& low, const Bound& high) {
  Integral inner;
  const auto slice = [&](double x) {
    return accumulate(rule([&](double y) { return f(x, y); }, low(x), high(x)), inner);
  };
  const Integral outer = rule(slice, a, b);
  return merged(outer, inner);
}

Integral nested(const Rule& rule, const std::function<double(double, double, double)>& f, double a, double b,
                const Bound& low, const Bound& high, const std::function<double(double, double)>& bottom,
                const std::function<double(double, double)>& top) {
  Integral inner;
  const auto slice = [&](double x) {
    const auto column = [&](double y) { return [&f, x, y](double z) { return f(x, y, z); }; };
    const auto line = [&](double y) { return accumulate(rule(column(y), bottom(x, y), top(x, y)), inner); };
    Integral middle = rule(line, low(x), high(x));
    middle.evaluations = 0;
    return accumulate(middle, inner);
  };
  const Integral outer = rule(slice, a, b);
  return merged(outer, inner);
}

}  // namespace oddity
