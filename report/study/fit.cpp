#include "report/study/fit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace oddity {

namespace {

std::string two_decimals(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 2).ptr;
  return {buffer, end};
}

bool scatters(const MethodResult& m) {
  const std::string& resolution = m.trials.front().resolution;
  return resolution == "tolerance" || resolution == "samples";
}

/// A method's trials for a fit: x is the setting or its inverse, y the error, NaN outside the bounds.
struct Points {
  std::vector<double> x, y;
  std::size_t within = 0;  ///< number of trials within the bounds

  double slope(std::size_t i) const { return std::log(y[i] / y[i + 1]) / std::log(x[i] / x[i + 1]); }
  PowerLaw law(std::size_t first, std::size_t last) const {
    const std::size_t count = last - first + 1;
    return power_law(std::span(x).subspan(first, count), std::span(y).subspan(first, count));
  }
};

Points points_of(const QuantityResult& q, const MethodResult& m) {
  Points points;
  const bool counts = m.trials.back().setting > m.trials.front().setting;
  const double size = size_of(q.reference.value);
  const double ceiling = size > 0 ? size : std::numeric_limits<double>::infinity();
  for (const TimedTrial& t : m.trials) {
    const double roundings = std::sqrt(static_cast<double>(std::max(t.evaluations, 1L)));
    const bool within =
        usable(t) && t.error > 10 * roundings * error_floor(q) && t.error < ceiling && t.setting > 0;
    points.x.push_back(counts ? 1 / t.setting : t.setting);
    points.y.push_back(within ? t.error : std::numeric_limits<double>::quiet_NaN());
    points.within += within;
  }
  return points;
}

bool follows_scattered(const Points& p, const Fit& fit) {
  const std::size_t count = fit.last - fit.first + 1;
  if (count < 3 || 2 * count < p.within) return false;
  for (std::size_t i = fit.first; i <= fit.last; ++i) {
    const double off = p.y[i] / fit(p.x[i]);
    if (!(off <= 3 && off >= 1.0 / 3) || (i > fit.first && !(p.y[i] < p.y[i - 1]))) return false;
  }
  return true;
}

bool is_asymptotic(const Points& p, const Fit& fit) {
  if (fit.last - fit.first + 1 < 4) return false;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = fit.first; i < fit.last; ++i) {
    if (!std::isfinite(p.slope(i))) return false;
    least = std::min(least, p.slope(i));
    most = std::max(most, p.slope(i));
  }
  if (most - least > 0.05) return false;
  for (std::size_t i = fit.last + 1; i < p.x.size(); ++i)
    if (std::abs(p.y[i] - fit(p.x[i])) > p.y[fit.last] / 30) return false;
  return true;
}

/// The finest of the longest runs of trials that follow a power law over a factor of four in the setting.
std::optional<Fit> longest(const Points& points, bool (*follows)(const Points&, const Fit&)) {
  std::optional<Fit> best;
  for (std::size_t first = 0; first < points.x.size(); ++first)
    for (std::size_t last = first + 2; last < points.x.size(); ++last) {
      if (best && last - first < best->last - best->first) continue;
      const Fit fit{points.law(first, last), first, last};
      const bool wide = points.x[first] / points.x[last] >= 4 * (1 - 1e-9);
      if (wide && fit.exponent >= 0.25 && follows(points, fit)) best = fit;
    }
  return best;
}

}  // namespace

double error_floor(const QuantityResult& q) {
  const double rounding = std::max(size_of(q.reference.value), 1e-3 * q.need.allowed) * 0x1p-53;
  return std::max({q.reference_error, rounding, std::numeric_limits<double>::min()});
}

bool usable(const TimedTrial& t) {
  const bool failed = t.outcome == Outcome::diverged || t.outcome == Outcome::non_finite ||
                      t.outcome == Outcome::stalled || t.outcome == Outcome::raised ||
                      t.outcome == Outcome::chattering || t.outcome == Outcome::grazing;
  return !failed && std::isfinite(t.error);
}

double PowerLaw::operator()(double x) const { return factor * std::pow(x, exponent); }

PowerLaw power_law(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  double su = 0, sv = 0, suu = 0, suv = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    su += u, sv += v, suu += u * u, suv += u * v;
  }
  const double exponent = (n * suv - su * sv) / (n * suu - su * su);
  return {exponent, std::exp((sv - exponent * su) / n)};
}

std::optional<Fit> fit(const QuantityResult& q, const MethodResult& m) {
  if (m.trials.size() < 3 || m.trials.front().resolution.empty()) return {};
  return longest(points_of(q, m), scatters(m) ? follows_scattered : is_asymptotic);
}

std::optional<Fit> asymptotic_law(std::span<const double> x, std::span<const double> y) {
  return longest({{x.begin(), x.end()}, {y.begin(), y.end()}}, is_asymptotic);
}

std::string shown_fit(const MethodResult& m, const std::optional<Fit>& fit) {
  if (!fit) return "";
  const std::string exponent = two_decimals(fit->exponent);
  const std::string& resolution = m.trials.front().resolution;
  return resolution == "tolerance" ? "error ~ tol^" + exponent
         : scatters(m)             ? "error ~ (1/" + resolution + ")^" + exponent
                                   : "order " + exponent;
}

double cost(const TimedTrial& t, Cost kind) {
  return kind == Cost::evaluations ? static_cast<double>(std::max(t.evaluations, 1L)) : t.time.seconds;
}

std::vector<bool> pareto_front(const QuantityResult& q, Cost kind) {
  struct Point {
    double cost, error;
    bool counts;
  };
  const double floor = error_floor(q);
  std::vector<Point> points;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials)
      points.push_back({cost(t, kind), std::max(t.error, floor), usable(t) && std::isfinite(cost(t, kind))});
  const auto beats = [](const Point& a, const Point& b) {
    return a.counts && a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
  };
  std::vector<bool> front;
  for (const Point& p : points)
    front.push_back(p.counts &&
                    std::ranges::none_of(points, [&](const Point& other) { return beats(other, p); }));
  return front;
}

}  // namespace oddity
