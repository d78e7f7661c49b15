// The functions of the C library, each off by one rounding up or down, as another library's may be. The
// models' module linked with these shows which motions depend on them, and how much.

#include <cstdint>
#include <limits>

namespace {

/// Up or down by one rounding, in turn by a generator of Knuth's: each run of a motion has others.
template <class T>
T nudged(T x) {
  static std::uint64_t state = 1;
  state = state * 6364136223846793005 + 1442695040888963407;
  return x * (1 + (state >> 63 ? 1 : -1) * std::numeric_limits<T>::epsilon());
}

}  // namespace

// Names for the linker (--wrap).
#define ODDITY_ONE(name, T)      \
  extern "C" T __real_##name(T); \
  extern "C" T __wrap_##name(T x) { return nudged(__real_##name(x)); }
#define ODDITY_TWO(name, T)         \
  extern "C" T __real_##name(T, T); \
  extern "C" T __wrap_##name(T x, T y) { return nudged(__real_##name(x, y)); }
#define ODDITY_NUDGED(F, name) F(name, double) F(name##f, float)

ODDITY_NUDGED(ODDITY_ONE, sin)
ODDITY_NUDGED(ODDITY_ONE, cos)
ODDITY_NUDGED(ODDITY_ONE, tan)
ODDITY_NUDGED(ODDITY_ONE, asin)
ODDITY_NUDGED(ODDITY_ONE, acos)
ODDITY_NUDGED(ODDITY_ONE, exp)
ODDITY_NUDGED(ODDITY_ONE, expm1)
ODDITY_NUDGED(ODDITY_ONE, log)
ODDITY_NUDGED(ODDITY_ONE, sinh)
ODDITY_NUDGED(ODDITY_ONE, cosh)
ODDITY_NUDGED(ODDITY_ONE, asinh)
ODDITY_NUDGED(ODDITY_TWO, atan2)
ODDITY_NUDGED(ODDITY_TWO, hypot)
ODDITY_NUDGED(ODDITY_TWO, pow)
