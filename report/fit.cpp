#include "report/fit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace oddity {

namespace {

/// A straight line through points, and the farthest that one of them is above or below it.
struct FittedLine {
  double slope, intercept, off;
};

FittedLine line_through(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  FittedLine line{(n * sxy - sx * sy) / (n * sxx - sx * sx), 0, 0};
  line.intercept = (sy - line.slope * sx) / n;
  for (std::size_t i = 0; i < x.size(); ++i)
    line.off = std::max(line.off, std::abs(y[i] - line.intercept - line.slope * x[i]));
  return line;
}

std::string two_decimals(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 2).ptr;
  return {buffer, end};
}

bool scatters(const MethodResult& m) {
  const std::string& knob = m.trials.front().knob;
  return knob == "tolerance" || knob == "samples";
}

}  // namespace

double error_floor(const QuantityResult& q) {
  const double rounding = std::max(size_of(q.reference.value), 1e-3 * q.need.allowed) * 0x1p-53;
  return std::max({q.reference_error, rounding, std::numeric_limits<double>::min()});
}

bool usable(const TimedTrial& t) {
  const bool failed = t.outcome == Outcome::diverged || t.outcome == Outcome::non_finite ||
                      t.outcome == Outcome::stalled || t.outcome == Outcome::raised;
  return !failed && std::isfinite(t.error);
}

std::optional<Fit> fit(const QuantityResult& q, const MethodResult& m) {
  const std::size_t n = m.trials.size();
  if (n < 3 || m.trials.front().knob.empty()) return {};
  const bool counts = m.trials.back().setting > m.trials.front().setting;
  const double size = size_of(q.reference.value), floor = 10 * error_floor(q);
  const double ceiling = size > 0 ? size : std::numeric_limits<double>::infinity();
  const double allowed = std::log(scatters(m) ? 3 : 1.1);
  std::vector<double> x, y;
  for (const TimedTrial& t : m.trials) {
    const bool within = usable(t) && t.error > floor && t.error < ceiling && t.setting > 0;
    x.push_back(counts ? -std::log(t.setting) : std::log(t.setting));
    y.push_back(within ? std::log(t.error) : std::numeric_limits<double>::quiet_NaN());
  }
  const auto in_range =
      static_cast<std::size_t>(std::ranges::count_if(y, [](double v) { return !std::isnan(v); }));
  std::optional<Fit> best;
  for (std::size_t first = 0; first < n; ++first)
    for (std::size_t last = first + 1; last < n && x[last] < x[last - 1] && y[last] < y[last - 1]; ++last) {
      const std::size_t points = last - first + 1;
      if (points < 3 || 2 * points < in_range || x[first] - x[last] < std::log(4) * (1 - 1e-9)) continue;
      if (best && points < best->last - best->first + 1) continue;
      const FittedLine line =
          line_through(std::span(x).subspan(first, points), std::span(y).subspan(first, points));
      if (line.off <= allowed && line.slope >= 0.25)
        best = Fit{line.slope, std::exp(line.intercept), first, last};
    }
  return best;
}

std::string shown_fit(const MethodResult& m, const std::optional<Fit>& fit) {
  if (!fit) return "";
  const std::string exponent = two_decimals(fit->exponent);
  return m.trials.front().knob == "tolerance" ? "error ~ tol^" + exponent : "order " + exponent;
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
