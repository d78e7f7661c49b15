// Formulas as trees: read, evaluated, differentiated, printed, changed.

#include <cmath>
#include <string>
#include <vector>

#include "formula/code.hpp"
#include "formula/differentiate.hpp"
#include "formula/evaluate.hpp"
#include "formula/magnitude.hpp"
#include "formula/mutants.hpp"
#include "formula/parse.hpp"
#include "formula/print.hpp"
#include "formula/reader.hpp"
#include "formula/tokens.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity::formula;

namespace {

const Names names{
    "m", "m_2", "g",   R"(\theta)", R"(\dot\theta)", R"(\ddot\theta)", "y_2",    R"(\dot y_2)", "u",
    "v", "M",   "x_1", "x_2",       R"(\pm)",        "a_{11}",         "a_{12}", "a_{21}",      "a_{22}"};
const std::vector<Matrix<double>> values{{{2}},
                                         {{3}},
                                         {{9.81}},
                                         {{0.7}},
                                         {{-1.3}},
                                         {{0.4}},
                                         {{5}},
                                         {{-6}},
                                         {{1, 2, 3}},
                                         {{-1, 0.5, 2}},
                                         of_letter<double>({1, 2, 3, 4, 5, 6, 7, 8, 10}),
                                         {{1.5}},
                                         {{2.5}},
                                         {{-1}},
                                         {{1}},
                                         {{2}},
                                         {{3}},
                                         {{4}}};

double value(const Tree& tree) { return evaluate(tree, values).entries.at(0); }
double tex_value(const char* text) { return value(parse_tex(text, names)); }
double plain_value(const char* text) { return value(parse_plain(text, names)); }

/// The message for a text that cannot be read.
std::string refusal(const char* text, bool plain = false) {
  try {
    plain ? parse_plain(text, names) : parse_tex(text, names);
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "";
}

constexpr const char* formulas[] = {"m_2g-m(m_2-y_2+1)",
                                    R"(\frac12m\dot\theta^2\sin^2\theta)",
                                    R"(-m/m_2g+2^{10}-2(3))",
                                    "(m+m_2)^{-3/2}",
                                    R"(\sqrt{\frac m2}|u-v|)",
                                    R"(u\cdot M^TMv)",
                                    R"(|(u\times v)\times u|)",
                                    R"(\sum_i x_i^2(m-x_i))",
                                    R"(\sum_{k\le 1}x_k+m)",
                                    R"(\frac{d}{dt}(m\dot\theta\cos\theta)+1)",
                                    R"(\int_0^{m_2}m t^2\,dt-1)",
                                    R"(m\pm\theta\mp g)",
                                    R"(\max(m,g)-\min(\theta,1))",
                                    R"(e^{-\theta}+\ln m_2+\arctan\theta)",
                                    R"(\sum_\sigma\varepsilon_\sigma a_{\sigma(1)1}a_{\sigma(2)2})",
                                    R"(\int_0^1t\int_1^m x^t\,dx\,dt)",
                                    R"((-m)^2-m^2)",
                                    R"(\cos^{-1}(\theta/2))",
                                    R"((\cos\theta)^{-1}+m^{x_1})",
                                    R"(m-(g-m)-(\theta+g))",
                                    R"(m/(g/\theta)/2)"};

}  // namespace

TEST_CASE("typed text is read like the page's", "[formula]") {
  CHECK(plain_value("theta'' + g/m sin(theta)") == tex_value(R"(\ddot\theta+g/m\sin\theta)"));
  CHECK(plain_value("m y_2' - m*g*(y_2 - 1)") == tex_value(R"(m\dot y_2-mg(y_2-1))"));
  CHECK(plain_value("2 m/m_2 g") == tex_value("2m/m_2g"));
  CHECK(plain_value("sin(theta)^2 + cos(theta)**2") == tex_value(R"(\sin^2\theta+\cos^2\theta)"));
  CHECK(plain_value("-m^2") == -4);
  CHECK(plain_value("m^-1 + 1.5e-1") == 0.65);
  CHECK(plain_value("max(m, g) + abs(theta - 1) + sqrt(4 m_2 + 4) + pi") ==
        9.81 + (1 - 0.7) + 4 + std::numbers::pi);
  CHECK(plain_value("dot(u, v) + log(exp(m))") == 8);
  CHECK(plain_name(R"(\ddot y_2)") == "y_2''");
  CHECK(plain_name(R"(\mathbf r)") == "r");
  CHECK(tex_name("theta_1''") == R"(\ddot\theta_1)");
  CHECK(tex_name("m_2") == "m_2");
  CHECK(tex(parse_plain("theta'' + 2 m", {"theta", "theta'", "theta''", "m"})) == R"(\ddot\theta+2m)");
}

TEST_CASE("known names may contain commas", "[formula]") {
  const Names fields{"phi", "phi,1", "f2", "f2,1", "a"};
  const PlainReader reader(fields);
  CHECK(reader.letters() == 5);
  CHECK(plain(reader("phi (f2,1 - a) + phi,1 f2")) == "phi (f2,1 - a) + phi,1 f2");
  CHECK(reader("max(a,f2,1)").kind() == Kind::largest);
  CHECK(reader("max(f2,a)").kind() == Kind::largest);
  CHECK_THROWS_AS(reader("f2,2"), Unreadable);
}

TEST_CASE("a printed formula is read as the same", "[formula]") {
  for (const char* formula : formulas) {
    const Tree tree = parse_tex(formula, names);
    INFO(formula << " as " << tex(tree));
    CHECK(near_ulps(value(parse_tex(tex(tree), names)), value(tree), 64));
    CHECK_FALSE(mathml(tree).empty());
  }
  for (const char* formula :
       {"m_2 g - m (m_2 - y_2 + 1)", "-m/m_2 g^(-m)", "sin(theta)^2/(2 m)", "(m/2)/(g/m_2)",
        "(-m)^2 - (g - (m - 1))", "max(m, -g) + sqrt(m) abs(-m)", "m^(m_2^2)"}) {
    const Tree tree = parse_plain(formula, names);
    INFO(formula << " as " << plain(tree));
    CHECK(value(parse_plain(plain(tree), names)) == value(tree));
  }
  CHECK(plain(parse_tex(R"(m_2g-\frac{m}{2}\dot y_2^2)", names)) == "m_2 g - (m/2) y_2'^2");
  CHECK(tex(parse_plain("-g/m sin(theta)", names)) == R"(-g/m\sin(\theta))");
}

TEST_CASE("a formula is printed as code in three languages", "[formula]") {
  const Tree tree = parse_tex(R"(\frac12m\dot y_2^2-m_2\sin\theta)", names);
  const Names scalars{"m", "m_2", "g", R"(\theta)", R"(\dot\theta)", R"(\ddot\theta)", "y_2", R"(\dot y_2)"};
  const Tree own = parse_tex(R"(\frac12m\dot y_2^2-m_2\sin\theta)", scalars);
  CHECK(code<Cpp>(own, scalars)[0] == "1.0 / 2.0 * m * (y_2_dot * y_2_dot) - m_2 * sin(theta)");
  CHECK(code<JavaScript>(own, scalars)[0] == "1 / 2 * m * y_2_dot ** 2 - m_2 * Math.sin(theta)");
  CHECK(code<Coq>(own, scalars)[0] == "1 / 2 * m * y_2_dot ^ 2 - m_2 * sin (theta)");
  CHECK(code<Coq>(parse_plain("-0.5 (m - 2)/(g m)", scalars), scalars)[0] ==
        "- (5 / 10 * (m - 2) / (g * m))");
  CHECK(code<Coq>(parse_tex(R"((m,\frac{d}{dt}y_2))", scalars), scalars) ==
        std::vector<std::string>{"m", "y_2_dot"});
  CHECK(code<JavaScript>(parse_plain("m + (-2) g - (-3) m", scalars), scalars)[0] == "m - 2 * g + 3 * m");
  CHECK(code<Cpp>(parse_plain("m - (g - m)", scalars), scalars, {"a", "b", "c"})[0] == "a - (c - a)");
}

TEST_CASE("derivatives agree with differences", "[formula]") {
  for (const char* formula :
       {"g^2m/g^3", R"(\sin^3g\cos(2g))", R"(\sqrt{1+g^2}/g)", R"(g^{m/g})", R"(\exp(-g/9)\ln g)",
        R"(\arctan g+\tanh(g/9))", R"(|ug-v|)", R"(\sum_i(x_i-g)^2)", R"(\arcsin(g/20)-\arccos(g/30))",
        R"((ug)\cdot(v\times u+gv))", R"(\int_0^1\cos(gt)\,dt)"}) {
    const Tree tree = parse_tex(formula, names);
    const auto at = [&](double x) {
      std::vector<Matrix<double>> moved = values;
      moved[2] = {{x}};
      return evaluate(tree, moved).entries[0];
    };
    constexpr double h = 1e-4;
    const double slope =
        (8 * (at(9.81 + h) - at(9.81 - h)) - (at(9.81 + 2 * h) - at(9.81 - 2 * h))) / (12 * h);
    INFO(formula);
    CHECK(std::abs(value(differentiate(tree, "g")) - slope) < 1e-9 * (1 + std::abs(slope)));
  }
  CHECK(value(differentiate(parse_tex("m+u", {"m", "u"}), "g")) == 0);
  CHECK_THROWS_AS(differentiate(parse_tex(R"(\max(g,1))", names), "g"), NoValue);
}

TEST_CASE("other number types give a formula's value as well", "[formula]") {
  for (const char* formula : {"m_2g-m(m_2-y_2+0.1)", R"(\sqrt{m}\sin\theta/\pi)", "g^{-3}+m^{1/2}"}) {
    const Tree tree = parse_tex(formula, names);
    std::vector<Matrix<long double>> longer;
    for (const auto& one : values) longer.push_back({{one.entries.begin(), one.entries.end()}, one.columns});
    std::vector<Matrix<float>> shorter;
    for (const auto& one : values) {
      shorter.push_back({{}, one.columns});
      for (const double x : one.entries) shorter.back().entries.push_back(static_cast<float>(x));
    }
    CHECK(near_ulps(static_cast<double>(evaluate(tree, longer).entries[0]), value(tree), 8));
    CHECK(std::abs(static_cast<double>(evaluate(tree, shorter).entries[0]) - value(tree)) <
          1e-5 * std::abs(value(tree)) + 1e-5);
  }
}

TEST_CASE("a formula's magnitude is that of its terms, even if they cancel", "[formula]") {
  CHECK(magnitude(parse_tex("m-m", names), values) == 4);
  CHECK(magnitude(parse_tex("m(g-g)", names), values) == 2 * 2 * 9.81);
  CHECK(magnitude(parse_tex("(m,m_2-m_2)", names), values) == 6);
}

TEST_CASE("a formula is mutated at every place", "[formula]") {
  const Tree tree = parse_tex(R"(m_2g-\frac12m\sin\theta)", names);
  const auto changed = mutants(tree);
  const auto has = [&](const char* text) {
    const double wanted = tex_value(text);
    return std::ranges::any_of(
        changed, [&](const Mutant& mutant) { return std::abs(value(mutant.tree) - wanted) < 1e-12; });
  };
  for (const char* text :
       {R"(m_2g+\frac12m\sin\theta)", R"(-m_2g-\frac12m\sin\theta)", "m_2g", R"(-\frac12m\sin\theta)",
        R"(2m_2g-\frac12m\sin\theta)", R"(m_2g-m\sin\theta)", R"(mg-\frac12m\sin\theta)",
        R"(m_2g-\frac12m\cos\theta)", R"(m_2g-\frac12m\theta)", R"(m_2g-\frac12\sin\theta)",
        R"(m_2g-\frac13m\sin\theta)", R"(m_2/g-\frac12m\sin\theta)", R"(m_2g-\frac12m\sin g)",
        R"(2(m_2g-\frac12m\sin\theta))", R"(m_2-\frac12m\sin\theta)"})
    CHECK(has(text));
  for (const Mutant& mutant : changed) CHECK_FALSE(mutant.change.empty());
  // A derivative's mutants change its argument.
  const Tree rate = parse_tex(R"(\frac{d}{dt}(m\sin\theta))", names);
  CHECK(std::ranges::any_of(mutants(rate), [&](const Mutant& mutant) {
    return std::abs(value(mutant.tree) - 2 * std::sin(0.7) * 1.3) < 1e-12;
  }));
}

TEST_CASE("an unreadable text is shown with the place of the fault and a suggestion", "[formula]") {
  CHECK(refusal("m_2g-m(m_3+g)") ==
        "cannot read this formula:\n  m_2g-m(m_3+g)\n         ^ no letter m_3 here; m_2, m?");
  CHECK(refusal("m+") == "cannot read this formula:\n  m+\n    ^ expected a factor");
  CHECK(refusal("(m+g").ends_with("^ expected )"));
  CHECK(refusal("m)").ends_with("  m)\n   ^ the formula ends before this"));
  CHECK(refusal(R"(m+*g)").ends_with("^ expected a number, a letter or ("));
  CHECK(refusal("thta + m", true).find("no letter thta here; theta?") != std::string::npos);
  CHECK(refusal(R"(\sum_kz_k)").find("no letter") != std::string::npos);
  CHECK(refusal(R"(\frac{d}{dt}\max(m,g))").find("no derivative") != std::string::npos);
  try {
    parse_tex("m_2+q", names);
  } catch (const Unreadable& error) {
    CHECK(error.place() == 4);
    CHECK(error.reason() == "no letter q here");
  }
}

TEST_CASE("hostile text is refused in bounded time and depth", "[formula]") {
  const auto many = [](const std::string& part, int n) {
    std::string text;
    for (int i = 0; i < n; ++i) text += part;
    return text;
  };
  for (const std::string& text :
       {many("(", 9'000), many("{", 9'000), many("|", 9'000), many("m^", 9'000), many(R"(\frac)", 3'000),
        many(R"(m\cdot )", 2'000), many(R"(\sin)", 4'000), many(R"(\sqrt)", 3'000), many(R"(\sum_i)", 3'000),
        many(R"(\frac{d}{dt})", 1'500) + "m", many("m", 30'000), std::string(100, '\0'), many("\\", 9'999),
        many(R"(\int_0^1)", 2'000)})
    for (const bool plain : {false, true}) CHECK((text[0] == '\0' || !refusal(text.c_str(), plain).empty()));
  const std::string nested = many(R"(\sum_i x_i\int_0^1)", 6) + "m" + many(R"(\,dt)", 6);
  CHECK_THROWS_AS(value(parse_tex(nested, names)), NoValue);
  const Tree longest = parse_tex(many("m+", 5'000) + "m", names);
  CHECK(value(longest) == 10'002);
  CHECK(mutants(longest).size() < 3'000);
}

TEST_CASE("shapes that do not fit have no value", "[formula]") {
  for (const char* text : {"u+m", "uv", "Mx_1+u", R"(u\times m)", "|M|", "m^u", R"(\sin u)",
                           R"(\mathrm{Skew}(m))", R"(\begin{pmatrix}1&2\\3\end{pmatrix})", "x^T"})
    CHECK_THROWS(value(parse_tex(text, names)));
}

TEST_CASE("a relation consists of its sides", "[formula]") {
  const Relation relation = parse_tex_relation(R"(m<m_2\le \sum_{k\le 2}x_k)", names);
  CHECK(relation.relations == std::vector<std::string>{"<", R"(\le)"});
  CHECK(relation.sides.size() == 3);
  CHECK(value(relation.sides[2]) == 4);
  const Relation typed = parse_plain_relation("theta'' = -g/m sin(theta)", names);
  CHECK(typed.relations == std::vector<std::string>{"="});
  CHECK(value(typed.sides[0]) == 0.4);
}
