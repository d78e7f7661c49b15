#pragma once

#include "reference/truth.hpp"

/// First derivatives by dual numbers x + dx e, e^2 = 0: of numbers, of numbers recorded on a tape, and of
/// dual numbers, which gives second derivatives.
namespace oddity::truth {

template <class T>
struct Dual {
  T x, dx;

  friend Dual operator-(const Dual& a) { return {-a.x, -a.dx}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.x + b.x, a.dx + b.dx}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.x - b.x, a.dx - b.dx}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.x * b.x, a.dx * b.x + a.x * b.dx}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T q = a.x / b.x;
    return {q, (a.dx - q * b.dx) / b.x};
  }
  friend Dual operator+(const Dual& a, const Number& k) { return {a.x + k, a.dx}; }
  friend Dual operator+(const Number& k, const Dual& a) { return {k + a.x, a.dx}; }
  friend Dual operator-(const Dual& a, const Number& k) { return {a.x - k, a.dx}; }
  friend Dual operator-(const Number& k, const Dual& a) { return {k - a.x, -a.dx}; }
  friend Dual operator*(const Number& k, const Dual& a) { return {k * a.x, k * a.dx}; }
  friend Dual operator/(const Dual& a, const Number& k) { return {a.x / k, a.dx / k}; }
  friend Dual operator/(const Number& k, const Dual& a) {
    const T q = k / a.x;
    return {q, -(q * a.dx) / a.x};
  }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend Dual sqrt(const Dual& a) {
    const T root = sqrt(a.x);
    return {root, a.dx / (root + root)};
  }
  friend Dual exp(const Dual& a) {
    const T power = exp(a.x);
    return {power, power * a.dx};
  }
  friend Dual sin(const Dual& a) { return {sin(a.x), cos(a.x) * a.dx}; }
  friend Dual cos(const Dual& a) { return {cos(a.x), -(sin(a.x) * a.dx)}; }
};

}  // namespace oddity::truth
