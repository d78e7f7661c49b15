// Readings that are stated as text only: their value, their single changes, and refusals.

#include <algorithm>
#include <string>

#include "chapters/claims.hpp"
#include "chapters/near_misses.hpp"
#include "chapters/particle_sums.hpp"
#include "chapters/provable_claims.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

struct Point {
  double x, y;
  explicit Point(Random& random) : x(random.between(1, 2)), y(random.between(3, 4)) {}
  std::array<double*, 2> letters() { return {&x, &y}; }
  TypesetLetters typeset() const { return {{"x", x}, {"y", y}, {"s", x + y}}; }
  std::string where() const { return listed(typeset(), 2); }
};

const Formula<Point> truth{"by hand", [](const Point& p) { return p.x * p.x - 2 * p.y; }};

Claim claim(const FormulaClaim<Point>& parts) {
  Claims claims("9.9");
  claims.formula("text", 1, "text", draw<Point>(40, 1), parts);
  return claims.in_order().at(0);
}

double value(const std::string& text, const TypesetLetters& letters) {
  return TypesetFormula(text)(letters)[0];
}

}  // namespace

TEST_CASE("a reading of text only has the value of its text", "[claims]") {
  const Claim right = claim({.truth = truth, .printed = {"$x^2-2y$"}});
  CHECK(verdict(right) == Verdict::confirmed);
  CHECK(right.printed.as_typeset);
  const Claim wrong =
      claim({.truth = truth, .printed = {"$x^2+2y$"}, .corrected = {"$x^2-2y$"}, .kind = Fault::formula});
  CHECK(verdict(wrong) == Verdict::wrong);
}

TEST_CASE("a derivative takes the rates of bold letters, too", "[claims]") {
  const TypesetLetters letters{{R"(\mathbf r)", {1, 2, 3}},
                               {R"(\dot{\mathbf r})", {0, -1, 2}},
                               {R"(\mathbf u_1)", {2, 0, 1}},
                               {R"(\dot{\mathbf u}_1)", {-1, 4, 5}}};
  CHECK(value(R"($\frac{d}{dt}(\mathbf r\cdot\mathbf u_1)$)", letters) == 24);
}

TEST_CASE("every single change of a right text is a near miss, and the hardest to see is shown", "[claims]") {
  const Claim right = claim({.truth = truth, .printed = {"$x^2-2y$"}});
  REQUIRE(right.near_misses.size() == 1);
  CHECK_FALSE(right.near_misses[0].holds());
  CHECK(right.near_misses[0].text.find("the hardest to see of ") != std::string::npos);
  // If stated by a function, it has only the given ones.
  CHECK(claim({.truth = truth, .printed = {"$x^2-2y$", truth.of}}).near_misses.empty());
}

TEST_CASE("a change that holds leaves a claim unsettled, unless the reason is known", "[claims]") {
  const Formula<Point> zero{"zero", [](const Point&) { return 0.0; }};
  CHECK(verdict(claim({.truth = zero, .printed = {"$s-x=y$"}})) == Verdict::confirmed);
  const Claim doubled = claim({.truth = zero, .printed = {"$2(s-x-y)=0$"}});
  CHECK(verdict(doubled) == Verdict::unsettled);
  const Claim known =
      claim({.truth = zero, .printed = {"$2(s-x-y)=0$"}, .changes_that_hold = "a factor of zero is free"});
  CHECK(verdict(known) == Verdict::confirmed);
  CHECK(known.near_misses[0].text.ends_with("others hold: a factor of zero is free"));
}

TEST_CASE("changes without an effect are not counted", "[claims]") {
  std::vector<TypesetSample> samples;
  for (const Point& p : draw<Point>(4, 1)) samples.push_back({p.typeset(), 2 * p.x});
  const Changes changes = changes_of(TypesetFormula("$x+x$"), samples);
  CHECK(changes.equal == 0);
  CHECK(changes_of(TypesetFormula("$(1,1)\\cdot(x,x)$"), samples).equal == 2);  // components exchanged
  // In a row they are equal, however its forms are rounded; within a product they are not.
  const Changes row = changes_of(TypesetFormula("$(x+x,\\ 2x)$"), samples);
  const auto exchanged = [](const ChangedFormula& changed) {
    return changed.change == "components exchanged";
  };
  CHECK(std::ranges::none_of(row.hardest_first, exchanged));
  const Changes product = changes_of(TypesetFormula("$(2,0)\\cdot(x,y)$"), samples);
  CHECK(std::ranges::any_of(product.hardest_first, exchanged));
  for (const ChangedFormula& changed : changes.hardest_first) CHECK(changed.roundings > 1e6);
  CHECK(changes_of(TypesetFormula("$x$"), {}).hardest_first.empty());
}

TEST_CASE("forms of one quantity may be in any order", "[claims]") {
  const Formula<Point> twice{"by hand, twice", [](const Point& p) {
                               const double z = p.x * p.x - 2 * p.y;
                               return Value{z, z};
                             }};
  CHECK(verdict(claim({.truth = twice, .printed = {"$(x^2-2y,\\ xx-y-y)$"}})) == Verdict::confirmed);
}

TEST_CASE("a single number is compared with each of the forms in a row", "[claims]") {
  CHECK(verdict(claim({.truth = truth, .printed = {"$(x^2-2y,\\ xx-y-y)$"}})) == Verdict::confirmed);
  CHECK(verdict(claim({.truth = truth, .printed = {"$(x^2-2y,\\ xx-y)$"}})) != Verdict::confirmed);
}

TEST_CASE("a statement of text only is its relation", "[claims]") {
  const auto judge = [](const StatementClaim<Point>& parts) {
    Claims claims("9.9");
    claims.statement("text", 1, "text", draw<Point>(40, 1), parts);
    return verdict(claims.in_order().at(0));
  };
  CHECK(judge({.printed = {"$x<y$"}, .near_misses = {{"$y<x$"}}}) == Verdict::confirmed);
  CHECK(judge({.printed = {"$x+y=s$"}, .near_misses = {{"$x+y>s$"}}}) == Verdict::confirmed);
  CHECK(judge({.printed = {"$x>y$"}, .near_misses = {{"$y=x$"}}}) != Verdict::confirmed);
  CHECK_THROWS_AS(judge({.printed = {"$x<q$"}}), std::logic_error);
  CHECK_THROWS_AS(judge({.printed = {"it is less"}}), std::logic_error);
}

TEST_CASE("a reading has to agree with every route", "[claims]") {
  const Formula<Point> again{"again", truth.of}, other{"another", [](const Point&p) { return p.x; }};
  CHECK(verdict(claim({.truth = truth, .other_routes = {again}, .printed = {"$x^2-2y$"}})) ==
        Verdict::confirmed);
  CHECK(verdict(claim({.truth = truth, .other_routes = {again, other}, .printed = {"$x^2-2y$"}})) !=
        Verdict::confirmed);
}

TEST_CASE("a text is recorded for proofs with its functions and powers", "[claims][proofs]") {
  const auto recorded = [](const std::string& text) {
    return recorded_text("$" + text + "$", {{"x", Shortened::letter("x")}})[0].coq();
  };
  CHECK(recorded(R"(\ln x)") == "ln (x)");
  CHECK(recorded(R"(\cos^{-1}(x/2))") == "acos (x / 2)");
  CHECK(recorded("x^{3/2}") == "(sqrt (x)) ^ 3");
  CHECK(recorded("x^{-1/2}") == "1 / (sqrt (x)) ^ 1");
  CHECK(recorded("x^{1/3}") == "exp (1 / 3 * ln (x))");
  CHECK(recorded("0=x-1") == "x - 1");
  CHECK(recorded(R"(\int_0^1u\,du)") == "(RInt (fun t => t) (0) (1))");
  CHECK(recorded(R"(\int_0^1\int_0^uuv\,dv\,du)") ==
        "(RInt (fun t' => (RInt (fun t => t' * t) (0) (t'))) (0) (1))");
}

TEST_CASE("sums of a text are recorded over any number of particles", "[claims][proofs]") {
  const TypesetIn<Shortened> letters{
      {"c", Shortened::letter("c")}, {"m_{1}", Shortened::letter("m")}, {"x_{1}", Shortened::letter("x")}};
  CHECK(recorded_sums(R"($c\sum m_ix_i-\sum m_i$)", letters, "m x")[0].coq() ==
        "c * (total l (fun m x => m * x)) - (total l (fun m x => m))");
}

TEST_CASE("an equation's value is the difference of its sides, except with a name on the left", "[claims]") {
  const TypesetLetters letters{{"x", 3}, {"y", 5}};
  CHECK(value("$x+y$", letters) == 8);
  CHECK(value("$2x=y$", letters) == 1);
  CHECK(value("$2x=0$", letters) == 6);
  CHECK(value("$W'(T)=y$", letters) == 5);
  CHECK(value(R"($\ddot q_1=y$)", letters) == 5);
  CHECK(value("$x=y$", letters) == 5);
  CHECK(value("$=y$", letters) == 5);
  CHECK(value("$0=2x$", letters) == 6);
  CHECK(TypesetFormula("$0=(x,y)$")(letters)[1] == 5);
  for (const char* text : {"x+y", "the same", "$x<y$", "$x=y=2$", "$x+q$", "$q+1=x$", "$x=$", "$(1,x)+y$"})
    CHECK_THROWS_AS(TypesetFormula(text)(letters), std::logic_error);
}
