#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

/// Registers of several numbers, as vectors of GCC and clang, and the operations that these lack. A plain
/// float or double is a register of one.
namespace oddity::lanes {

/// The instruction sets that lanes are compiled for, each a separate type, so that functions made for
/// different sets have different names.
struct One {
  static constexpr std::size_t bytes = 0;
};
/// SSE2 on x86-64: available on every machine of the architecture.
struct Baseline {
  static constexpr std::size_t bytes = 16;
};
struct Avx2 {
  static constexpr std::size_t bytes = 32;
};
struct Avx512 {
  static constexpr std::size_t bytes = 64;
};
/// The widest set for which this file is compiled.
#if defined(__AVX512DQ__) && defined(__AVX512VL__)
using Native = Avx512;
#elif defined(__AVX2__)
using Native = Avx2;
#else
using Native = Baseline;
#endif

template <class T, std::size_t bytes>
struct RegisterOf {
  typedef T type __attribute__((vector_size(bytes)));
};
template <class T>
struct RegisterOf<T, 0> {
  using type = T;
};

/// The number type of a register, and the integer register that its comparisons return.
template <class V>
struct Of {
  using Number = std::remove_cvref_t<decltype(V()[0])>;
  using Whole = decltype(V() == V());
};
template <>
struct Of<double> {
  using Number = double;
  using Whole = std::int64_t;
};
template <>
struct Of<float> {
  using Number = float;
  using Whole = std::int32_t;
};
template <class V>
using Number = typename Of<V>::Number;
template <class V>
using Whole = typename Of<V>::Whole;

template <class V>
constexpr std::size_t count = sizeof(V) / sizeof(Number<V>);

template <class V>
[[gnu::always_inline]] inline Whole<V> bits(const V& x) {
  return std::bit_cast<Whole<V>>(x);
}
template <class V>
[[gnu::always_inline]] inline V from_bits(const Whole<V>& x) {
  return std::bit_cast<V>(x);
}
template <class V>
[[gnu::always_inline]] inline V all(Number<V> x) {
  return V{} + x;
}

// ---- roots, the lesser and the greater, and a bit for each lane whose condition holds ---------------------

inline double sqrt(double x) { return std::sqrt(x); }
inline float sqrt(float x) { return std::sqrt(x); }
/// a < b ? a : b and a > b ? a : b, as on x86: the second if one is NaN.
inline double lesser(double a, double b) { return a < b ? a : b; }
inline float lesser(float a, float b) { return a < b ? a : b; }
inline double greater(double a, double b) { return a > b ? a : b; }
inline float greater(float a, float b) { return a > b ? a : b; }

#if defined(__x86_64__)
[[gnu::always_inline]] inline __m128d sqrt(__m128d x) { return _mm_sqrt_pd(x); }
[[gnu::always_inline]] inline __m128 sqrt(__m128 x) { return _mm_sqrt_ps(x); }
[[gnu::always_inline]] inline __m128d lesser(__m128d a, __m128d b) { return _mm_min_pd(a, b); }
[[gnu::always_inline]] inline __m128 lesser(__m128 a, __m128 b) { return _mm_min_ps(a, b); }
[[gnu::always_inline]] inline __m128d greater(__m128d a, __m128d b) { return _mm_max_pd(a, b); }
[[gnu::always_inline]] inline __m128 greater(__m128 a, __m128 b) { return _mm_max_ps(a, b); }
template <class V>
requires(sizeof(V) == 16) [[gnu::always_inline]] inline unsigned ones(const V& mask) {
  if constexpr (count<V> == 2)
    return static_cast<unsigned>(_mm_movemask_pd(std::bit_cast<__m128d>(mask)));
  else
    return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(mask)));
}
#if defined(__AVX2__)
[[gnu::always_inline]] inline __m256d sqrt(__m256d x) { return _mm256_sqrt_pd(x); }
[[gnu::always_inline]] inline __m256 sqrt(__m256 x) { return _mm256_sqrt_ps(x); }
[[gnu::always_inline]] inline __m256d lesser(__m256d a, __m256d b) { return _mm256_min_pd(a, b); }
[[gnu::always_inline]] inline __m256 lesser(__m256 a, __m256 b) { return _mm256_min_ps(a, b); }
[[gnu::always_inline]] inline __m256d greater(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
[[gnu::always_inline]] inline __m256 greater(__m256 a, __m256 b) { return _mm256_max_ps(a, b); }
template <class V>
requires(sizeof(V) == 32) [[gnu::always_inline]] inline unsigned ones(const V& mask) {
  if constexpr (count<V> == 4)
    return static_cast<unsigned>(_mm256_movemask_pd(std::bit_cast<__m256d>(mask)));
  else
    return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
}
#endif
#if defined(__AVX512DQ__)
[[gnu::always_inline]] inline __m512d sqrt(__m512d x) { return _mm512_maskz_sqrt_pd(0xff, x); }
[[gnu::always_inline]] inline __m512 sqrt(__m512 x) { return _mm512_maskz_sqrt_ps(0xffff, x); }
[[gnu::always_inline]] inline __m512d lesser(__m512d a, __m512d b) { return _mm512_maskz_min_pd(0xff, a, b); }
[[gnu::always_inline]] inline __m512 lesser(__m512 a, __m512 b) { return _mm512_maskz_min_ps(0xffff, a, b); }
[[gnu::always_inline]] inline __m512d greater(__m512d a, __m512d b) {
  return _mm512_maskz_max_pd(0xff, a, b);
}
[[gnu::always_inline]] inline __m512 greater(__m512 a, __m512 b) { return _mm512_maskz_max_ps(0xffff, a, b); }
template <class V>
requires(sizeof(V) == 64) [[gnu::always_inline]] inline unsigned ones(const V& mask) {
  if constexpr (count<V> == 8)
    return static_cast<unsigned>(_mm512_movepi64_mask(std::bit_cast<__m512i>(mask)));
  else
    return static_cast<unsigned>(_mm512_movepi32_mask(std::bit_cast<__m512i>(mask)));
}
#endif
#else
template <class V>
[[gnu::always_inline]] inline V sqrt(V x) {
  for (std::size_t i = 0; i < count<V>; ++i) x[i] = std::sqrt(x[i]);
  return x;
}
template <class V>
[[gnu::always_inline]] inline V lesser(V a, V b) {
  return a < b ? a : b;
}
template <class V>
[[gnu::always_inline]] inline V greater(V a, V b) {
  return a > b ? a : b;
}
template <class V>
[[gnu::always_inline]] inline unsigned ones(const V& mask) {
  unsigned all = 0;
  for (std::size_t i = 0; i < count<V>; ++i) all |= (mask[i] != 0 ? 1u : 0u) << i;
  return all;
}
#endif
[[gnu::always_inline]] inline unsigned ones(bool condition) { return condition ? 1 : 0; }

}  // namespace oddity::lanes
