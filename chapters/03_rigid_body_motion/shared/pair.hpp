#pragma once

#include <array>

namespace oddity {

template <class T>
using Two = std::array<T, 2>;
using Pair = Two<double>;

}  // namespace oddity
