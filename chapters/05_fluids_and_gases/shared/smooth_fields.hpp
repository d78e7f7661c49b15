#pragma once

#include <array>
#include <string>

#include "chapters/expression.hpp"

/// Components of functions of an index in Coq. The fields and frames are in fields.v and curls.v.
namespace oddity::fields {

/// The components of a function of the indices.
inline std::array<Shortened, 3> numbers(const std::string& name) {
  const auto component = [&](int i) {
    return Shortened::letter("(" + name + " " + std::to_string(i) + "%nat)");
  };
  return {component(0), component(1), component(2)};
}

}  // namespace oddity::fields
