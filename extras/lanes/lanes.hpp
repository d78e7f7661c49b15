#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>

#include "extras/lanes/functions.hpp"

namespace oddity::lanes {

/// A truth value for each lane.
template <class T, class Set, int registers>
struct Mask {
  using One =
      decltype(typename RegisterOf<T, Set::bytes>::type() == typename RegisterOf<T, Set::bytes>::type());
  One m[registers];

  [[gnu::always_inline]] friend Mask operator&(const Mask& a, const Mask& b) {
    return made([&](int r) __attribute__((always_inline)) { return a.m[r] & b.m[r]; });
  }
  [[gnu::always_inline]] friend Mask operator|(const Mask& a, const Mask& b) {
    return made([&](int r) __attribute__((always_inline)) { return a.m[r] | b.m[r]; });
  }
  [[gnu::always_inline]] friend Mask operator!(const Mask& a) {
    return made([&](int r) __attribute__((always_inline)) { return a.m[r] == One{}; });
  }
  template <class F>
  [[gnu::always_inline]] static Mask made(const F& f) {
    if constexpr (registers == 1)
      return {{static_cast<One>(f(0))}};
    else if constexpr (registers == 2)
      return {{static_cast<One>(f(0)), static_cast<One>(f(1))}};
    else
      return {
          {static_cast<One>(f(0)), static_cast<One>(f(1)), static_cast<One>(f(2)), static_cast<One>(f(3))}};
  }
  [[gnu::always_inline]] bool any() const {
    if constexpr (registers == 1)
      return ones(m[0]) != 0;
    else if constexpr (registers == 2)
      return ones(m[0] | m[1]) != 0;
    else
      return ones((m[0] | m[1]) | (m[2] | m[3])) != 0;
  }
  /// A bit for each lane.
  std::uint64_t bits() const {
    std::uint64_t all = ones(m[0]);
    for (int r = 1; r < registers; ++r) all |= std::uint64_t(ones(m[r])) << (r * lanes_each);
    return all;
  }

 private:
  static constexpr int lanes_each = Set::bytes == 0 ? 1 : Set::bytes / sizeof(T);
};

/// Several numbers side by side, as a number type for models: one, two or four registers of an instruction
/// set. Several registers keep the machine busy while it waits for one. A lane's result depends on that lane
/// alone, and has the same bits in any number of lanes and on any instruction set. Lanes<T, One, 1> is a
/// single number.
template <class T, class Set = Native, int registers = 1>
class Lanes {
  static_assert(registers == 1 || registers == 2 || registers == 4);

 public:
  using Register = typename RegisterOf<T, Set::bytes>::type;
  using Mask = lanes::Mask<T, Set, registers>;
  using value_type = T;

  static constexpr std::size_t size() { return registers * count<Register>; }
  static constexpr bool in_one_register = registers == 1;

  Lanes() = default;
  template <class A>
  requires std::is_arithmetic_v<A>
  [[gnu::always_inline]] explicit(!std::integral<A> && !std::same_as<A, T>) Lanes(A x)
      : Lanes(made([&](int) { return all<Register>(static_cast<T>(x)); })) {}

  /// Read from memory: otherwise g++ writes out a whole register for one lane.
  T operator[](std::size_t lane) const {
    T x;
    std::memcpy(&x, reinterpret_cast<const std::byte*>(v_) + lane * sizeof(T), sizeof(T));
    return x;
  }
  void set(std::size_t lane, T x) {
    if constexpr (Set::bytes == 0)
      v_[lane] = x;
    else
      v_[lane / count<Register>][lane % count<Register>] = x;
  }

#define ODDITY_IN_EACH(T, expression) \
  T::made([&](int r) __attribute__((always_inline)) { return expression; })
#define ODDITY_OPERATOR(T, op)                                                  \
  [[gnu::always_inline]] friend T operator op(const Lanes& a, const Lanes& b) { \
    return ODDITY_IN_EACH(T, a.v_[r] op b.v_[r]);                               \
  }
#define ODDITY_OF_ONE(f) \
  friend Lanes f(const Lanes& x) { return ODDITY_IN_EACH(Lanes, lanes::f(x.v_[r])); }
#define ODDITY_OF_TWO(f) \
  friend Lanes f(const Lanes& x, const Lanes& y) { return ODDITY_IN_EACH(Lanes, lanes::f(x.v_[r], y.v_[r])); }

  ODDITY_OPERATOR(Lanes, +)
  ODDITY_OPERATOR(Lanes, -)
  ODDITY_OPERATOR(Lanes, *)
  ODDITY_OPERATOR(Lanes, /)
  ODDITY_OPERATOR(Mask, <)
  ODDITY_OPERATOR(Mask, >)
  ODDITY_OPERATOR(Mask, <=)
  ODDITY_OPERATOR(Mask, >=)
  ODDITY_OPERATOR(Mask, ==)
  [[gnu::always_inline]] friend Lanes operator-(const Lanes& a) { return ODDITY_IN_EACH(Lanes, -a.v_[r]); }
  [[gnu::always_inline]] friend Lanes operator+(const Lanes& a) { return a; }
  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  Lanes& operator*=(const Lanes& b) { return *this = *this * b; }
  Lanes& operator/=(const Lanes& b) { return *this = *this / b; }

  // clang-format off
  ODDITY_OF_ONE(exp)
  ODDITY_OF_ONE(expm1)
  ODDITY_OF_ONE(log)
  ODDITY_OF_ONE(asin)
  ODDITY_OF_ONE(sinh)
  ODDITY_OF_ONE(cosh)
  ODDITY_OF_ONE(asinh)
  ODDITY_OF_ONE(inverse_fifth_root)
  ODDITY_OF_TWO(atan2)
  ODDITY_OF_TWO(copysign)
  ODDITY_OF_TWO(remainder)
  // Functions used in right-hand sides are inlined, so that sine and cosine share their work.
  [[gnu::always_inline]] ODDITY_OF_ONE(abs)
  [[gnu::always_inline]] ODDITY_OF_ONE(sqrt)
  [[gnu::always_inline]] ODDITY_OF_TWO(larger_size)
  [[gnu::always_inline]] ODDITY_OF_TWO(lesser)
  [[gnu::always_inline]] ODDITY_OF_TWO(greater)
  [[gnu::always_inline]] ODDITY_OF_TWO(hypot)
      // clang-format on
      friend Lanes hypot(const Lanes& x, const Lanes& y, const Lanes& z) {
    return sqrt(x * x + y * y + z * z);
  }
  [[gnu::always_inline]] friend Lanes sin(const Lanes& x) {
    return x.or_by_library(
        ODDITY_IN_EACH(Lanes, lanes::sine_from(x.v_[r], T(0))), +[](T one) { return std::sin(one); });
  }
  [[gnu::always_inline]] friend Lanes cos(const Lanes& x) {
    return x.or_by_library(
        ODDITY_IN_EACH(Lanes, lanes::sine_from(x.v_[r], T(1))), +[](T one) { return std::cos(one); });
  }

#undef ODDITY_OF_TWO
#undef ODDITY_OF_ONE
#undef ODDITY_OPERATOR
#undef ODDITY_IN_EACH

  /// Selects lane by lane.
  [[gnu::always_inline]] friend Lanes select(const Mask& condition, const Lanes& yes, const Lanes& no) {
    return made([&](int r) __attribute__((always_inline)) { return condition.m[r] ? yes.v_[r] : no.v_[r]; });
  }

 private:
  /// y, or the C library's value where the angle is too large: tested once for all registers.
  [[gnu::always_inline]] Lanes or_by_library(Lanes y, T (*by_library)(T)) const {
    constexpr T limit = Series<T>::angle_limit;
    if ((abs(*this) > Lanes(limit)).any()) [[unlikely]]
      for (int r = 0; r < registers; ++r)
        y.v_[r] = corrected_beyond<Register>(y.v_[r], v_[r], limit, by_library);
    return y;
  }

  template <class F>
  [[gnu::always_inline]] static Lanes made(const F& f) {
    Lanes x;
    x.v_[0] = f(0);
    if constexpr (registers > 1) x.v_[1] = f(1);
    if constexpr (registers > 2) x.v_[2] = f(2), x.v_[3] = f(3);
    return x;
  }

  Register v_[registers];
};

template <class T, class Set, int registers, std::size_t n>
[[gnu::always_inline]] inline std::array<Lanes<T, Set, registers>, n> select(
    const Mask<T, Set, registers>& condition, const std::array<Lanes<T, Set, registers>, n>& yes,
    std::array<Lanes<T, Set, registers>, n> no) {
  for (std::size_t i = 0; i < n; ++i) no[i] = select(condition, yes[i], no[i]);
  return no;
}

/// Condition of a loop that continues while any lane needs it.
template <class T, class Set, int registers>
[[gnu::always_inline]] inline bool any_of(const Mask<T, Set, registers>& condition) {
  return condition.any();
}

/// Skips a branch that no lane needs. Each branch occurs once in the code, since nested ones would multiply
/// it.
template <class T, class Set, int registers, class Yes, class No>
[[gnu::always_inline]] inline auto either(const Mask<T, Set, registers>& condition, const Yes& yes,
                                          const No& no) {
  constexpr std::size_t size = Lanes<T, Set, registers>::size();
  const std::uint64_t holds = condition.bits();
  if constexpr (size == 1) {
    return holds ? yes() : no();
  } else {
    decltype(yes()) one{}, other{};
    if (holds != 0) one = yes();
    if (holds != ~std::uint64_t(0) >> (64 - size)) other = no();
    return select(condition, one, other);
  }
}

}  // namespace oddity::lanes

namespace oddity {

template <class T, class Set = lanes::Native, int registers = 1>
using Lanes = lanes::Lanes<T, Set, registers>;

}  // namespace oddity
