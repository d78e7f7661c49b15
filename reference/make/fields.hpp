#pragma once

#include <array>
#ifndef ODDITY_BALLS
#include <boost/multiprecision/complex_adaptor.hpp>
#endif

#include "reference/make/dual.hpp"
#include "reference/make/routes.hpp"

/// Derivatives of fields in high precision by two routes that use no rule of differentiation. These are
/// extrapolated differences on the line, and Cauchy's integral on a circle around the point in the complex
/// plane. A third route, by dual numbers, encloses them. Fields are entire functions, generic in their number
/// type.
namespace oddity::truth {

#ifdef ODDITY_BALLS
using Complex = Number;
inline Complex complex(const Number&, const Number& = 0) {
  throw NotEnclosed("Cauchy's integral by the trapezoid rule does not bound its error");
}
inline Number real(const Complex& z) { return z; }
#else
/// Boost's complex numbers need their parts on the heap.
using Part = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<working_digits>,
                                           boost::multiprecision::et_off>;
using Complex = boost::multiprecision::number<boost::multiprecision::complex_adaptor<Part::backend_type>,
                                              boost::multiprecision::et_off>;
inline Complex complex(const Number& real, const Number& imaginary = 0) {
  return Complex(Part(real), Part(imaginary));
}
inline Number real(const Complex& z) { return Number(z.real()); }
inline Complex operator*(const Number& a, const Complex& z) { return complex(a) * z; }
#endif

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

/// d h_i / d x_j at z, h: Triple<Complex> -> Triple<Complex>, as the mean of h e^{-it} / r over a circle of
/// radius r by the trapezoid rule. It converges geometrically.
template <class Field>
Triple<Complex> slope_by_cauchy(const Field& h, const Triple<Complex>& z, std::size_t j, const Number& radius,
                                int points = 64) {
  Triple<Complex> mean{};
  for (int k = 0; k < points; ++k) {
    const Number t = 2 * pi() * k / points;
    const Complex on_circle = complex(cos(t), sin(t));
    Triple<Complex> there = z;
    there[j] += radius * on_circle;
    const Triple<Complex> value = h(there);
    for (std::size_t i = 0; i < 3; ++i) mean[i] += value[i] / (on_circle * complex(points * radius));
  }
  return mean;
}

/// d h_i / d x_j at x, h: Triple<Dual<T>> -> Triple<Dual<T>>, by the rules of differentiation.
template <class T, class Field>
Triple<T> slope_by_dual_numbers(const Field& h, const Triple<T>& x, std::size_t j) {
  Triple<Dual<T>> there;
  for (std::size_t i = 0; i < 3; ++i) there[i] = {x[i], T{}};
  if constexpr (std::same_as<T, Number>)
    there[j].dx = 1;
  else
    there[j].dx.x = 1;
  const Triple<Dual<T>> slope = h(there);
  return {slope[0].dx, slope[1].dx, slope[2].dx};
}

/// Row j: the slopes of a field along x_j.
using Slopes = Triple<Triple<Number>>;

/// Within this radius both routes can resolve the fields' frequencies.
inline Number radius_for(const Number& w) { return 1 / (1 + w * w); }

/// A table of first derivatives. `field(waves, inputs)` is the field h to be differentiated, generic in its
/// number type. `combine(slopes, waves, x)` computes the components from its slopes at x. Inputs: w, x0, x1,
/// x2, and the field's additional ones.
template <class Field, class Combine>
Truth field_truth(std::string quantity, std::string formula, std::vector<std::string> components,
                  const std::string& unit, std::vector<std::string> more_inputs,
                  std::vector<std::vector<double>> rows, Field field, Combine combine) {
  Truth truth{std::move(quantity),
              std::move(formula),
              {"w", "x0", "x1", "x2"},
              {},
              std::move(rows),
              {},
              {},
              {},
              {},
              {},
              {}};
  for (std::string& name : components) truth.components.push_back({std::move(name), unit});
  truth.inputs.insert(truth.inputs.end(), more_inputs.begin(), more_inputs.end());
  truth.first_route = "differences of the whole field, extrapolated to step zero";
  truth.first = [=](const std::vector<double>& in, int) {
    const Waves<Number> waves{Number(in[0])};
    const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
    Slopes slopes;
    for (std::size_t j = 0; j < 3; ++j)
      slopes[j] = slope_by_differences(field(waves, in), x, j, radius_for(waves.w));
    return combine(slopes, waves, x);
  };
  truth.second_route = "Cauchy's integral of the whole field over a circle, by the trapezoid rule";
  truth.second = [=](const std::vector<double>& in, int) {
    const Waves<Number> waves{Number(in[0])};
    const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
    const Triple<Complex> z{complex(x[0]), complex(x[1]), complex(x[2])};
    Slopes slopes;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto slope =
          slope_by_cauchy(field(Waves<Complex>{complex(waves.w)}, in), z, j, radius_for(waves.w));
      slopes[j] = {real(slope[0]), real(slope[1]), real(slope[2])};
    }
    return combine(slopes, waves, x);
  };
  truth.enclosure = "derivatives by dual numbers";
  truth.enclosed = [=](const std::vector<double>& in, int) {
    const Waves<Number> waves{Number(in[0])};
    const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
    Slopes slopes;
    for (std::size_t j = 0; j < 3; ++j)
      slopes[j] = slope_by_dual_numbers(field(Waves<Dual<Number>>{{waves.w, 0}}, in), x, j);
    return combine(slopes, waves, x);
  };
  return truth;
}

/// The rows of the tables at one point: gentle, far out, quick, slow.
inline std::vector<std::vector<double>> field_rows() {
  return {{1, 0.3, -0.7, 0.9}, {1, -1, 1, 0.125}, {16, 0.3, -0.7, 0.9}, {0.0625, 0.3, -0.7, 0.9}};
}

}  // namespace oddity::truth
