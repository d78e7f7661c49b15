#pragma once

#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex05_01 {

inline constexpr auto position = [](const auto& x) { return x; };

std::vector<Claim> claims(const Random&);
Provables proofs();

}  // namespace oddity::ex05_01
