#pragma once

#include <vector>

#include "chapters/05_fluids_and_gases/shared/fields.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex05_05 {

template <class Vector>
auto product(const fields::Matrix<double>& m, Vector f) {
  return [m, f](const auto& x) {
    const auto v = f(x);
    return std::array{dot(m[0], v), dot(m[1], v), dot(m[2], v)};
  };
}

inline fields::Point column(const fields::Matrix<double>& m, std::size_t j) {
  return {m[0][j], m[1][j], m[2][j]};
}

std::vector<Claim> claims(const Random&);
Provables proofs();

}  // namespace oddity::ex05_05
