#pragma once

#include <experimental/simd>

/// Several numbers in one register, as a number type for models.
namespace std::experimental {

/// Lane by lane.
template <class T, class Abi>
simd<T, Abi> select(const simd_mask<T, Abi>& condition, const simd<T, Abi>& yes, simd<T, Abi> no) {
  where(condition, no) = yes;
  return no;
}

}  // namespace std::experimental

namespace oddity {

template <class T>
using Lanes = std::experimental::native_simd<T>;

}  // namespace oddity
