#include "formula/signs.hpp"

#include <array>
#include <unordered_map>

namespace oddity::formula {

namespace {

using enum Role;

// clang-format off
constexpr std::array signs{
    Sign{R"(\alpha)", "α", letter}, Sign{R"(\beta)", "β", letter}, Sign{R"(\gamma)", "γ", letter},
    Sign{R"(\delta)", "δ", letter}, Sign{R"(\epsilon)", "ε", letter}, Sign{R"(\varepsilon)", "ε", letter},
    Sign{R"(\zeta)", "ζ", letter}, Sign{R"(\eta)", "η", letter}, Sign{R"(\theta)", "θ", letter},
    Sign{R"(\vartheta)", "ϑ", letter}, Sign{R"(\iota)", "ι", letter}, Sign{R"(\kappa)", "κ", letter},
    Sign{R"(\lambda)", "λ", letter}, Sign{R"(\mu)", "μ", letter}, Sign{R"(\nu)", "ν", letter},
    Sign{R"(\xi)", "ξ", letter}, Sign{R"(\pi)", "π", letter}, Sign{R"(\rho)", "ρ", letter},
    Sign{R"(\sigma)", "σ", letter}, Sign{R"(\tau)", "τ", letter}, Sign{R"(\upsilon)", "υ", letter},
    Sign{R"(\phi)", "φ", letter}, Sign{R"(\varphi)", "φ", letter}, Sign{R"(\chi)", "χ", letter},
    Sign{R"(\psi)", "ψ", letter}, Sign{R"(\omega)", "ω", letter}, Sign{R"(\Gamma)", "Γ", letter},
    Sign{R"(\Delta)", "Δ", letter}, Sign{R"(\Theta)", "Θ", letter}, Sign{R"(\Lambda)", "Λ", letter},
    Sign{R"(\Xi)", "Ξ", letter}, Sign{R"(\Pi)", "Π", letter}, Sign{R"(\Sigma)", "Σ", letter},
    Sign{R"(\Phi)", "Φ", letter}, Sign{R"(\Psi)", "Ψ", letter}, Sign{R"(\Omega)", "Ω", letter},
    Sign{R"(\ell)", "ℓ", letter}, Sign{R"(\imath)", "ı", letter}, Sign{R"(\jmath)", "ȷ", letter},
    Sign{R"(\hbar)", "ħ", letter}, Sign{R"(\infty)", "∞", letter}, Sign{R"(\partial)", "∂", letter},
    Sign{R"(\nabla)", "∇", letter}, Sign{R"(\emptyset)", "∅", letter}, Sign{R"(\circ)", "∘", letter},
    Sign{R"(\prime)", "′", letter}, Sign{R"(\ldots)", "…", letter}, Sign{R"(\dots)", "…", letter},
    Sign{R"(\cdots)", "⋯", letter}, Sign{R"(\degree)", "°", letter}, Sign{R"(\%)", "%", letter},
    Sign{"=", "=", relation}, Sign{"<", "<", relation}, Sign{">", ">", relation},
    Sign{R"(\le)", "≤", relation}, Sign{R"(\leq)", "≤", relation}, Sign{R"(\ge)", "≥", relation},
    Sign{R"(\geq)", "≥", relation}, Sign{R"(\ne)", "≠", relation}, Sign{R"(\neq)", "≠", relation},
    Sign{R"(\approx)", "≈", relation}, Sign{R"(\sim)", "∼", relation}, Sign{R"(\equiv)", "≡", relation},
    Sign{R"(\propto)", "∝", relation}, Sign{R"(\ll)", "≪", relation}, Sign{R"(\gg)", "≫", relation},
    Sign{R"(\to)", "→", relation}, Sign{R"(\rightarrow)", "→", relation}, Sign{R"(\mapsto)", "↦", relation},
    Sign{R"(\Rightarrow)", "⇒", relation}, Sign{R"(\implies)", "⇒", relation}, Sign{R"(\iff)", "⇔", relation},
    Sign{R"(\in)", "∈", relation}, Sign{R"(\notin)", "∉", relation}, Sign{R"(\subset)", "⊂", relation},
    Sign{R"(\subseteq)", "⊆", relation}, Sign{R"(\cup)", "∪", relation}, Sign{R"(\cap)", "∩", relation},
    Sign{R"(\perp)", "⊥", relation}, Sign{R"(\parallel)", "∥", relation}, Sign{":", ":", relation},
    Sign{",", ",", sign}, Sign{";", ";", sign}, Sign{"+", "+", sign}, Sign{"-", "−", sign},
    Sign{"*", "∗", sign}, Sign{R"(\ast)", "∗", sign}, Sign{R"(\pm)", "±", sign}, Sign{R"(\mp)", "∓", sign},
    Sign{R"(\cdot)", "·", sign}, Sign{R"(\times)", "×", sign}, Sign{R"(\div)", "÷", sign},
    Sign{"(", "(", opening}, Sign{"[", "[", opening}, Sign{R"(\{)", "{", opening},
    Sign{R"(\langle)", "⟨", opening}, Sign{R"(\lceil)", "⌈", opening}, Sign{R"(\lfloor)", "⌊", opening},
    Sign{")", ")", closing}, Sign{"]", "]", closing}, Sign{R"(\})", "}", closing},
    Sign{R"(\rangle)", "⟩", closing}, Sign{R"(\rceil)", "⌉", closing}, Sign{R"(\rfloor)", "⌋", closing},
    Sign{R"(\sum)", "∑", large}, Sign{R"(\prod)", "∏", large}, Sign{R"(\int)", "∫", large},
    Sign{R"(\iint)", "∬", large}, Sign{R"(\oint)", "∮", large}, Sign{R"(\lim)", "lim", large},
    Sign{R"(\dot)", "˙", accent}, Sign{R"(\ddot)", "¨", accent}, Sign{R"(\dddot)", "⃛", accent},
    Sign{R"(\bar)", "¯", accent}, Sign{R"(\overline)", "¯", accent}, Sign{R"(\hat)", "^", accent},
    Sign{R"(\tilde)", "~", accent}, Sign{R"(\vec)", "\u20d7", accent},
    Sign{R"(\mathbf)", "\U0001D400", font}, Sign{R"(\boldsymbol)", "\U0001D468", font},
    Sign{R"(\mathcal)", "", font}, Sign{R"(\mathit)", "", font}, Sign{R"(\mathsf)", "", font},
    Sign{R"(\det)", "det", function}, Sign{R"(\arg)", "arg", function}, Sign{R"(\log)", "log", function},
    Sign{R"(\max)", "max", function}, Sign{R"(\min)", "min", function}, Sign{R"(\sup)", "sup", function},
    Sign{R"(\inf)", "inf", function}, Sign{R"(\gcd)", "gcd", function}, Sign{R"(\cot)", "cot", function},
    Sign{R"(\sec)", "sec", function}};
// clang-format on

}  // namespace

const Sign* sign_of(std::string_view tex) {
  static const std::unordered_map<std::string_view, const Sign*> by_name = [] {
    std::unordered_map<std::string_view, const Sign*> made;
    for (const Sign& sign : signs) made.emplace(sign.tex, &sign);
    return made;
  }();
  const auto found = by_name.find(tex);
  return found == by_name.end() ? nullptr : found->second;
}

bool has_role(std::string_view tex, Role role) {
  const Sign* found = sign_of(tex);
  return found && found->role == role;
}

char32_t code_point(std::string_view c) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(c[i]); };
  if (c.empty()) return 0;
  if (byte(0) < 0x80) return byte(0);
  char32_t x = c.size() == 2 ? byte(0) & 0x1FU : c.size() == 3 ? byte(0) & 0x0FU : byte(0) & 0x07U;
  for (std::size_t i = 1; i < c.size(); ++i) x = x << 6U | (byte(i) & 0x3FU);
  return x;
}

std::string character(char32_t x) {
  if (x < 0x80) return {static_cast<char>(x)};
  std::string c;
  const int more = x < 0x800 ? 1 : x < 0x10000 ? 2 : 3;
  c += static_cast<char>((0xFF00U >> static_cast<unsigned>(more + 1) & 0xFFU) |
                         x >> static_cast<unsigned>(6 * more));
  for (int i = more - 1; i >= 0; --i)
    c += static_cast<char>(0x80U | (x >> static_cast<unsigned>(6 * i) & 0x3FU));
  return c;
}

}  // namespace oddity::formula
