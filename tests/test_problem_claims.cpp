// Claims in problems' files: a right one is confirmed, a wrong one is found, and one that cannot be judged is
// refused with its place.

#include <algorithm>

#include "problem/scene.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/program.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::problem;

namespace {

std::string sheet(const std::string& claim) {
  return "title = \"test\"\n[[claim]]\nname = \"it\"\nsays = \"it\"\n" + claim + "\n";
}
Claim claim_of(const std::string& claim) {
  const Entry& entry = entry_of_text("test.toml", sheet(claim));
  return entry.exercise.study(Parameters(entry.exercise.parameters), Reference::nothing()).claims.at(0);
}
std::string verdict_of(const std::string& claim) { return std::string(name_of(verdict(claim_of(claim)))); }
std::string refusal_of(const std::string& claim) {
  const std::string said = complaint([&] { entry_of_text("test.toml", sheet(claim)); });
  return said.substr(0, said.find('\n'));
}

const std::string letters = "letters = { a = \"0.1 to 3 m\", b = \"20 to 300 cm\", n = \"1 to 9, whole\" }\n";

}  // namespace

TEST_CASE("A claim is judged by each kind of reference", "[problem][claims]") {
  CHECK(verdict_of(letters + "printed = \"a b + b^2\"\ntruth = \"b (a + b)\"") == "confirmed");
  CHECK(verdict_of(letters + "printed = \"A = a b - b^2\"\ntruth = \"b (a + b)\"") == "unsettled");
  CHECK(verdict_of(letters + R"(printed = '\frac{a^3}{3}'
truth = { integral = "x^2", over = "x", from = "0 m", to = "a" })") == "confirmed");
  CHECK(verdict_of(letters + R"(printed = "a^3/2"
truth = { integral = "x^2", over = "x", from = "0 m", to = "a" })") == "unsettled");
  CHECK(verdict_of(letters + R"(printed = "3*a^2 b"
truth = { derivative = "a^3 b", by = "a" })") == "confirmed");
  CHECK(verdict_of(letters + R"(printed = "6 a b"
truth = { derivative = "a^3 b", by = "a", times = 2 })") == "confirmed");
  CHECK(verdict_of(letters + R"(printed = "n (n + 1) (2*n + 1)/6"
truth = { sum = "k^2", over = "k", from = "1", to = "n" })") == "confirmed");
  CHECK(verdict_of(letters + R"(printed = "n (n + 1) (2*n - 1)/6"
truth = { sum = "k^2", over = "k", from = "1", to = "n" })") == "unsettled");
  CHECK(
      verdict_of("printed = \"9.81 m/s^2\"\ntruth = { value = \"9.8066 m/s^2\", within = \"1 cm/s^2\", by = "
                 "\"the pendulum\" }") == "confirmed");
  CHECK(verdict_of("printed = \"9.85 m/s^2\"\ntruth = { value = \"9.8066 m/s^2\", within = \"1 cm/s^2\" }") ==
        "unsettled");
  CHECK(verdict_of("letters = { l = \"1 m\", g = \"9.81 m/s^2\" }\nprinted = \"T = 2.006 s\"\ntruth = \"2 pi "
                   "sqrt(l/g)\"") == "confirmed");
  CHECK(verdict_of("letters = { l = \"1 m\", g = \"9.81 m/s^2\" }\nprinted = \"2.007 s\"\ntruth = \"2 pi "
                   "sqrt(l/g)\"\ncorrected = \"2.006 s\"") == "wrong");
  CHECK(verdict_of("letters = { x = \"0.1 to 3\" }\nprinted = \"sin(x)^2 + cos(x)^2 = 1\"") == "confirmed");
  CHECK(verdict_of("letters = { x = \"0.1 to 3\" }\nprinted = \"sin(2 x) = 2 sin(x)\"\n"
                   "corrected = \"sin(2 x) = 2 sin(x) cos(x)\"") == "wrong");
  CHECK(verdict_of("letters = { x = \"-9 to 9\" }\nprinted = \"x <= abs(x)\"") == "confirmed");
  CHECK(verdict_of("letters = { x = \"-9 to 9\" }\nprinted = \"x^2 > x\"") == "unsettled");
}

TEST_CASE("A claim's verdict follows from its readings", "[problem][claims]") {
  const std::string truth = "\ntruth = { integral = \"2 x\", over = \"x\", from = \"0 m\", to = \"a\" }";
  CHECK(verdict_of(letters + "printed = \"a^3/(1 m)\"\nmeant = \"a^2\"" + truth) == "misprint");
  CHECK(verdict_of(letters + "printed = \"a\"\nmeant = \"a^2\"\nlost = true" + truth) == "lost in our copy");
  CHECK(verdict_of(letters + "printed = \"a^2/2\"\ncorrected = \"a^2\"" + truth) == "wrong");
  CHECK(
      verdict_of(
          "letters = { x = \"-3 to 3 m\" }\nprinted = \"x = sqrt(x^2)\"\ncorrected = \"abs(x) = sqrt(x^2)\"\n"
          "in_view = \"x > 0 m\"") == "incomplete");
  // Units that do not fit are a fault of the printed formula, and are named.
  const Claim amiss = claim_of(letters + "printed = \"a^2 + a\"\ncorrected = \"a^2\"" + truth);
  CHECK(name_of(verdict(amiss)) == "wrong");
  CHECK(amiss.why.find("m^2 and m do not add up") != std::string::npos);
  // A claim stated to be wrong that holds has no such verdict: its correction differs from the true value.
  CHECK(verdict_of(letters + "printed = \"a a\"\ncorrected = \"2 a^2\"" + truth) == "unsettled");
}

TEST_CASE("Each single change of a claim's formula is a near miss", "[problem][claims]") {
  const Claim claim =
      claim_of(letters +
               "printed = \"5 cm a + b^2/(2 n)\"\ntruth = { sum = \"(5 cm a + b^2/2/n)/n\", over = "
               "\"k\", from = \"1\", to = \"n\" }");
  CHECK(name_of(verdict(claim)) == "confirmed");
  REQUIRE(claim.near_misses.size() == 1);
  CHECK(claim.near_misses[0].text.find("the hardest to see of") != std::string::npos);
  // A tolerance that does not distinguish the formula from its neighbours settles nothing.
  CHECK(
      verdict_of("letters = { x = \"1\" }\nprinted = \"x + 2\"\ntruth = { value = \"3\", within = \"5\" }") ==
      "unsettled");
}

TEST_CASE("Letters are drawn from their ranges, under conditions", "[problem][claims]") {
  const std::string claim =
      "printed = \"abs(a - b)\"\ntruth = { integral = \"1\", over = \"x\", from = \"b\", to = \"a\" }\n";
  CHECK(verdict_of(letters + claim) == "unsettled");
  CHECK(verdict_of(letters + claim + "where = \"a > b\"") == "unsettled");  // a - b holds there as well
  CHECK(verdict_of(letters + claim + "where = \"a > b\"\nchanges_that_hold = \"it is positive there\"") ==
        "confirmed");
  CHECK(refusal_of(letters + claim + "where = \"a > b + 100 m\"") ==
        "test.toml:2:1: too few of the letters drawn meet this: narrow their ranges");
  const Claim one = claim_of(
      "letters = { mass = \"2 kg\", m_1 = \"1 to 2 kg\", theta = \"10 to 20 deg\" }\nprinted = \"mass "
      "m_1 sin(theta)\"\ntruth = \"mass m_1 cos(90 deg - theta)\"");
  CHECK(name_of(verdict(one)) == "confirmed");
  CHECK(one.printed.text == R"($\mathrm{mass}m_1\sin(\theta)$)");
  CHECK(one.printed.checks[0].where.find("worst of 200: mass = 2 kg, m_1 = 1.") == 0);
}

TEST_CASE("A claim that cannot be judged is refused with its place", "[problem][claims]") {
  CHECK(refusal_of("printed = \"a\"") ==
        "test.toml:5:12: what is it judged by? add truth = \"another route to it\"");
  CHECK(refusal_of(letters + "printed = \"a + q\"\ntruth = \"a\"").find("test.toml:6:16: no letter q") == 0);
  CHECK(refusal_of(letters + "printed = \"a b\"\ntruth = \"a b\"")
            .find("test.toml:7:10: the truth is the formula that") == 0);
  CHECK(refusal_of(letters + "printed = \"a\"\ntruth = \"a + n\"") ==
        "test.toml:7:14: m and a pure number do not add up");
  CHECK(refusal_of(letters + "printed = \"a\"\ncorrected = \"a b\"\ntruth = \"2 a\"") ==
        "test.toml:7:14: it is in m^2, and the truth in m");
  CHECK(refusal_of(letters + "printed = \"a < b\"\ntruth = \"2 a\"").find("leave truth out") !=
        std::string::npos);
  CHECK(refusal_of(letters + "printed = \"a < b\"\ncorrected = \"2 a\"").find("and this is a formula") !=
        std::string::npos);
  CHECK(refusal_of(letters +
                   "printed = \"a\"\ntruth = { integral = \"x\", over = \"a\", from = \"0\", to = \"b\" }") ==
        "test.toml:7:35: a is a letter already; let it run through another");
  CHECK(
      refusal_of(letters +
                 "printed = \"a\"\ntruth = { integral = \"1/x\", over = \"x\", from = \"0 m\", to = \"a\" }")
          .find("does not settle") != std::string::npos);
  CHECK(refusal_of(letters +
                   "printed = \"a\"\ntruth = { sum = \"a\", over = \"k\", from = \"1\", to = \"10^9\" }")
            .find("at most 10,000 terms") != std::string::npos);
  CHECK(refusal_of(letters + "printed = \"a\"\ntruth = { product = \"a\" }")
            .find("no key product in a truth") != std::string::npos);
  CHECK(refusal_of(letters + "printed = \"a\"\ntruth = \"sqrt(0 m - a) sqrt(1 m)\"")
            .find("no finite number at a = ") != std::string::npos);
  CHECK(refusal_of("letters = { a = \"3 to 1 m\" }\nprinted = \"a\"\ntruth = \"a a/a\"") ==
        "test.toml:5:18: a range goes up: 0.1 to 10 m");
  CHECK(refusal_of("letters = { m1 = \"1\", m_1 = \"2\" }\nprinted = \"m1\"\ntruth = \"m_1\"")
            .find("rename one") != std::string::npos);
  CHECK(refusal_of(letters + "printed = \"if(a < b, a, b)\"\ntruth = \"min(a, b)\"")
            .find("if has no place in a claim") != std::string::npos);
  CHECK(complaint([] { entry_of_text("t.toml", "title = \"x\"\n"); }).find("no model and no claim") !=
        std::string::npos);
  CHECK(complaint([] {
          entry_of_text("t.toml", sheet("printed = \"1 < 2\"") + "[need]\nfps = 60\n");
        }).find("need is of a motion, and there is no model") != std::string::npos);
}

TEST_CASE("verify judges a file's claims, and its exit code reports whether all are as stated",
          "[problem][claims][commands]") {
  const ScratchFolder scratch;
  const std::string right = sheet(letters + "printed = \"a b + b^2\"\ntruth = \"b (a + b)\"");
  const std::string good = scratch.file("good.toml", right).string();
  const auto ok = program::printed("verify " + good);
  CHECK(ok.status == 0);
  CHECK(program::says(ok, "good-it  confirmed  it"));
  const std::string bad =
      scratch.file("bad.toml", sheet(letters + "printed = \"a b - b^2\"\ntruth = \"b (a + b)\"")).string();
  const auto found = program::printed("verify " + bad);
  CHECK(found.status == 1);
  CHECK(program::says(found, "The file expects this to be confirmed, but it is unsettled"));
  CHECK(program::says(found, "printed FAILS"));
  CHECK(program::printed("verify " + bad + " --csv").status == 1);
  const auto marked = program::printed(
      "verify " +
      scratch
          .file("wrong.toml",
                sheet(letters + "printed = \"b (a - b)\"\ncorrected = \"b (a + b)\"\ntruth = \"a b + b^2\""))
          .string());
  CHECK(marked.status == 0);
  CHECK(program::says(marked, "printed  b(a⟦-⟧b)"));
  // A claim stated to be wrong that is not.
  CHECK(program::printed(
            "verify " +
            scratch
                .file("not_wrong.toml",
                      sheet(letters + "printed = \"b (a + b)\"\ncorrected = \"b a\"\ntruth = \"a b + b^2\""))
                .string())
            .status == 1);
  const auto none = program::run("verify " + scratch.file("none.toml", "title = \"x\"\n").string());
  CHECK(none.status == 2);
  CHECK(program::run("verify " + good + " '[3.5]'").status == 2);
  CHECK(program::run("verify " + good + " --approve").status == 2);
  const auto solved = program::printed("solve " + good);
  CHECK(solved.status == 0);
  CHECK(program::says(solved, "good-it  confirmed  it"));
  CHECK(program::run("choose " + good + " --error 1").status == 2);
}
