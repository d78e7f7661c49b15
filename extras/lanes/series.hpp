#pragma once

#include "extras/lanes/registers.hpp"

/// Coefficients of functions.hpp: interpolations at Chebyshev's nodes, in 60 digits, of the remainder of each
/// function after its first terms. Their errors are below 2^-56.5 and, for float, 2^-28.
namespace oddity::lanes {

template <class T>
struct Series;

template <class V>
constexpr Number<V> unit = std::numeric_limits<Number<V>>::epsilon() / 2;

// clang-format off
template <>
struct Series<double> {
  static constexpr int width = 64, digits = 52, bias = 1023;
  static constexpr std::int64_t size_bits = 0x7fff'ffff'ffff'ffff;
  static constexpr double shift = 0x1.8p52;  ///< adding it rounds a number to a whole one in its last bits
  // pi/2 and log 2 in parts
  static constexpr std::array quarter{0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
  static constexpr std::array half_quarter{0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55};
  static constexpr double quarters_per_radian = 0x1.45f306dc9c883p-1, angle_limit = 0x1.8p20;
  static constexpr std::array octave{0x1.62e42fefa38p-1, 0x1.ef35793c76730p-45};
  static constexpr double octaves_per_one = 0x1.71547652b82fep+0, root_half = 0x1.6a09e667f3bcdp-1;
  static constexpr double least_exponent = -746, most_exponent = 710, tangent_of_eighth = 0x1.a827999fcef32p-2;
  /// (sin r / r - 1) / r^2 in r^2, r up to pi/4
  static constexpr std::array sine{
      -0x1.5555555555555p-3, 0x1.1111111111110p-7, -0x1.a01a01a0198dep-13, 0x1.71de3a5455b9ap-19, -0x1.ae64540000f84p-26,
      0x1.6121703ee57b1p-33, -0x1.ab0f25d21fd92p-41};
  /// (cos r - 1 + r^2 / 2) / r^4 in r^2, r up to pi/4
  static constexpr std::array cosine{
      0x1.5555555555555p-5, -0x1.6c16c16c16944p-10, 0x1.a01a019f4671dp-16, -0x1.27e4fa0d3726cp-22, 0x1.1eeb5de1e2b95p-29,
      -0x1.9075bb669682cp-37};
  /// (exp r - 1 - r) / r^2, r up to log 2 / 2
  static constexpr std::array exponential{
      0x1.0000000000000p-1, 0x1.5555555555557p-3, 0x1.5555555555556p-5, 0x1.111111110ff87p-7, 0x1.6c16c16c16212p-10,
      0x1.a01a01aca0134p-13, 0x1.a01a01a741b3cp-16, 0x1.71ddffef9e7b1p-19, 0x1.27e4da1a3bf04p-22, 0x1.af52906239de4p-26,
      0x1.1f75aba0b1e2ep-29};
  /// (2 artanh s / s - 2) / s^2 in s^2, s up to (sqrt 2 - 1) / (sqrt 2 + 1)
  static constexpr std::array logarithm{
      0x1.5555555555558p-1, 0x1.9999999994e76p-2, 0x1.2492492e6dfddp-2, 0x1.c71c6247410e3p-3, 0x1.7462e17b4cdd0p-3,
      0x1.39f8963ccbdc2p-3, 0x1.2b9f7fb3de73fp-3};
  /// (arctan t / t - 1) / t^2 in t^2, t up to tan(pi/8)
  static constexpr std::array arctangent{
      -0x1.5555555555555p-2, 0x1.99999999992b1p-3, -0x1.249249242e44ap-3, 0x1.c71c718053ec6p-4, -0x1.745d0a620f485p-4,
      0x1.3b125117d4164p-4, -0x1.10f97c604830ap-4, 0x1.dfd550f02f5dap-5, -0x1.a0413ef02020ep-5, 0x1.4064bd87c0666p-5,
      -0x1.37c6a16c69300p-6};
};

template <>
struct Series<float> {
  static constexpr int width = 32, digits = 23, bias = 127;
  static constexpr std::int32_t size_bits = 0x7fff'ffff;
  static constexpr float shift = 0x1.8p23f;
  static constexpr std::array quarter{0x1.922p+0f, -0x1.2aep-18f, -0x1.de973ep-31f};
  static constexpr std::array half_quarter{0x1.921fb6p-1f, -0x1.777a5cp-26f};
  static constexpr float quarters_per_radian = 0x1.45f306p-1f, angle_limit = 0x1.8p12f;
  static constexpr std::array octave{0x1.62e4p-1f, 0x1.7f7d1cp-20f};
  static constexpr float octaves_per_one = 0x1.715476p+0f, root_half = 0x1.6a09e6p-1f;
  static constexpr float least_exponent = -104, most_exponent = 89, tangent_of_eighth = 0x1.a8279ap-2f;
  static constexpr std::array sine{-0x1.555556p-3f, 0x1.11110ep-7f, -0x1.a01388p-13f, 0x1.6db388p-19f};
  static constexpr std::array cosine{0x1.555554p-5f, -0x1.6c12bep-10f, 0x1.9bcdc6p-16f};
  static constexpr std::array exponential{0x1p-1f, 0x1.555556p-3f, 0x1.5554e4p-5f, 0x1.1110e0p-7f, 0x1.6d492p-10f, 0x1.a12a42p-13f};
  static constexpr std::array logarithm{0x1.55555cp-1f, 0x1.997b96p-2f, 0x1.2f013ep-2f};
  static constexpr std::array arctangent{-0x1.555554p-2f, 0x1.99971ap-3f, -0x1.241d1ep-3f, 0x1.b7cdc4p-4f, -0x1.076a54p-4f};
};
// clang-format on

}  // namespace oddity::lanes
