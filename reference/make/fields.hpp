#pragma once

#include <array>
#include <boost/multiprecision/complex_adaptor.hpp>

#include "reference/make/routes.hpp"

/// Derivatives of fields in high precision by two routes that know no rule of differentiation:
/// extrapolated differences on the line, and Cauchy's integral on a circle around the point in the complex
/// plane. Fields are entire functions, generic in their number type.
namespace oddity::truth {

using Complex = boost::multiprecision::number<
    boost::multiprecision::complex_adaptor<boost::multiprecision::mpfr_float_backend<working_digits>>,
    boost::multiprecision::et_off>;

template <class T>
using Triple = std::array<T, 3>;

/// The fields of chapter 5's quantities, of wave number w.
template <class T>
struct Waves {
  T w;

  T phi(const Triple<T>& x) const {
    const T a = w * x[0], b = w * x[1], c = w * x[2];
    return exp(a / 2) * sin(b + c) + a * b * c;
  }
  Triple<T> f(const Triple<T>& x) const {
    const T a = w * x[0], b = w * x[1], c = w * x[2];
    return {sin(a + 2 * b) * exp(c / 2) + b * c * c, cos(b * c) + a * a * c,
            exp(-a / 2) * cos(2 * b - c) + a * b};
  }
  Triple<T> g(const Triple<T>& x) const {
    const T a = w * x[0], b = w * x[1], c = w * x[2];
    return {cos(a - c) * exp(b / 2) + b * b, sin(a * b) + a * c, exp(b / 2) * sin(a + c) + a * b * c};
  }
};

inline Number real_part(const Number& z) { return z; }
inline Number real_part(const Complex& z) { return z.real(); }

/// d h_i / d x_j at x, h: Triple<Number> -> Triple<Number>, by central differences of steps
/// radius / 2^k, extrapolated to zero (Aitken-Neville in the step's square).
template <class Field>
Triple<Number> slope_by_differences(const Field& h, const Triple<Number>& x, std::size_t j, Number radius) {
  constexpr std::size_t levels = 13;
  std::vector<Triple<Number>> column;
  for (std::size_t k = 0; k < levels; ++k, radius /= 2) {
    Triple<Number> ahead = x, behind = x;
    ahead[j] += radius;
    behind[j] -= radius;
    Triple<Number> slope = h(ahead);
    const Triple<Number> back = h(behind);
    for (std::size_t i = 0; i < 3; ++i) slope[i] = (slope[i] - back[i]) / (2 * radius);
    column.push_back(slope);
    Number ratio = 1;
    for (std::size_t m = k; m-- > 0;) {
      ratio *= 4;
      for (std::size_t i = 0; i < 3; ++i)
        column[m][i] = column[m + 1][i] + (column[m + 1][i] - column[m][i]) / (ratio - 1);
    }
  }
  return column[0];
}

/// d h_i / d x_j at x, h: Triple<Complex> -> Triple<Complex>, as the mean of h e^{-it} / r over a circle of
/// radius r by the trapezoid rule, which converges geometrically.
template <class Field>
Triple<Number> slope_by_cauchy(const Field& h, const Triple<Number>& x, std::size_t j, const Number& radius) {
  constexpr int points = 64;
  Triple<Number> mean{};
  for (int k = 0; k < points; ++k) {
    const Number t = 2 * pi() * k / points;
    const Complex on_circle(cos(t), sin(t));
    Triple<Complex> z{Complex(x[0]), Complex(x[1]), Complex(x[2])};
    z[j] += radius * on_circle;
    const Triple<Complex> value = h(z);
    for (std::size_t i = 0; i < 3; ++i) mean[i] += Complex(value[i] / on_circle).real() / (points * radius);
  }
  return mean;
}

/// Row j: the slopes along x_j. `make_field` takes Waves<T> and gives the field h over T.
template <class MakeField>
Triple<Triple<Number>> slopes_by_differences(const MakeField& make_field, const std::vector<double>& in) {
  const Number w = in[0], radius = 1 / (1 + w * w);
  const auto h = make_field(Waves<Number>{w});
  const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
  return {slope_by_differences(h, x, 0, radius), slope_by_differences(h, x, 1, radius),
          slope_by_differences(h, x, 2, radius)};
}
template <class MakeField>
Triple<Triple<Number>> slopes_by_cauchy(const MakeField& make_field, const std::vector<double>& in) {
  const Number w = in[0], radius = 1 / (1 + w * w);
  const auto h = make_field(Waves<Complex>{Complex(w)});
  const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
  return {slope_by_cauchy(h, x, 0, radius), slope_by_cauchy(h, x, 1, radius),
          slope_by_cauchy(h, x, 2, radius)};
}

/// The rows that every table of the chapter holds: gentle, far out, quick, slow.
inline std::vector<std::vector<double>> field_rows() {
  return {{1, 0.3, -0.7, 0.9}, {1, -1, 1, 0.125}, {16, 0.3, -0.7, 0.9}, {0.0625, 0.3, -0.7, 0.9}};
}
inline const std::string differences_route = "differences of the whole field, extrapolated to step zero";
inline const std::string cauchy_route = "Cauchy's integral of the whole field on a circle, trapezoid rule";

}  // namespace oddity::truth
