#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

/// Units as numbers: formulas are evaluated in them, and a sum of metres and seconds has no value.
namespace oddity::problem {

/// A range of a text.
struct Span {
  std::size_t begin = std::string::npos, end = 0;

  bool is_known() const { return begin < end; }
  friend Span operator|(const Span& a, const Span& b) {
    if (!a.is_known()) return b;
    return b.is_known() ? Span{std::min(a.begin, b.begin), std::max(a.end, b.end)} : a;
  }
};

/// The powers of m, s, kg, A, solar mass and bins; radians count as one.
struct Measure {
  std::array<double, 6> powers = {};
  bool fits_all = false;  ///< zero fits every unit
  Span span = {};         ///< place of the letters that it comes from

  Measure() = default;
  Measure(double x) : fits_all(x == 0) {}
};

/// Two units that do not fit, or one where a pure number is required.
struct Mismatch : std::runtime_error {
  Mismatch(std::string says, Span where) : std::runtime_error(std::move(says)), span(where) {}
  Span span;
};

/// "m/s^2"; "a pure number".
std::string name_of(const Measure& measure);
/// The measure of a unit's text; empty if it is no unit.
std::optional<Measure> measure_of(std::string_view unit);
bool fit(const Measure& a, const Measure& b);

Measure operator+(const Measure& a, const Measure& b);
inline Measure operator-(const Measure& a, const Measure& b) { return a + b; }
inline Measure operator-(const Measure& a) { return a; }
Measure operator*(const Measure& a, const Measure& b);
Measure operator/(const Measure& a, const Measure& b);
Measure sqrt(const Measure& x);
/// Throws Mismatch unless x is a pure number.
Measure pure(const Measure& x);
inline Measure sin(const Measure& x) { return pure(x); }
inline Measure cos(const Measure& x) { return pure(x); }
inline Measure tan(const Measure& x) { return pure(x); }
inline Measure asin(const Measure& x) { return pure(x); }
inline Measure acos(const Measure& x) { return pure(x); }
inline Measure atan(const Measure& x) { return pure(x); }
inline Measure sinh(const Measure& x) { return pure(x); }
inline Measure cosh(const Measure& x) { return pure(x); }
inline Measure tanh(const Measure& x) { return pure(x); }
inline Measure asinh(const Measure& x) { return pure(x); }
inline Measure acosh(const Measure& x) { return pure(x); }
inline Measure atanh(const Measure& x) { return pure(x); }
inline Measure exp(const Measure& x) { return pure(x); }
inline Measure log(const Measure& x) { return pure(x); }
inline Measure atan2(const Measure& y, const Measure& x) { return pure((y + x) / (y + x)); }

}  // namespace oddity::problem
