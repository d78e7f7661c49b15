#include "chapters/provable.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <stdexcept>

#include "chapters/contents.hpp"

namespace oddity {

namespace {

/// Coq line that limits each proof, in seconds.
const std::string limit = "Timeout 20 ";

std::string size_of_difference(const Expression& a, const Expression& b) { return abs(a - b).coq(); }

std::string joined(const std::vector<Proposition>& all, const std::string& between) {
  std::string text;
  for (const Proposition& p : all) text += (text.empty() ? "" : between) + p.coq;
  return text;
}

/// "3.5-value" as claim_3_5_value, a prefix of names in Coq.
std::string name_of(const std::string& claim) {
  std::string name = "claim_" + claim;
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return name + "_";
}

std::string in_coq(const Lemma& lemma, const std::string& name) {
  std::string text = "Lemma " + name + " :";
  if (!lemma.letters.empty()) text += " forall " + lemma.letters + ",";
  text += "\n  ";
  for (const Proposition& p : lemma.given) text += p.coq + " ->\n  ";
  text += joined(lemma.follows, " /\\\n  ") + ".\n";
  return text + "Proof. " + limit + "(intros; repeat split; " + lemma.tactic + "). Qed.\n" +
         "Print Assumptions " + name + ".\n";
}

}  // namespace

Proposition operator==(const Expression& a, const Expression& b) { return {a.coq() + " = " + b.coq()}; }
Proposition not_zero(const Expression& x) { return {x.coq() + " <> 0"}; }
Proposition above(const Expression& x, const Expression& least) { return {x.coq() + " > " + least.coq()}; }
Proposition near(const Expression& a, const Expression& b, double error) {
  return {size_of_difference(a, b) + " <= " + Expression(error).coq()};
}
Proposition apart(const Expression& a, const Expression& b, double margin) {
  return {size_of_difference(a, b) + " >= " + Expression(margin).coq()};
}
std::vector<Proposition> equal(const Expressions& a, const Expressions& b) {
  std::vector<Proposition> all;
  for (std::size_t i = 0; i < a.size(); ++i) all.push_back(a[i] == b.at(i));
  return all;
}

std::vector<Proposition> positive(std::initializer_list<Shortened> all) {
  std::vector<Proposition> positive;
  for (const Shortened& x : all) positive.push_back(above(x.expression(), 0));
  return positive;
}

void append(Provables& all, Provables more) { std::ranges::move(more, std::back_inserter(all)); }
Provable& proof_of(Provables& all, std::string_view claim) {
  const auto found = std::ranges::find(all, claim, &Provable::claim);
  if (found == all.end()) throw std::logic_error("there is no proof of " + std::string(claim));
  return *found;
}

Provables provables() {
  Provables all;
  for (const Entry& entry : registry())
    if (entry.exercise.proofs) append(all, entry.exercise.proofs());
  return all;
}

std::string coq_file(const Provable& provable) {
  std::string text = "(* " + provable.claim + ": " + provable.says +
                     ".\n   Written by oddity prove from the formulas that the suite computes with. *)\n" +
                     std::string(coq_head) + provable.preamble;
  for (const Lemma& lemma : provable.lemmas)
    text += "\n" + in_coq(lemma, name_of(provable.claim) + lemma.name);
  return text;
}

}  // namespace oddity
