#pragma once

#include <cmath>
#include <compare>
#include <utility>

/// A number that counts the operations of an algorithm.
namespace oddity {

struct Operations {
  long additions = 0;  ///< additions and subtractions
  long multiplications = 0;
  long divisions = 0;
  long functions = 0;  ///< roots, sines and the like; roundings to whole numbers

  long all_but_additions() const { return multiplications + divisions + functions; }
};

namespace detail {

inline thread_local Operations operations;

}  // namespace detail

/// Operations of run() on counted numbers of any type, in this thread.
template <class Run>
Operations operations_of(const Run& run) {
  const Operations before = std::exchange(detail::operations, {});
  static_cast<void>(run());
  return std::exchange(detail::operations, before);
}

template <class T>
class Counted {
 public:
  Counted() = default;
  Counted(T value) : value_(value) {}

  const T& value() const { return value_; }
  explicit operator T() const { return value_; }

  friend Counted operator-(const Counted& a) { return -a.value_; }
  friend Counted operator+(const Counted& a, const Counted& b) {
    return ++detail::operations.additions, a.value_ + b.value_;
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    return ++detail::operations.additions, a.value_ - b.value_;
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    return ++detail::operations.multiplications, a.value_ * b.value_;
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    return ++detail::operations.divisions, a.value_ / b.value_;
  }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }

  friend bool operator==(const Counted&, const Counted&) = default;
  friend auto operator<=>(const Counted&, const Counted&) = default;

  friend Counted abs(const Counted& a) {
    using std::abs;
    return abs(a.value_);
  }
  friend Counted sqrt(const Counted& a) {
    using std::sqrt;
    return function(sqrt(a.value_));
  }
  friend Counted sin(const Counted& a) {
    using std::sin;
    return function(sin(a.value_));
  }
  friend Counted cos(const Counted& a) {
    using std::cos;
    return function(cos(a.value_));
  }
  friend Counted exp(const Counted& a) {
    using std::exp;
    return function(exp(a.value_));
  }
  friend Counted atan2(const Counted& y, const Counted& x) {
    using std::atan2;
    return function(atan2(y.value_, x.value_));
  }
  friend Counted hypot(const Counted& x, const Counted& y) {
    using std::hypot;
    return function(hypot(x.value_, y.value_));
  }
  friend Counted floor(const Counted& a) {
    using std::floor;
    return function(floor(a.value_));
  }
  friend Counted ceil(const Counted& a) {
    using std::ceil;
    return function(ceil(a.value_));
  }

 private:
  static Counted function(T value) {
    ++detail::operations.functions;
    return value;
  }

  T value_{};
};

}  // namespace oddity
