#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chapters/claims.hpp"
#include "chapters/random.hpp"

/// The published lines of exercise 5.15.
namespace oddity::ex05_15 {

/// A published equation of index expressions.
struct Said {
  std::string left, right, free = "i";
};
/// The claims, and the lines that they state as printed, by slug.
struct Lines {
  Claims claims{"5.15"};
  std::vector<std::pair<std::string, std::vector<Said>>> printed = {};
};
Lines lines(Random);

}  // namespace oddity::ex05_15
