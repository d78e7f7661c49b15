#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "solvers/quadrature.hpp"

/// The adaptive quadrature rules in one list, and integrands with known integrals.
namespace rules {

using oddity::FunctionOfOne, oddity::Integral;

struct Adaptive {
  std::string name;
  std::function<Integral(FunctionOfOne, double a, double b, double tolerance)> run;
};

inline Integral qagp_of_the_ends(FunctionOfOne f, double a, double b, double tolerance) {
  return oddity::qagp(f, {a, b}, tolerance);
}

inline const std::vector<Adaptive>& adaptive() {
  static const std::vector<Adaptive> all{
      {"QAG", oddity::qag}, {"QAGS", oddity::qags}, {"QAGP", qagp_of_the_ends}, {"CQUAD", oddity::cquad}};
  return all;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

inline double exponential(double x) { return std::exp(x); }
inline double inverse_root(double x) { return 1 / std::sqrt(x); }
inline double logarithm(double x) { return std::log(x); }
inline double pole(double x) { return 1 / x; }

}  // namespace rules
