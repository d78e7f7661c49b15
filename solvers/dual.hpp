#pragma once

#include <cmath>
#include <concepts>

/// Derivatives exact to rounding, of any function that is generic in its number type.
///
///   const Dual<double> x(2, 1);
///   std::cout << (x * sqrt(x)).slope;  // 3/2 sqrt(2)
namespace oddity {

/// A number and its derivative in one direction (forward-mode differentiation, exact to rounding).
/// Dual<Dual<double>> carries second derivatives, and so on.
template <class T>
struct Dual {
  T value{};
  T slope{};

  Dual() = default;
  Dual(T v, T s) : value(v), slope(s) {}
  /// A constant.
  template <class U>
  requires std::convertible_to<U, T> Dual(const U& v) : value(static_cast<T>(v)), slope(static_cast<T>(0)) {}

  Dual& operator+=(const Dual& o) { return *this = *this + o; }
  Dual& operator-=(const Dual& o) { return *this = *this - o; }
  Dual& operator*=(const Dual& o) { return *this = *this * o; }
  Dual& operator/=(const Dual& o) { return *this = *this / o; }

  friend Dual operator+(const Dual& a) { return a; }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return b < a; }
};

/// f(a) with the chain rule's factor f'(a).
template <class T>
Dual<T> chained(const Dual<T>& a, const T& value, const T& derivative) {
  return {value, derivative * a.slope};
}

template <class T>
Dual<T> sqrt(const Dual<T>& a) {
  using std::sqrt;
  const T root = sqrt(a.value);
  return {root, a.slope / (T(2.0) * root)};
}
template <class T>
Dual<T> sin(const Dual<T>& a) {
  using std::cos, std::sin;
  return chained(a, T(sin(a.value)), T(cos(a.value)));
}
template <class T>
Dual<T> cos(const Dual<T>& a) {
  using std::cos, std::sin;
  return chained(a, T(cos(a.value)), T(-sin(a.value)));
}
template <class T>
Dual<T> tan(const Dual<T>& a) {
  return sin(a) / cos(a);
}
template <class T>
Dual<T> exp(const Dual<T>& a) {
  using std::exp;
  const T power = exp(a.value);
  return chained(a, power, power);
}
template <class T>
Dual<T> log(const Dual<T>& a) {
  using std::log;
  return chained(a, T(log(a.value)), T(T(1.0) / a.value));
}
template <class T>
Dual<T> asin(const Dual<T>& a) {
  using std::asin, std::sqrt;
  return chained(a, T(asin(a.value)), T(T(1.0) / sqrt(T(1.0) - a.value * a.value)));
}
template <class T>
Dual<T> acos(const Dual<T>& a) {
  using std::acos, std::sqrt;
  return chained(a, T(acos(a.value)), T(T(-1.0) / sqrt(T(1.0) - a.value * a.value)));
}
template <class T>
Dual<T> atan2(const Dual<T>& y, const Dual<T>& x) {
  using std::atan2;
  return {atan2(y.value, x.value),
          (x.value * y.slope - y.value * x.slope) / (x.value * x.value + y.value * y.value)};
}
template <class T>
Dual<T> abs(const Dual<T>& a) {
  return a.value < T(0) ? -a : a;
}
template <class T>
Dual<T> hypot(const Dual<T>& x, const Dual<T>& y) {
  using std::hypot;
  const T length = hypot(x.value, y.value);
  return {length, (x.value * x.slope + y.value * y.slope) / length};
}
template <class T>
Dual<T> expm1(const Dual<T>& a) {
  using std::exp, std::expm1;
  return chained(a, T(expm1(a.value)), T(exp(a.value)));
}
template <class T>
Dual<T> sinh(const Dual<T>& a) {
  using std::cosh, std::sinh;
  return chained(a, T(sinh(a.value)), T(cosh(a.value)));
}
template <class T>
Dual<T> cosh(const Dual<T>& a) {
  using std::cosh, std::sinh;
  return chained(a, T(cosh(a.value)), T(sinh(a.value)));
}
template <class T>
Dual<T> asinh(const Dual<T>& a) {
  using std::asinh, std::sqrt;
  return chained(a, T(asinh(a.value)), T(T(1.0) / sqrt(T(1.0) + a.value * a.value)));
}
/// The sign is constant between its jumps, which have no derivative.
template <class T>
Dual<T> copysign(const Dual<T>& a, const Dual<T>& sign) {
  return (a.value < T(0)) == (sign.value < T(0)) ? a : -a;
}
/// a - n b, with the integer n of the values' remainder.
template <class T>
Dual<T> remainder(const Dual<T>& a, const Dual<T>& b) {
  using std::remainder;
  const T rest = remainder(a.value, b.value);
  return {rest, a.slope - (a.value - rest) / b.value * b.slope};
}
/// a to a constant power.
template <class T>
Dual<T> pow(const Dual<T>& a, double exponent) {
  using std::pow;
  if (exponent == 0) return Dual<T>(1.0);  // the slope is zero even at a = 0
  return chained(a, T(pow(a.value, exponent)), T(exponent * pow(a.value, exponent - 1)));
}

/// f'(x), f being generic in its number type.
template <class F, class T>
T derivative(const F& f, const T& x) {
  static_assert(!std::integral<T>, "a derivative of whole numbers");
  return f(Dual<T>(x, T(1.0))).slope;
}

/// f''(x).
template <class F, class T>
T second_derivative(const F& f, const T& x) {
  static_assert(!std::integral<T>, "a derivative of whole numbers");
  return derivative([&](const auto& y) { return derivative(f, y); }, x);
}

}  // namespace oddity
