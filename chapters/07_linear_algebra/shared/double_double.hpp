#pragma once

#include <cmath>

namespace oddity {

/// A number of 106 significant bits as the sum of two doubles, the second below half a unit in the last place
/// of the first. Relative errors are about 2^-104 for products and sums. Products: Dekker (1971) with the
/// exact product of std::fma. Sums: the accurate form, Joldes, Muller and Popescu (2017), algorithm 6.
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double x) : high(x) {}
  DoubleDouble(double h, double l) : high(h), low(l) {}
  explicit operator double() const { return high; }

  static DoubleDouble sum(double a, double b) {
    const double s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
  }
  static DoubleDouble ordered_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  friend DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
  friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = sum(a.high, b.high), t = sum(a.low, b.low);
    const DoubleDouble u = ordered_sum(s.high, s.low + t.high);
    return ordered_sum(u.high, u.low + t.low);
  }
  friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
  friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = product(a.high, b.high);
    return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - DoubleDouble(first) * b;
    return ordered_sum(first, rest.high / b.high);
  }
};

}  // namespace oddity
