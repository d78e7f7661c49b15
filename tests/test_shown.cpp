#include "formula/shown.hpp"

#include <string>

#include "formula/print.hpp"
#include "report/verify/catch.hpp"

using namespace oddity::formula;

namespace {

std::string shown(const char* text) { return mathml(parse_shown(text)); }
std::string in_unicode(const char* text) { return unicode(parse_shown(text)); }
std::string read(const char* text) { return unicode(with_all_brackets(parse_shown(text))); }

/// Both formulas with [ ] around their differences.
std::string differences(const char* a, const char* b) {
  const auto [left, right] = with_differences_marked(parse_shown(a), parse_shown(b));
  const Marks marks{"[", "]"};
  return unicode(left, marks) + " | " + unicode(right, marks);
}

std::string refusal(const std::string& text) {
  try {
    parse_shown(text);
  } catch (const Unreadable& error) {
    CHECK(error.place() <= text.size());
    return error.reason();
  }
  return "";
}

}  // namespace

TEST_CASE("a formula in any letters is printed in the form in which it is written", "[formula]") {
  for (const char* text : {"x",
                           "m_2g-c_1(K_1-L_1+y_2)",
                           R"(\frac{a+b}{2c})",
                           R"(a/b/c)",
                           "[0,1)",
                           R"(\{P,Q\})",
                           "W(T)=r",
                           R"(\mathbf r\times\mathbf v)",
                           R"(\dot\theta_1^{2})",
                           R"(\nabla\cdot\mathbf f)",
                           "x\\le y<z",
                           R"(\begin{pmatrix}1&1\\-1&1\end{pmatrix}a)",
                           "((a))",
                           "|v|>|r_2||p|",
                           "q^{*}",
                           "4!=24",
                           R"(\sum_{k\le n}^{m}a_k)",
                           R"((\nabla\times)^{n}\mathbf f)",
                           "+2c",
                           ")",
                           "("}) {
    const Tree tree = parse_shown(text);
    INFO(text << " as " << tex(tree));
    CHECK(tex(parse_shown(tex(tree))) == tex(tree));
    CHECK(mathml(parse_shown(tex(tree))) == mathml(tree));
    CHECK(in_unicode(tex(tree).c_str()) == unicode(tree));
  }
  CHECK(tex(parse_shown("m_2g-c_1(K_1-L_1+y_2)")) == "m_2g-c_1(K_1-L_1+y_2)");
  CHECK(plain(parse_shown(R"(\dot\theta^2\le\frac12\sqrt{g/L})")) == "theta'^2 <= (1/2) sqrt(g/L)");
}

TEST_CASE("MathML has an element for each part of a formula", "[formula]") {
  CHECK(shown(R"(\frac{a+1}2)") == "<mfrac><mrow><mi>a</mi><mo>+</mo><mn>1</mn></mrow><mn>2</mn></mfrac>");
  CHECK(shown("x_1^2") == "<msubsup><mi>x</mi><mn>1</mn><mn>2</mn></msubsup>");
  CHECK(shown("(a+b)^2") == "<mi>(</mi><mi>a</mi><mo>+</mo><mi>b</mi><msup><mi>)</mi><mn>2</mn></msup>");
  CHECK(shown(R"((\frac ab)^2)") ==
        "<msup><mrow><mo>(</mo><mfrac><mi>a</mi><mi>b</mi></mfrac><mo>)</mo></mrow><mn>2</mn></msup>");
  CHECK(shown(R"(\ddot{\mathbf r}')") ==
        "<msup><mover><mi>\U0001D42B</mi><mo>¨</mo></mover><mo>′</mo></msup>");
  CHECK(shown(R"(\vec v)") == "<mover><mi>v</mi><mo stretchy=\"false\">\u20d7</mo></mover>");
  CHECK(
      shown(R"(\int_0^1x\,dx)") ==
      "<msubsup><mo>∫</mo><mn>0</mn><mn>1</mn></msubsup><mi>x</mi><mtext>\u2009</mtext><mi>d</mi><mi>x</mi>");
  CHECK(shown(R"(\sqrt[3]x+\Delta)") == "<mroot><mi>x</mi><mn>3</mn></mroot><mo>+</mo><mtext>Δ</mtext>");
  CHECK(shown(R"(\boldsymbol\xi<\text{a & b})") ==
        "<mi>\U0001D743</mi><mo>&lt;</mo><mtext>a &amp; b</mtext>");
  CHECK(shown(R"(\begin{cases}x&x\ge0\\-x&x<0\end{cases})") ==
        "<mrow><mo>{</mo><mtable><mtr><mtd><mi>x</mi></mtd><mtd><mi>x</mi>"
        "<mo>≥</mo><mn>0</mn></mtd></mtr><mtr><mtd><mo>−</mo><mi>x</mi></mtd><mtd><mi>x</mi>"
        "<mo>&lt;</mo><mn>0</mn></mtd></mtr></mtable></mrow>");
}

TEST_CASE("a long formula may be broken before relations and signs", "[formula]") {
  const auto pieces = [](const char* text) {
    const std::string all = mathml_in_pieces(parse_shown(text));
    std::size_t n = 0;
    for (std::size_t at = 0; (at = all.find("<math>", at)) != std::string::npos; ++at) ++n;
    return n;
  };
  CHECK(pieces("a+b=c") == 1);
  CHECK(pieces("aaaaaaaa=bbbbbbbb+cccccccccccccc+d") == 3);
  CHECK(pieces("(aaaaaaaaaaaaaa+bbbbbbbbbbbbbbbbbb)") == 1);
  CHECK(pieces("aaaaaaaaaaaaaaa,b") == 2);
}

TEST_CASE("the differences of two formulas are marked", "[formula]") {
  CHECK(differences("a-GM/r", "a+GM/r") == "a[-]GM/r | a[+]GM/r");
  CHECK(differences("m_2g", "m_2g+2c") == "m₂g | m₂g[+2c]");
  CHECK(differences(R"(\frac{GM}{r_0})", R"(\frac{Gm}{r_0})") == "G[M]/r₀ | G[m]/r₀");
  CHECK(differences(R"(\sin(a-b)=c)", R"(\cos(a-b)=c)") == "[sin(a-b)] = c | [cos(a-b)] = c");
  CHECK(differences(R"(1\,\sqrt x)", R"(1/\sqrt x)") == "1 [√x] | 1/[√x]");
  CHECK(differences("(1,2,3)", "(1,-2,3)") == "(1,2,3) | (1,[-]2,3)");
  CHECK(differences("x^2y", "x^3y") == "x[²]y | x[³]y");
  CHECK(differences("x^{n}y", "x^{m}y") == "x^([n])y | x^([m])y");
  CHECK(differences("a+b", "a+b") == "a+b | a+b");
}

TEST_CASE("each operand is bracketed as it is read", "[formula]") {
  CHECK(read("m_2g-c_1(K_1-L_1)") == "(m₂g)-(c₁(K₁-L₁))");
  CHECK(read("a/bc") == "(a/b)c");
  CHECK(read("ab/c") == "(ab)/c");
  CHECK(read(R"(\sin\omega t\,R)") == "sin(ωt) R");
  CHECK(read(R"(\frac12mv^2)") == "(1/2)mv²");
  CHECK(read("W(T)=-x") == "W(T) = -x");
  CHECK(read("(1,2m)") == "(1,2m)");
  CHECK(read(R"(\mathbf u\cdot\mathbf v\times\mathbf w)") == "u·(v×w)");
}

TEST_CASE("a formula that cannot be shown is refused with the place of the fault", "[formula]") {
  CHECK(refusal(R"(\nonsense{x})") == R"(no command \nonsense is known)");
  CHECK(refusal("a^{b") == "expected }");
  CHECK(refusal("a}") == "this closes a bracket that nothing opens");
  CHECK(refusal(R"(\frac a)") == "expected a letter, a number or a group");
  CHECK(refusal("|a") == "expected the other bar");
  CHECK_FALSE(refusal("a\x03").empty());
  CHECK_FALSE(refusal(std::string(100, '(') + "a").empty());
  CHECK_FALSE(refusal(std::string(30'000, 'a')).empty());
  CHECK(refusal(std::string(19'000, 'a')).empty());
  for (const char* text :
       {"{", R"(\)", "^", "_", "x_", R"(\sqrt[)", R"(\text{)", R"(\begin)", R"(\mathbf)", R"(\dot)",
        "a^{\\frac{1}{", "!", "\xC3", R"(\begin{x}&\\)", R"(\sum_)", R"(\mathrm)", R"(\mathrm{)"})
    CHECK_NOTHROW(refusal(text));
}
