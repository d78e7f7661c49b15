#pragma once

#include "extras/lanes/compiled.hpp"
#include "extras/lanes/registers.hpp"

/// The operations of one instruction set, repeated.
namespace oddity::lanes {

template <class Register, class Operation>
[[gnu::noinline]] Number<Register> repeat(long times, Number<Register> start, const Operation& operation) {
  Register x[registers_at_once], sum{};
  for (int i = 0; i < registers_at_once; ++i) x[i] = all<Register>(start + static_cast<Number<Register>>(i));
  for (long n = 0; n < times; ++n)
    for (Register& one : x) one = operation(one);
  for (const Register& one : x) sum += one;
  return std::bit_cast<std::array<Number<Register>, count<Register>>>(sum)[0];
}

template <class T, class Set>
double repeat_one(Arithmetic operation, long times) {
  using V = typename RegisterOf<T, Set::bytes>::type;
  volatile T nearly_one = 1 + T(1e-6);
  const V c = all<V>(nearly_one);
  switch (operation) {
    case Arithmetic::addition:
      return static_cast<double>(repeat<V>(times, 1, [c](const V& x) { return V(x + c); }));
    case Arithmetic::multiplication:
      return static_cast<double>(repeat<V>(times, 1, [c](const V& x) { return V(x * c); }));
    case Arithmetic::division:
      return static_cast<double>(repeat<V>(times, 1, [c](const V& x) { return V(x / c); }));
    case Arithmetic::root:
      return static_cast<double>(repeat<V>(times, 1, [](const V& x) { return V(sqrt(x)); }));
  }
  return 0;
}

/// For doubles and for floats.
template <class Set>
constexpr Repeated repeated[]{{count<typename RegisterOf<double, Set::bytes>::type>, repeat_one<double, Set>},
                              {count<typename RegisterOf<float, Set::bytes>::type>, repeat_one<float, Set>}};

}  // namespace oddity::lanes
