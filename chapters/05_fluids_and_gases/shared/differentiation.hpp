#pragma once

#include <cmath>

#include "chapters/05_fluids_and_gases/shared/fields.hpp"
#include "chapters/exercise.hpp"
#include "reference/reference.hpp"
#include "solvers/counted_calls.hpp"

/// Methods to differentiate a field at a point, with their calls of the field counted, and the quantities of
/// this chapter by all of these methods.
namespace oddity::fields {

/// The parameters of an identity: the fixed fields, the point, and the random fields of the claims.
inline constexpr Parameter field_parameters[] = {
    {"w", 1, "1/m", "wave number of the fields", 0.0625, 16},
    {"x0", 0.3, "m", "where the fields are differentiated", -1, 1},
    {"x1", -0.7, "m", "where the fields are differentiated", -1, 1},
    {"x2", 0.9, "m", "where the fields are differentiated", -1, 1},
    {"seed", 5, "", "seed of the random fields that the claims are checked with", 0, 9e15, whole_number},
};

/// The fixed fields and the point.
struct At {
  explicit At(const Parameters& p) : waves{p["w"]}, x{p["x0"], p["x1"], p["x2"]} {}

  auto phi() const {
    return [w = waves](const auto& y) { return w.phi(y); };
  }
  auto f() const {
    return [w = waves](const auto& y) { return w.f(y); };
  }
  auto g() const {
    return [w = waves](const auto& y) { return w.g(y); };
  }
  std::vector<double> inputs() const { return {waves.w, x[0], x[1], x[2]}; }

  Waves waves;
  Point x;
};

/// s a + t b.
inline double combined(double s, double a, double t, double b) { return s * a + t * b; }
inline Point combined(double s, const Point& a, double t, const Point& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

/// Dual numbers: one call per direction, exact to rounding.
struct ByDuals {
  long calls = 0;

  template <class Field>
  auto along(const Field& f, const Point& x, const Point& u) {
    ++calls;
    return fields::along(f, x, u);
  }
};

/// Central differences of order 2 and 4: two and four calls per direction. Truncation shrinks as h^2 (h^4)
/// and rounding grows as eps/h, so the best steps are near eps^(1/3) and eps^(1/5).
template <int order>
requires(order == 2 || order == 4) struct ByDifferences {
  double h;
  long calls = 0;

  template <class Field>
  auto along(const Field& f, const Point& x, const Point& u) {
    const auto at = counted_calls(f, calls);
    const auto slope = [&](double step) {
      return combined(1 / (2 * step), at(combined(1, x, step, u)), -1 / (2 * step),
                      at(combined(1, x, -step, u)));
    };
    if constexpr (order == 2)
      return slope(h);
    else
      return combined(4.0 / 3, slope(h), -1.0 / 3, slope(2 * h));
  }
};

template <class Way, class Field>
Point gradient_by(Way& way, const Field& phi, const Point& x) {
  return {way.along(phi, x, axes[0]), way.along(phi, x, axes[1]), way.along(phi, x, axes[2])};
}
/// Row j: the derivative of the whole field by x_j.
template <class Way, class Field>
Matrix<double> slopes_by(Way& way, const Field& f, const Point& x) {
  return {way.along(f, x, axes[0]), way.along(f, x, axes[1]), way.along(f, x, axes[2])};
}
inline Point curl_of(const Matrix<double>& slopes) {
  return {slopes[1][2] - slopes[2][1], slopes[2][0] - slopes[0][2], slopes[0][1] - slopes[1][0]};
}
/// (v.grad) of a field.
inline Point advection_of(const Matrix<double>& slopes, const Point& v) {
  return combined(1, combined(v[0], slopes[0], v[1], slopes[1]), v[2], slopes[2]);
}
template <class Way, class Field>
Point curl_by(Way& way, const Field& f, const Point& x) {
  return curl_of(slopes_by(way, f, x));
}
template <class Way, class Field>
double divergence_by(Way& way, const Field& f, const Point& x) {
  const Matrix<double> d = slopes_by(way, f, x);
  return d[0][0] + d[1][1] + d[2][2];
}

/// 2^-3, 2^-5, ..., 2^-last.
inline Resolution steps(int last = 31) {
  Resolution resolution{"step", {}};
  for (int k = 3; k <= last; k += 2) resolution.settings.push_back(std::ldexp(1.0, -k));
  return resolution;
}

inline Tolerance nine_digits(const Value& of) {
  return {1e-9 * std::max(size_of(of), 1e-6), "nine digits of the largest component"};
}

/// Adds a model by every method of differentiation: `compute` takes a method and returns the value. Cost
/// counts the calls of the factors; each differentiated field has `factors` of them. `finest` is the expected
/// outcome of differences at 2^-31.
template <class Compute>
void add_ways(Quantity& q, const std::string& model, long factors, const Compute& compute,
              Outcome finest = Outcome::inaccurate,
              const std::string& why = "rounding grows as $1/h$: the finest step is not the best") {
  const auto by = [compute, factors](auto way) {
    const Value value(compute(way));
    return Answer{value, factors * way.calls};
  };
  q.add({model, "dual numbers", no_resolution(), [by](double) { return by(ByDuals{}); }});
  q.add({model, "central differences 2", steps(), [by](double h) { return by(ByDifferences<2>{h}); }, finest,
         why});
  q.add({model, "central differences 4", steps(), [by](double h) { return by(ByDifferences<4>{h}); }, finest,
         why});
}

/// The base-2 logarithm of epsilon^(1/n) / w, for the best step in a field of wave number w.
inline double best_power(int n, double w) { return -52.0 / n - std::log2(w); }
/// The step of steps() that is nearest to 2^power.
inline double step_near(double power) { return std::exp2(-1 - 2 * std::round((-power - 1) / 2)); }

/// Both ends of the V-shaped error of differences: failures at a fine and a coarse step, and their cures.
inline void add_breakdowns(Quantity& q, const std::string& model, double w) {
  const std::string second = model + ", central differences 2", fourth = model + ", central differences 4";
  q.add(Breakdown{R"(At a step of $2^{@2}$ the rounding $\varepsilon/h$ has eaten the difference; the best )"
                  R"(step of order 2 is near $\varepsilon^{1/3}/w \approx 2^{@2}$.)",
                  second,
                  0x1p-31,
                  Outcome::inaccurate,
                  second,
                  step_near(best_power(3, w)),
                  {power_of_two_of(Side::broken), best_power(3, w)}});
  q.add(Breakdown{R"(The best step of order 4 is near $\varepsilon^{1/5}/w \approx 2^{@2}$, much coarser.)",
                  fourth,
                  0x1p-31,
                  Outcome::inaccurate,
                  fourth,
                  step_near(best_power(5, w)),
                  {best_power(5, w)}});
  q.add(Breakdown{"At a step of @3 the truncation error dominates; dual numbers have none.",
                  second,
                  0x1p-3,
                  Outcome::inaccurate,
                  model + ", dual numbers",
                  0,
                  {setting_of(Side::broken)}});
}

}  // namespace oddity::fields
