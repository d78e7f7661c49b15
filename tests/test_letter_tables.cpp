// Letters of a sample from one table: drawn, on a page, in Coq; and claims over such samples.

#include <algorithm>
#include <string>

#include "chapters/claims.hpp"
#include "chapters/provable_claims.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

template <class T>
struct SwingOf {
  T m, angle, L;
  std::array<T, 2> v;

  Letters<T> table() {
    return {{"m", m, positive_size(0.01, 100)},
            {R"(\theta_1)", angle, either_sign(0.1, 1)},
            {R"(\dot L)", L, {3, 4}, "rate"},
            {"v", v, {-2, -1}}};
  }
  TypesetIn<T> typeset() const { return {{"p", m * L}}; }
};
using Swing = SwingOf<double>;

struct Unranged {
  double a;
  Letters<double> table() { return {{"a", a}}; }
};

const Formula<Swing> by_hand{"by hand", [](const Swing& s) { return s.m * s.L; }};

Claim equation(const std::string& text) {
  Claims claims("9.9");
  const auto samples = draw<Swing>(40, 1);
  claims.over(samples).equation("text", 1, text, by_hand);
  return claims.in_order().at(0);
}

}  // namespace

TEST_CASE("letters are drawn from their ranges", "[claims]") {
  bool is_below = false, is_above = false;
  for (const Swing& s : draw<Swing>(200, 7)) {
    CHECK((0.01 <= s.m && s.m <= 100));
    CHECK((0.1 <= std::abs(s.angle) && std::abs(s.angle) <= 1));
    CHECK((3 <= s.L && s.L < 4));
    for (const double x : s.v) CHECK((-2 <= x && x < -1));
    (s.angle < 0 ? is_below : is_above) = true;
  }
  CHECK((is_below && is_above));
  CHECK_THROWS_WITH(draw<Unranged>(1, 1), "a has no range to be drawn from");
}

TEST_CASE("a letter has its names on a page and in Coq", "[claims]") {
  const Swing swing{2, 0.5, 3, {-1, -2}};
  const TypesetLetters letters = typeset_of(swing);
  std::vector<std::string> names;
  for (const auto& [name, value] : letters) names.push_back(name);
  CHECK(names == std::vector<std::string>{"m", R"(\theta_1)", R"(\dot L)", "v", "p"});
  CHECK(letters[3].second[1] == -2);
  CHECK(letters[4].second[0] == 6);
  CHECK(names_in_coq<SwingOf<Shortened>>() == std::vector<std::string>{"m", "theta1", "rate", "v1", "v2"});
  const auto all = for_all<SwingOf>("ring", "it holds", {1, 2});
  CHECK(all.letters == "(m theta1 rate v1 v2 : R)");
  CHECK((all.any.L * all.any.v[1]).expression().coq() == "rate * v2");
  CHECK((all.example.m == 1 && all.example.angle == 2 && all.example.L == 0));
}

TEST_CASE("an equation states both sides, and the kind of fault follows from the readings", "[claims]") {
  CHECK(verdict(equation(R"($p=m\dot L$)")) == Verdict::confirmed);
  CHECK(equation(R"($p=m\dot L=\dot Lm$, the momentum)").printed.text == R"($(m\dot L,\ \dot Lm)$)");
  CHECK(verdict(equation(R"($p=2m\dot L$)")) != Verdict::confirmed);
  CHECK(verdict(equation(R"($q=m\dot L$)")) == Verdict::confirmed);  // no letter
  CHECK_THROWS_AS(equation(R"($m=m\dot L$)"), std::logic_error);
  CHECK_THROWS_WITH(equation("the momentum"), "the momentum is no equation $a=b$");

  const auto kind = [](const FormulaClaim<Swing>& parts) {
    Claims claims("9.9");
    claims.formula("text", 1, "text", draw<Swing>(40, 1), parts);
    return claims.in_order().at(0).kind;
  };
  const Formula<Swing> right{R"($m\dot L$)"}, wrong{R"($m+\dot L$)"};
  const InView<Swing> heavy{"for heavy ones", [](const Swing&s) { return s.m > 1; }},
      none{"for none", [](const Swing&) { return false; }};
  CHECK(kind({.truth = by_hand, .printed = right}) == Fault::none);
  CHECK(kind({.truth = by_hand, .printed = wrong, .meant = right}) == Fault::lost_typography);
  CHECK(kind({.truth = by_hand, .printed = wrong, .corrected = right}) == Fault::formula);
  CHECK(kind({.truth = by_hand, .printed = wrong, .corrected = right, .in_view = heavy}) == Fault::left_out);
  CHECK(kind({.truth = by_hand, .printed = wrong, .corrected = right, .kind = Fault::term}) == Fault::term);
  CHECK_THROWS_WITH(kind({.truth = by_hand, .printed = wrong, .corrected = right, .in_view = none}),
                    "no sample is a case 'for none'");
}
