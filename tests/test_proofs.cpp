#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "reference/proofs.hpp"
#include "report/study/prove.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

TEST_CASE("an expression is written in Coq's syntax", "[proofs]") {
  const Expression x = Expression::letter("x"), y = Expression::letter("y");
  CHECK((x - (y - x)).coq() == "x - (y - x)");
  CHECK((x / (y * x)).coq() == "x / (y * x)");
  CHECK((-(x + y) * x).coq() == "- (x + y) * x");
  CHECK((x * -y).coq() == "x * - y");
  CHECK(pow(-x, 2).coq() == "(- x) ^ 2");
  CHECK((-pow(x, 2)).coq() == "- x ^ 2");
  CHECK(pow(sin(x), 2).coq() == "(sin (x)) ^ 2");
  CHECK((x * 0.25).coq() == "x * (25 / 100)");
  CHECK((x - 3).coq() == "x - 3");
  CHECK(Expression(-1.5).coq() == "- (15 / 10)");
  CHECK(Expression(5e-7).coq() == "5 / 10000000");
  CHECK_THROWS(Expression(1.0 / 0.0));
}

TEST_CASE("every recorded proof is of the current formulas", "[proofs]") {
  const ProvedClaims record = read_proofs(std::string(ODDITY_SOURCE) + "/reference/approved");
  const Provables now = provables();
  CHECK(record.size() == now.size());
  for (const Provable& p : now) {
    INFO(p.claim << ": prove it again by oddity prove --approve");
    const auto found = record.find(p.claim);
    REQUIRE(found != record.end());
    CHECK(found->second.hash == proof_hash(coq_file(p)));
    CHECK(found->second.proved == p.says);
    CHECK(found->second.margin == p.margin);
  }
}

TEST_CASE("a source of proofs has the files that it loads once", "[proofs]") {
  const std::string root = coq_source({"root"}), limits = coq_source({"root", "limits"});
  CHECK(root.starts_with("\nLemma root_is"));
  CHECK(limits.starts_with(root + coq_source({"limit_at_zero"})));
  CHECK(limits.find("Lemma root_is", root.size()) == std::string::npos);
  CHECK_THROWS_WITH(coq_source({"roots"}), "there is no file roots.v");
  std::set<std::string> names;
  for (const EmbeddedFile& file : embedded_proofs()) {
    INFO(file.path);
    const std::string name = std::filesystem::path(file.path).stem();
    CHECK(names.insert(name).second);
    CHECK_NOTHROW(coq_source({name}));
  }
}

TEST_CASE("axioms that a proof may rest on", "[proofs]") {
  CHECK(unknown_axioms("Axioms:\nClassicalDedekindReals.sig_forall_dec\n  : forall P : nat -> Prop,\n")
            .empty());
  CHECK(unknown_axioms("Closed under the global context\n").empty());
  CHECK(unknown_axioms("Axioms:\nlie : 1 = 2\n") == std::vector<std::string>{"lie"});
}

TEST_CASE("coqc refuses near misses, admitted lemmas and assumptions", "[proofs]") {
  if (!coq_is_there()) {
    WARN("not run: Coq or one of its libraries is not installed");
    return;
  }
  const ScratchFolder scratch;
  const Expression x = Expression::letter("x"), y = Expression::letter("y");
  const auto square = [&](double middle) {
    return Lemma{.name = "square",
                 .letters = "(x y : R)",
                 .follows = {pow(x + y, 2) == pow(x, 2) + middle * x * y + pow(y, 2)},
                 .tactic = "ring"};
  };
  const auto sine = [](double margin) {
    return Lemma{.name = "sine", .follows = {apart(sin(Expression(1)), 0.8, margin)}, .tactic = "interval"};
  };
  Lemma admitted = square(3);
  admitted.tactic = "admit). Admitted. Goal True. Proof. (exact I";
  Provable assumed{"1.6-assumed", "by an axiom", {square(3)}, 0, "Axiom lie : forall x y : R, x = y.\n"};
  assumed.lemmas[0].tactic = "apply lie";
  const auto checked = prove({{"1.1-square", "true", {square(2)}},
                              {"1.2-square", "false", {square(3)}},
                              {"1.3-sine", "true", {sine(0.04)}},
                              {"1.4-sine", "false", {sine(0.05)}},
                              {"1.5-admitted", "not proved", {admitted}},
                              assumed},
                             scratch.path(), {});
  for (const Checked& c : checked) {
    INFO(c.claim << ": " << c.message);
    CHECK(c.proved == (c.claim == "1.1-square" || c.claim == "1.3-sine"));
  }
  CHECK(checked[4].message == "it rests on claim_1_5_admitted_square; ");
  CHECK(checked[5].message == "it rests on lie; ");
}

TEST_CASE("prove reports claims without a proof", "[proofs]") {
  const program::Ran none = program::run("prove 6.1");
  CHECK(none.status == 2);
  CHECK(program::says(none, "exercise 6.1 has no proofs"));
  const ScratchFolder scratch;
  const program::Ran without =
      program::shell("PATH=/nowhere $oddity prove 3.5 --out '" + scratch.path().string() + "'");
  CHECK(without.status == 2);
  CHECK(program::says(without, "libcoq-interval"));
  CHECK(std::filesystem::exists(scratch.path() / "3.5-value.v"));
}
