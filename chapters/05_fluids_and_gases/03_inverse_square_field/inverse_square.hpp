#pragma once

#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "reference/text.hpp"

/// The field x / |x|^3, its derivatives as published, and the quantity that they are.
namespace oddity::fields {

inline constexpr auto inverse_square = []<class T>(const Triple<T>& x) {
  using std::sqrt;
  const T r = sqrt(dot(x, x)), cube = r * r * r;
  return Triple<T>{x[0] / cube, x[1] / cube, x[2] / cube};
};

/// The derivatives of the components by their own coordinates, summed from a turned frame.
inline Point own_slopes(const Point& x, const Frame& frame) {
  Point slopes{};
  for (const Point& u : frame) {
    const Point along_u = along(inverse_square, x, u);
    for (std::size_t i = 0; i < 3; ++i) slopes[i] += u[i] * along_u[i];
  }
  return slopes;
}

// ---- as published -----------------------------------------------------------------------------------------

/// s is x.x, x one of the coordinates.
using Formula = double (*)(double s, double x);

template <Formula formula>
Point each(const Point& x) {
  const double s = dot(x, x);
  return {formula(s, x[0]), formula(s, x[1]), formula(s, x[2])};
}

inline double quotient(double s, double x) {
  return (std::pow(s, 1.5) - 3 * x * x * std::pow(s, 0.5)) / std::pow(s, 3);
}
inline double quotient_factor_2(double s, double x) {
  return (std::pow(s, 1.5) - 2 * x * x * std::pow(s, 0.5)) / std::pow(s, 3);
}
inline double quotient_plus(double s, double x) {
  return (std::pow(s, 1.5) + 3 * x * x * std::pow(s, 0.5)) / std::pow(s, 3);
}
inline double simplified(double s, double x) { return (s - 3 * x * x) / std::pow(s, 2.5); }
inline double simplified_plus(double s, double x) { return (s + 3 * x * x) / std::pow(s, 2.5); }
inline double simplified_dropped(double s, double) { return s / std::pow(s, 2.5); }

/// The three summands over the common denominator.
inline Point brackets(const Point& x) {
  const double s = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], denominator = std::pow(s, 2.5);
  return {(s - 3 * x[0] * x[0]) / denominator, (s - 3 * x[1] * x[1]) / denominator,
          (s - 3 * x[2] * x[2]) / denominator};
}
inline Point brackets_first_twice(const Point& x) {
  const Point b = brackets(x);
  return {b[0], b[0], b[2]};
}

/// A published formula for the three derivatives, at sizes of x within `range` of 1 either way.
inline Reading reading(const std::string& text, Point (*formula)(const Point&), double range, Random random) {
  Worst worst("d/dx_i (x_i / |x|^3), against dual numbers along a turned frame",
              "dual numbers along a turned frame", text);
  for (int n = 0; n < 256; ++n) {
    const double r = std::abs(random.magnitude(1 / range, range));
    const Point u = random.direction(), x{r * u[0], r * u[1], r * u[2]};
    worst.see(own_slopes(x, random_frame(random)), formula(x), 1 / dot(x, x) / r, "|x| = " + shortest(r));
  }
  return {text, {worst.check()}};
}

// ---- computed ---------------------------------------------------------------------------------------------

/// The three derivatives and their sum, times |x|^3.
inline Value scaled(const Point& slopes, const Point& x) {
  const double r = length(x);
  const Point s{slopes[0] * r * r * r, slopes[1] * r * r * r, slopes[2] * r * r * r};
  return {s[0], s[1], s[2], s[0] + s[1] + s[2]};
}

/// How differences with an absolute step are expected to end.
struct Steps {
  Outcome second = Outcome::inaccurate, fourth = Outcome::inaccurate;
  std::string why = "rounding grows as eps/h: the finest step is not the best";
};

inline Quantity partials(const std::string& name, const std::string& says, const Point& x,
                         const Reference& truth, Outcome quotient_ends, const Steps& absolute) {
  const Known known = truth("05_03_partials", {x[0], x[1], x[2]});
  Quantity q{
      name,
      "1",
      says,
      {known.source + ", and the sum zero", Value{known.value[0], known.value[1], known.value[2], 0.0}},
      known.error,
      {1e-9, "nine decimals"},
      {},
      {}};
  const std::string field = "field", formula = "published derivatives";
  const auto published = [x](Point (*f)(const Point&)) {
    return [x, f](double) { return Answer{scaled(f(x), x), static_cast<long>(x.size())}; };
  };
  q.add({formula, "quotient rule", no_knob(), published(each<quotient>), quotient_ends,
         quotient_ends == Outcome::ok ? "" : "|x|^6 overflows from |x| = 2e51 on"});
  q.add({formula, "simplified", no_knob(), published(each<simplified>)});
  const auto by = [x](auto way) {
    Point slopes;
    for (std::size_t i = 0; i < 3; ++i) slopes[i] = way.along(inverse_square, x, axes[i])[i];
    return Answer{scaled(slopes, x), way.calls};
  };
  const double size = length(x);
  q.add({field, "dual numbers", no_knob(), [=](double) { return by(ByDuals{}); }});
  q.add({field + ", step h", "central differences 2", steps(),
         [=](double h) { return by(ByDifferences<2>{h}); }, absolute.second, absolute.why});
  q.add({field + ", step h", "central differences 4", steps(),
         [=](double h) { return by(ByDifferences<4>{h}); }, absolute.fourth,
         absolute.fourth == Outcome::ok ? "" : absolute.why});
  q.add({field + ", step h |x|", "central differences 2", steps(),
         [=](double h) { return by(ByDifferences<2>{h * size}); }, Outcome::inaccurate, Steps{}.why});
  q.add({field + ", step h |x|", "central differences 4", steps(),
         [=](double h) { return by(ByDifferences<4>{h * size}); }, Outcome::inaccurate, Steps{}.why});
  return q;
}

}  // namespace oddity::fields
