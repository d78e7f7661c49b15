// Elementary functions with one more unit of error in the last place, up, down or none, like another C
// library. For a program that loads this before its libraries (LD_PRELOAD). The error depends only on
// ODDITY_SEED and the arguments, so a function stays a function. Exact values stay exact, and none leaves the
// function's range.

#include <dlfcn.h>

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdlib>

namespace {

using std::uint64_t;

/// Splitmix64's finalizer.
uint64_t mixed(uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

uint64_t seed() {
  static const uint64_t value = [] {
    const char* text = std::getenv("ODDITY_SEED");
    return mixed(text ? std::strtoull(text, nullptr, 10) + 1 : 1);
  }();
  return value;
}

uint64_t bits(double x) { return std::bit_cast<uint64_t>(x); }
uint64_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }

/// Whole numbers are exact values, or ends of a range: sin 0, exp 0, pow(2, 3), cos 0, acos 1.
template <std::floating_point T>
T shaken(T exact, uint64_t function, uint64_t arguments) {
  if (!std::isfinite(exact) || exact == std::round(exact)) return exact;
  switch (mixed(mixed(seed() ^ function) ^ arguments) % 3) {
    case 0:
      return std::nextafter(exact, T(0));
    case 1:
      return std::nextafter(exact, std::copysign(T(INFINITY), exact));
    default:
      return exact;
  }
}

uint64_t hash(const char* name) {
  uint64_t h = 0;
  while (*name) h = 131 * h + static_cast<unsigned char>(*name++);
  return h;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#define SHAKEN_1(T, name)                          \
  extern "C" T name(T x) noexcept {                \
    static auto* const exact = next<T(T)>(#name);  \
    return shaken(exact(x), hash(#name), bits(x)); \
  }
#define SHAKEN_2(T, name)                                              \
  extern "C" T name(T x, T y) noexcept {                               \
    static auto* const exact = next<T(T, T)>(#name);                   \
    return shaken(exact(x, y), hash(#name), bits(x) ^ mixed(bits(y))); \
  }
#define SHAKEN(name)     \
  SHAKEN_1(double, name) \
  SHAKEN_1(float, name##f)

SHAKEN(sin)
SHAKEN(cos)
SHAKEN(tan)
SHAKEN(asin)
SHAKEN(acos)
SHAKEN(atan)
SHAKEN(sinh)
SHAKEN(cosh)
SHAKEN(tanh)
SHAKEN(asinh)
SHAKEN(acosh)
SHAKEN(atanh)
SHAKEN(exp)
SHAKEN(expm1)
SHAKEN(log)
SHAKEN(log1p)
SHAKEN(log2)
SHAKEN(log10)
SHAKEN(cbrt)
SHAKEN_2(double, pow)
SHAKEN_2(float, powf)
SHAKEN_2(double, atan2)
SHAKEN_2(float, atan2f)
SHAKEN_2(double, hypot)
SHAKEN_2(float, hypotf)

extern "C" void sincos(double x, double* s, double* c) noexcept {
  *s = sin(x);
  *c = cos(x);
}
extern "C" void sincosf(float x, float* s, float* c) noexcept {
  *s = sinf(x);
  *c = cosf(x);
}
