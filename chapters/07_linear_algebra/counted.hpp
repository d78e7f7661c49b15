#pragma once

/// Number types that tell about an algorithm: what it costs, and whether it is right.
namespace oddity {

/// What operations cost: so many multiplications, additions (and subtractions), divisions.
struct Cost {
  double mu = 0, alpha = 0, delta = 0;

  friend constexpr Cost operator+(Cost a, Cost b) {
    return {a.mu + b.mu, a.alpha + b.alpha, a.delta + b.delta};
  }
  friend constexpr Cost operator*(double x, Cost a) { return {x * a.mu, x * a.alpha, x * a.delta}; }
  friend constexpr Cost operator-(Cost a, Cost b) { return a + -1.0 * b; }
};

/// A number whose operations are counted in the cost that it points to.
template <class T>
struct Counted {
  T value{};
  Cost* cost = nullptr;

  friend Counted operator+(Counted a, Counted b) {
    return ++a.cost->alpha, Counted{a.value + b.value, a.cost};
  }
  friend Counted operator-(Counted a, Counted b) {
    return ++a.cost->alpha, Counted{a.value - b.value, a.cost};
  }
  friend Counted operator*(Counted a, Counted b) { return ++a.cost->mu, Counted{a.value * b.value, a.cost}; }
  friend Counted operator/(Counted a, Counted b) {
    return ++a.cost->delta, Counted{a.value / b.value, a.cost};
  }
};

/// The integers modulo the prime 2^31 - 1: exact, without growth.
struct Residue {
  static constexpr unsigned long long prime = 2147483647;
  unsigned long long value = 0;

  friend Residue operator+(Residue a, Residue b) { return {(a.value + b.value) % prime}; }
  friend Residue operator-(Residue a, Residue b) { return {(a.value + prime - b.value) % prime}; }
  friend Residue operator*(Residue a, Residue b) { return {a.value * b.value % prime}; }
  friend Residue operator/(Residue a, Residue b) {
    Residue inverse{1};
    for (auto power = prime - 2; power > 0; power >>= 1, b = b * b)
      if (power & 1) inverse = inverse * b;
    return a * inverse;
  }
};

}  // namespace oddity
