#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/coq_source.hpp"
#include "chapters/expression.hpp"

/// Statements about claims that Coq proves for all numbers, while the suite compares samples. They are
/// recorded from the same formulas that the suite computes.
namespace oddity {

/// A statement in Coq's syntax.
struct Proposition {
  std::string coq;
};
Proposition operator==(const Expression&, const Expression&);
Proposition not_zero(const Expression&);
Proposition above(const Expression& x, const Expression& least);
/// They differ by at most `error`.
Proposition near(const Expression&, const Expression&, double error);
/// They differ by at least `margin`.
Proposition apart(const Expression&, const Expression&, double margin);
/// Component by component.
std::vector<Proposition> equal(const Expressions&, const Expressions&);
/// All are above zero.
std::vector<Proposition> positive(std::initializer_list<Shortened>);

/// A tactic that decides `apart` for fractions.
inline constexpr const char* by_arithmetic = "unfold Rabs; destruct (Rcase_abs _); lra";

/// For all letters that satisfy all of `given`, all of `follows` is true.
struct Lemma {
  std::string name;          ///< a reading's name: "printed", "corrected"
  std::string letters = {};  ///< "(x y : R) (f : field)"
  std::vector<Proposition> given = {};
  std::vector<Proposition> follows = {};
  std::string tactic = "field";  ///< proves each of `follows`
};

/// The proof of a claim, as a separate Coq file.
struct Provable {
  std::string claim;  ///< "3.5-value"
  std::string says;   ///< the proved statement, in words
  std::vector<Lemma> lemmas = {};
  double margin = 0;          ///< a proved lower bound of the printed value's error, if it is wrong
  std::string preamble = {};  ///< coq_source() of its definitions
};
using Provables = std::vector<Provable>;

/// Adds these proofs.
void append(Provables& all, Provables more);
/// The proof of this claim. Throws std::logic_error if it is missing.
Provable& proof_of(Provables&, std::string_view claim);

/// Text of the Coq file. Checking it also prints the axioms it uses.
std::string coq_file(const Provable&);

/// Proofs of all exercises.
Provables provables();

}  // namespace oddity
