#pragma once

#include "chapters/provable.hpp"

/// Limits in Coq of a function that is recorded with the letter t.
namespace oddity {

inline Proposition tends_at_infinity(const Expression& f, const Expression& limit) {
  return {"(forall eps, eps > 0 -> exists far, forall t, t > far -> " + abs(f - limit).coq() + " < eps)"};
}

/// As t goes to 0 from the given side.
inline Proposition tends_at_zero(const Expression& f, int side, const Expression& limit) {
  const std::string within = side < 0 ? "- near < t < 0" : "0 < t < near";
  return {"(forall eps, eps > 0 -> exists near, near > 0 /\\ forall t, " + within + " -> " +
          abs(f - limit).coq() + " < eps)"};
}

}  // namespace oddity
