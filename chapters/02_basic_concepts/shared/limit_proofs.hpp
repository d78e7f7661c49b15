#pragma once

#include "chapters/provable.hpp"

/// Limits as Coq states them, of a function that is recorded with the letter t.
namespace oddity {

inline Proposition tends_at_infinity(const Expression& f, const Expression& limit) {
  return {"(forall eps, eps > 0 -> exists far, forall t, t > far -> " + abs(f - limit).coq() + " < eps)"};
}

}  // namespace oddity
