#pragma once

#include <vector>

#include "chapters/05_fluids_and_gases/shared/fields.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/reference.hpp"

namespace oddity::ex05_09 {

/// A function whose second derivatives exist everywhere and are not continuous at the origin:
///   p(x, y) = x y (x^2 - y^2) / (x^2 + y^2), p(0, 0) = 0   [Peano].
/// There d/dx (dp/dy) = 1 and d/dy (dp/dx) = -1, since dp/dy (x, 0) = x and dp/dx (0, y) = -y.
/// [Peano] G. Peano in A. Genocchi, Calcolo differenziale, 1884.
inline constexpr auto peano = []<class T>(const fields::Triple<T>& x) {
  const T a = x[0] * x[0], b = x[1] * x[1];
  return x[0] * x[1] * (a - b) / (a + b);
};

/// `mixed`: the second derivatives of the fixed field, in both orders.
std::vector<Claim> claims(Random random, const Known& mixed);
Provables proofs();

}  // namespace oddity::ex05_09
