#pragma once

#include <string>
#include <utility>

#include "chapters/provable_claims.hpp"

/// Formulas with sums over particles, stated in Coq for any number of particles.
namespace oddity {

/// The value of a formula or an equation that is stated as text alone. Each sum is `total l (fun m x y =>
/// ...)` of its term for the index 1; `particle` is "m x y".
Expressions recorded_sums(const std::string& text, const TypesetIn<Shortened>& letters,
                          const std::string& particle);

/// A formula stated as text alone, with such sums.
template <template <class> class Of>
ProvableFormula<Of> over_particles(const std::string& text, const std::string& particle) {
  ProvableFormula<Of> formula(text);
  formula.recorded = [=](const Of<Shortened>& s) { return recorded_sums(text, typeset_of(s), particle); };
  return formula;
}

}  // namespace oddity
