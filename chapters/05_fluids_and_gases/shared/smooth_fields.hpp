#pragma once

#include <array>
#include <string>

#include "chapters/expression.hpp"

/// Fields with continuous derivatives, and operators along rotated frames, in Coq.
namespace oddity::fields {

/// Right-handed orthonormal frames; needs Lia and Nsatz.
std::string frames_in_coq();
/// Fields that are `smooth` up to the n-th derivatives; derivatives d by the coordinates and `along` vectors,
/// with rules and order; gradient and curls along a frame.
std::string smooth_fields_in_coq();
/// To follow it: vector fields in the coordinates of a rotated frame, and curls as sums over the permutation
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
