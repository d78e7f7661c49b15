#include "chapters/proofs.hpp"

#include <stdexcept>

namespace oddity {

namespace ex03_05 {
std::vector<Proof> proofs();
}
namespace ex03_17 {
std::vector<Proof> proofs();
}
namespace ex07_01 {
std::vector<Proof> proofs();
}

namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
  return all;
}

std::string bound_of(const Proof& proof) { return Expression::decimal(proof.bound).coq(); }

std::string statement(const Proof& proof) {
  const std::string letters = joined(proof.letters, " "), of = letters.empty() ? "" : " " + letters;
  const std::string difference = "Rabs (left" + of + " - right" + of + ")";
  const std::string all = letters.empty() ? "" : "forall " + letters + " : R, ";
  switch (proof.kind) {
    case Proof::Kind::identity:
      return all + "left" + of + " = right" + of;
    case Proof::Kind::near:
      return all + difference + " <= " + bound_of(proof);
    case Proof::Kind::far:
      return all + bound_of(proof) + " <= " + difference;
  }
  throw std::logic_error("a kind of proof without a statement");
}

/// The tactics are bounded: what is false is given up, not tried for ever.
std::string tactic(const Proof& proof, bool has_integral) {
  if (proof.kind == Proof::Kind::identity) return "field";
  if (has_integral) return "integral with (i_fuel 200, i_prec 60)";
  return "first [split_Rabs; lra | interval with (i_prec 60)]";
}

/// What PARI has to find at one point: the letters are numbers by then.
std::string condition(const Proof& proof) {
  const std::string bound = Expression::decimal(proof.bound).pari();
  switch (proof.kind) {
    case Proof::Kind::identity:
      return "abs(left - right) <= 1e-10 * (1 + abs(left))";
    case Proof::Kind::near:
      return "abs(left - right) <= " + bound;
    case Proof::Kind::far:
      return bound + " <= abs(left - right)";
  }
  throw std::logic_error("a kind of proof without a condition");
}

}  // namespace

std::string to_string(Proof::Kind kind) {
  switch (kind) {
    case Proof::Kind::identity:
      return "identity";
    case Proof::Kind::near:
      return "near";
    case Proof::Kind::far:
      return "far";
  }
  throw std::logic_error("a kind of proof without a name");
}

std::string name_of(const Proof& proof) { return proof.claim + "_" + proof.reading; }

std::string coq_file(const Proof& proof) {
  const std::string letters = proof.letters.empty() ? "" : " (" + joined(proof.letters, " ") + " : R)";
  const std::string left = proof.left.coq(), right = proof.right.coq();
  const bool has_integral = (left + right).find("RInt") != std::string::npos;
  std::string text = "(* " + proof.claim + ", " + proof.reading + ": " + proof.says + ". *)\n" +
                     "From Coq Require Import Reals Lra.\n";
  if (has_integral) text += "From Coquelicot Require Import Coquelicot.\n";
  if (proof.kind != Proof::Kind::identity) text += "From Interval Require Import Tactic.\n";
  return text + "Open Scope R_scope.\n\nDefinition left" + letters + " : R :=\n  " + left +
         ".\nDefinition right" + letters + " : R :=\n  " + right +
         ".\n\nTheorem holds : " + statement(proof) + ".\nProof.\n  intros; unfold left, right; " +
         tactic(proof, has_integral) + ".\nQed.\nPrint Assumptions holds.\n";
}

std::string pari_script(const Proof& proof) {
  const std::string head = "\\\\ " + proof.claim + ", " + proof.reading + ": " + proof.says + ".\n";
  std::string given;
  for (const std::string& letter : proof.letters) given += letter + " = random(10.); ";
  return head + "default(realprecision, 38);\nsetrand(1);\nholds = 1;\nfor(draw = 1, " +
         (proof.letters.empty() ? "1" : "20") + ", " + given + "left = " + proof.left.pari() +
         "; right = " + proof.right.pari() + "; holds = holds && " + condition(proof) +
         ");\nprint(\"left \", left);\nprint(\"right \", right);\nprint(if(holds, \"true\", \"false\"));\n";
}

std::vector<Proof> proofs() {
  std::vector<Proof> all;
  for (const auto& of_exercise : {ex03_05::proofs, ex03_17::proofs, ex07_01::proofs}) {
    const std::vector<Proof> more = of_exercise();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace oddity
