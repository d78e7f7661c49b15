#include "report/text/readable.hpp"

#include "chapters/contents.hpp"
#include "formula/shown.hpp"
#include "reference/reference.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

std::vector<std::string> texts_of(const Reading& reading) {
  std::vector<std::string> all{reading.text};
  for (const Check& c : reading.checks)
    all.insert(all.end(), {c.quantity, c.left.by, c.right.by, c.tolerance.reason, c.where});
  return all;
}

std::vector<std::string> texts_of(const Claim& claim) {
  std::vector<std::string> all{claim.says, claim.why, claim.not_checkable};
  std::vector<Reading> readings{claim.printed, claim.meant, claim.corrected};
  readings.insert(readings.end(), claim.near_misses.begin(), claim.near_misses.end());
  for (const Reading& reading : readings)
    for (const std::string& text : texts_of(reading)) all.push_back(text);
  return all;
}

std::vector<std::string> texts_of(const Quantity& q) {
  std::vector<std::string> all{q.says, q.reference.by, q.need.reason};
  for (const Method& m : q.methods) all.push_back(m.why);
  for (const Breakdown& b : q.breakdowns) all.push_back(text_of(b, q, Trial{}, Trial{}));
  return all;
}

std::vector<std::string> formulas_of(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text[i] == '$' || text[i] == '`' ? text.find(text[i], i + 1) : std::string::npos;
    if (end == std::string::npos) continue;
    if (text[i] == '$') all.push_back(text.substr(i + 1, end - i - 1));
    i = end;
  }
  return all;
}

/// All texts of an exercise for readers.
std::vector<std::string> texts_of(const Exercise& exercise) {
  const std::filesystem::path tables = std::filesystem::path(ODDITY_SOURCE) / "reference";
  const Findings findings = exercise.study(Parameters(exercise.parameters), Reference(tables));
  std::vector<std::string> all{std::string(exercise.title), std::string(exercise.asks)};
  for (const Parameter& p : exercise.parameters) all.emplace_back(p.says);
  for (const Root& root : findings.roots) all.push_back(root.shows);
  const auto add = [&](const auto& parts) {
    for (const auto& part : parts)
      for (const std::string& text : texts_of(part)) all.push_back(text);
  };
  add(findings.claims), add(findings.quantities);
  return all;
}

}  // namespace

TEST_CASE("a formula becomes Unicode text", "[readable]") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {R"($T=80$ s)", "T = 80 s"},
      {R"($\mathbf r\times\mathbf v$ and $\boldsymbol\xi_3$)", "r×v and ξ₃"},
      {R"($r\cos^2\omega t\ne0$)", "r cos² ωt ≠ 0"},
      {R"($\sigma\,\mathrm{Skew}(\mathbf U_3)$)", "σ Skew(U₃)"},
      {R"($\dot\theta_1+\ddot{\mathbf r}$)", "θ'₁+r''"},
      {R"($I_{xx}'+2^{-20}x^{n+1}e^{kx}-v^+$)", "I_xx'+2⁻²⁰x^(n+1)e^(kx)-v⁺"},
      {R"($30^\circ$ to $\infty$)", "30° to ∞"},
      {R"($\frac{a}{b}$, $\frac12m$, $\frac{a+b}{2c}$)", "a/b, (1/2)m, (a+b)/(2c)"},
      {R"($\frac{d}{dt}\frac{\partial L}{\partial\dot q}$)", "(d/dt)(∂L/∂q')"},
      {R"($\sqrt2\,K$, $\sqrt{1+t^2}$, $\sqrt[3]x$)", "√2 K, √(1+t²), ³√x"},
      {R"($\left(\tfrac{|\mathbf x|^2}{|\mathbf x|^3}\right)$)", "(|x|²/|x|³)"},
      {R"($\begin{pmatrix}1&1\\-1&1\end{pmatrix}a$)", "(1 1; -1 1)a"},
      {R"($\{P,Q\}$, $\sum_{k\le n}a_kb_{rk}$)", "{P,Q}, Σ_(k≤n)a_k b_rk"},
      {R"($\mathrm{kg\,m^2/s}$ or $16\,\text{area of it}^2$)", "kg m²/s or 16 area of it²"},
      {R"(`a$b` and $x$)", "a$b and x"}};
  for (const auto& [text, plain] : cases) CHECK(readable(text) == plain);
}

TEST_CASE("text that is no formula is unchanged, and invalid TeX does no harm", "[readable]") {
  for (const std::string text : {"", "5 $", "$$", "`", R"(a\b {c})", "x_1^2"}) CHECK(readable(text) == text);
  for (const std::string tex : {"}", "{", R"(\)", "^", "_", R"(\frac)", R"(\sqrt[)", R"(\text{)", R"(\left)",
                                R"(\begin)", "}}a{{", R"(\dot)", "'", R"(a^{\frac{1}{)"})
    CHECK_NOTHROW(readable("$" + tex + "$"));
}

TEST_CASE("two formulas are readable with their differences in brackets, and prose has none", "[readable]") {
  const formula::Marks marks{"[", "]"};
  const auto both = formulas_that_differ("$a-2b$", R"($a+2\beta$)", marks, marks);
  REQUIRE(both);
  CHECK(both->first == "a[-]2[b]");
  CHECK(both->second == "a[+]2[β]");
  CHECK_FALSE(formulas_that_differ("half of $a$", "$a$", marks, marks));
  CHECK_FALSE(formulas_that_differ("$a$", "$a$", marks, marks));
  CHECK(typed(R"($\dot\theta^2\le\frac{g}{L}$ and `x`)") == "theta'^2 <= g/L and x");
}

TEST_CASE("the readable texts of exercises contain no TeX", "[readable][claims]") {
  for (const Entry& entry : registry())
    for (const std::string& text : texts_of(entry.exercise)) {
      const std::string plain = readable(text);
      INFO(to_string(entry.number) << ": " << text);
      const auto count = [](const std::string& in, const std::string& what) {
        std::size_t n = 0;
        for (auto at = in.find(what); at != std::string::npos; at = in.find(what, at + what.size())) ++n;
        return n;
      };
      CHECK(plain.find_first_of("\\$") == std::string::npos);
      for (const std::string& formula : formulas_of(text)) CHECK_NOTHROW(formula::parse_shown(formula));
      CHECK(count(plain, "{") == count(text, "\\{"));
      CHECK(count(plain, "}") == count(text, "\\}"));
    }
}
