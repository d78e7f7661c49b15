#pragma once

namespace oddity::elimination {

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

}  // namespace oddity::elimination
