// Proofs are about what the code computes: what is recorded, how it is printed, that Coq refuses what is
// nearly the same, and that what is stated is what was proved.
#include <algorithm>
#include <numbers>

#include "chapters/03_rigid_body_motion/05_pendulum/quarter_period.hpp"
#include "chapters/contents.hpp"
#include "chapters/proofs.hpp"
#include "reference/verdicts.hpp"
#include "report/study/proving.hpp"
#include "report/study/run_program.hpp"
#include "tests/catch.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

const std::filesystem::path approved = std::filesystem::path(ODDITY_SOURCE) / "reference/approved";

Proof proof_named(const std::string& name) {
  const std::vector<Proof> all = proofs();
  const auto found = std::ranges::find_if(all, [&](const Proof& proof) { return name_of(proof) == name; });
  REQUIRE(found != all.end());
  return *found;
}

std::string answer_of_gp(const std::string& script) {
  const Ended ended = run_program({"gp", "-q", "-f"}, script, std::chrono::minutes(1));
  INFO(ended.how << ended.words);
  REQUIRE(ended.ok);
  return ended.output;
}

}  // namespace

TEST_CASE("An expression is printed as it is computed", "[proofs]") {
  const Expression x = Expression::letter("x");
  CHECK((1 - x * x / 3).coq() == "(1 - ((x * x) / 3))");
  CHECK((2 * sqrt(x) + 0.25).pari() == "((2 * sqrt(x)) + (256 / 1024))");
  CHECK(Expression::decimal("0.800275").coq() == "(800275 / 1000000)");
  CHECK(Expression::decimal("12").coq() == "12");
  CHECK(Expression(-3).coq() == "(0 - 3)");
  const Expression area =
      integral([](const Expression& t) { return sin(t); }, Expression(0), Expression::pi());
  CHECK(area.pari() == "intnum(x2 = 0, Pi, sin(x2))");
  CHECK(area.coq() == "(RInt (fun x2 : R => (sin x2)) 0 PI)");
}

TEST_CASE("An integral within another is refused, whose letters could be the same", "[proofs]") {
  const auto inner = [](const Expression& t) {
    return integral([&](const Expression& u) { return t * u; }, Expression(0), t);
  };
  CHECK_THROWS_AS(integral(inner, Expression(0), Expression(1)), std::logic_error);
}

TEST_CASE("A rounded double is no exact number", "[proofs]") {
  CHECK_THROWS_AS(Expression(std::numbers::pi), std::logic_error);
  CHECK_THROWS_AS(Expression(0.1), std::logic_error);
  CHECK_THROWS_AS(Expression(1e300), std::logic_error);
  CHECK_THROWS_AS(Expression::decimal("1e5"), std::logic_error);
  CHECK_THROWS_AS(Expression::decimal("-1.5"), std::logic_error);
}

TEST_CASE("Every proof is of a claim, and of a reading that its verdict has", "[proofs]") {
  const Verdicts verdicts = read_verdicts(approved);
  for (const Proof& proof : proofs()) {
    INFO(name_of(proof));
    REQUIRE(verdicts.contains(proof.claim));
    const bool erratum = verdicts.at(proof.claim) == "erratum";
    CHECK((proof.reading == "printed" || (erratum && proof.reading == "corrected")));
    CHECK((proof.kind == Proof::Kind::far) == (erratum && proof.reading == "printed"));
  }
}

TEST_CASE("What is stated is what was proved", "[proofs]") {
  const auto record = read_proofs(approved);
  CHECK(differences(proofs(), record).empty());
  std::vector<Proof> changed = proofs();
  changed.front().left = changed.front().left + Expression(1);
  const std::vector<std::string> noticed = differences(changed, record);
  REQUIRE(noticed.size() == 1);
  CHECK(noticed.front() == name_of(changed.front()) + ": the statement is not the one that was proved");
}

TEST_CASE("What a proof must not assume is told", "[proofs]") {
  CHECK(not_allowed({"classic", "Uint63.add_spec", "ClassicalDedekindReals.sig_not_dec"}).empty());
  CHECK(not_allowed({"holds_admitted", "classic"}) == std::vector<std::string>{"holds_admitted"});
}

TEST_CASE("Coq proves a statement, and refuses one that is nearly the same", "[proofs]") {
  if (!is_installed("coqc")) {
    WARN("not run: coqc is not installed");
    return;
  }
  const ScratchFolder folder;
  Proof identity = proof_named("7.1-factored_corrected");
  CHECK(prove(folder.path(), "true", coq_file(identity)).ok);
  CHECK(prove(folder.path(), "true", coq_file(identity)).kept);
  identity.right = identity.right + Expression::letter("n") * Expression::letter("mu");
  CHECK_FALSE(prove(folder.path(), "false", coq_file(identity)).ok);
  Proof far = proof_named("7.1-full_cost_printed");
  CHECK(prove(folder.path(), "true", coq_file(far)).ok);
  far.bound = "3.001";
  CHECK_FALSE(prove(folder.path(), "false", coq_file(far)).ok);
}

TEST_CASE("PARI agrees with every statement, and with no printed value in place of the right one",
          "[proofs]") {
  if (!is_installed("gp")) {
    WARN("not run: gp is not installed");
    return;
  }
  for (Proof proof : proofs()) {
    INFO(pari_script(proof));
    CHECK(answer_of_gp(pari_script(proof)).ends_with("true\n"));
    if (proof.kind != Proof::Kind::far) continue;
    proof.kind = Proof::Kind::near;
    proof.bound = "0.0000000001";
    CHECK(answer_of_gp(pari_script(proof)).ends_with("false\n"));
  }
}
