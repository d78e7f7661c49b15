#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace oddity {

/// Random samples that are the same on every machine: SplitMix64 [Steele, Lea, Flood, OOPSLA 2014] with our
/// own distributions.
class Random {
 public:
  explicit Random(double seed) : state_(static_cast<std::uint64_t>(seed)) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// In 0, ..., n-1.
  int below(int n) { return static_cast<int>(unit() * n); }
  /// A size between low and high, log-uniform, of either sign.
  double magnitude(double low, double high) {
    const double size = std::exp(between(std::log(low), std::log(high)));
    return unit() < 0.5 ? -size : size;
  }
  /// Standard normal (Box-Muller).
  double normal() {
    const double radius = std::sqrt(-2 * std::log(1 - unit()));
    return radius * std::cos(2 * std::numbers::pi * unit());
  }
  /// A point of the cube [-size, size]^3.
  std::array<double, 3> point(double size = 1) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }
  /// Uniform on the unit sphere.
  std::array<double, 3> direction() {
    const double z = between(-1, 1), angle = between(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::uint64_t state_;
};

}  // namespace oddity
