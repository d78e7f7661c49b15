#pragma once

#include <utility>

namespace oddity {

/// Wraps f, which must outlive the wrapper, and counts its calls.
template <class F>
auto counted_calls(const F& f, long& calls) {
  return [&f, &calls](auto&&... x) -> decltype(auto) {
    ++calls;
    return f(std::forward<decltype(x)>(x)...);
  };
}

}  // namespace oddity
