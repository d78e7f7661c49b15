#pragma once

#include <utility>

namespace oddity {

/// The function f, which outlives it, with each of its calls counted.
template <class F>
auto counted_calls(const F& f, long& calls) {
  return [&f, &calls](auto&&... x) -> decltype(auto) {
    ++calls;
    return f(std::forward<decltype(x)>(x)...);
  };
}

}  // namespace oddity
