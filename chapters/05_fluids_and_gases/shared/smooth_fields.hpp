#pragma once

#include <array>
#include <string>

#include "chapters/expression.hpp"

/// Fields with continuous derivatives and operators along turned frames, for Coq.
namespace oddity::fields {

/// Right-handed orthonormal frames; it takes Lia and Nsatz.
std::string frames_in_coq();
/// Fields up to the n-th derivatives, `smooth`; the derivatives d by the coordinates and `along` vectors,
/// their rules and their order; the gradient and curls along a frame.
std::string smooth_fields_in_coq();
/// After that: vector fields in the coordinates of a turned frame, and curls as sums over the permutation
/// tensor.
std::string repeated_curls_in_coq();

/// The components of a function of the indices.
inline std::array<Shortened, 3> numbers(const std::string& name) {
  const auto component = [&](int i) {
    return Shortened::letter("(" + name + " " + std::to_string(i) + "%nat)");
  };
  return {component(0), component(1), component(2)};
}

}  // namespace oddity::fields
