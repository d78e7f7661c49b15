#include "report/pages/readable.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace oddity {

namespace tex {

namespace {

using Signs = std::map<std::string_view, std::string_view>;

const Signs letters{
    {"alpha", "α"},      {"beta", "β"},    {"gamma", "γ"},  {"delta", "δ"},   {"epsilon", "ε"},
    {"varepsilon", "ε"}, {"zeta", "ζ"},    {"eta", "η"},    {"theta", "θ"},   {"vartheta", "ϑ"},
    {"iota", "ι"},       {"kappa", "κ"},   {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},
    {"xi", "ξ"},         {"pi", "π"},      {"rho", "ρ"},    {"sigma", "σ"},   {"tau", "τ"},
    {"upsilon", "υ"},    {"phi", "φ"},     {"varphi", "φ"}, {"chi", "χ"},     {"psi", "ψ"},
    {"omega", "ω"},      {"Gamma", "Γ"},   {"Delta", "Δ"},  {"Theta", "Θ"},   {"Lambda", "Λ"},
    {"Xi", "Ξ"},         {"Pi", "Π"},      {"Sigma", "Σ"},  {"Phi", "Φ"},     {"Psi", "Ψ"},
    {"Omega", "Ω"},      {"ell", "ℓ"},     {"imath", "i"},  {"jmath", "j"},   {"hbar", "ħ"},
    {"infty", "∞"},      {"partial", "∂"}, {"nabla", "∇"},  {"sum", "Σ"},     {"prod", "Π"},
    {"int", "∫"},        {"oint", "∮"},    {"circ", "∘"},   {"prime", "'"},   {"emptyset", "∅"},
    {"vert", "|"},       {"Vert", "‖"},    {"|", "‖"},      {"ldots", "..."}, {"dots", "..."},
    {"cdots", "..."},    {"degree", "°"},  {"%", "%"},      {"#", "#"},       {"&", "&"},
    {"_", "_"}};
const Signs operators{{"cdot", "·"}, {"times", "×"}, {"pm", "±"}, {"mp", "∓"}, {"div", "÷"}, {"ast", "*"}};
const Signs relations{
    {"le", "≤"},         {"leq", "≤"},        {"ge", "≥"},       {"geq", "≥"},    {"ne", "≠"},
    {"neq", "≠"},        {"approx", "≈"},     {"sim", "~"},      {"equiv", "≡"},  {"propto", "∝"},
    {"ll", "≪"},         {"gg", "≫"},         {"to", "→"},       {"mapsto", "↦"}, {"in", "∈"},
    {"notin", "∉"},      {"subset", "⊂"},     {"subseteq", "⊆"}, {"cup", "∪"},    {"cap", "∩"},
    {"Rightarrow", "⇒"}, {"rightarrow", "→"}, {"implies", "⇒"},  {"perp", "⊥"},   {"parallel", "∥"}};
const Signs openings{{"lceil", "⌈"}, {"lfloor", "⌊"}, {"langle", "⟨"}, {"{", "{"}};
const Signs closings{{"rceil", "⌉"}, {"rfloor", "⌋"}, {"rangle", "⟩"}, {"}", "}"}};
const Signs accents{{"dot", "'"},           {"ddot", "''"},    {"dddot", "'''"},    {"bar", "\u0304"},
                    {"overline", "\u0304"}, {"hat", "\u0302"}, {"tilde", "\u0303"}, {"vec", "\u20d7"}};
const Signs raised{{"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"}, {"5", "⁵"},
                   {"6", "⁶"}, {"7", "⁷"}, {"8", "⁸"}, {"9", "⁹"}, {"+", "⁺"}, {"-", "⁻"}};
const Signs lowered{{"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"}, {"5", "₅"},
                    {"6", "₆"}, {"7", "₇"}, {"8", "₈"}, {"9", "₉"}, {"+", "₊"}, {"-", "₋"}};
/// These change how letters look, or how large brackets are.
const std::set<std::string_view> unseen{
    "mathbf", "mathit", "mathsf", "mathcal", "boldsymbol", "displaystyle", "left",  "right", "big",    "Big",
    "bigl",   "bigr",   "Bigl",   "Bigr",    "bigg",       "Bigg",         "biggl", "biggr", "limits", "!"};
const std::set<std::string_view> spaces{",", ";", ":", " ", "quad", "qquad"};

enum class Kind { ordinary, word, sign, relation, opening, closing, fraction, space };

struct Piece {
  Kind kind;
  std::string text;
};
using Pieces = std::vector<Piece>;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// What stands to the left or the right of a fraction is read into it, unless this is in brackets.
bool holds_on_left(Kind kind) {
  return kind == Kind::ordinary || kind == Kind::closing || kind == Kind::fraction;
}
bool holds_on_right(Kind kind) {
  return kind == Kind::ordinary || kind == Kind::opening || kind == Kind::word || kind == Kind::fraction;
}

std::string joined(const Pieces& pieces, bool tight = false) {
  std::string text;
  const auto space = [&] {
    if (!text.empty() && text.back() != ' ') text += ' ';
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& [kind, own] = pieces[i];
    const Kind before = i > 0 ? pieces[i - 1].kind : Kind::sign;
    const Kind after = i + 1 < pieces.size() ? pieces[i + 1].kind : Kind::sign;
    const bool apart = (kind == Kind::relation && !tight) || kind == Kind::space;
    if (apart || (kind == Kind::word && holds_on_left(before))) space();
    if (kind == Kind::fraction && (holds_on_left(before) || holds_on_right(after)))
      text += "(" + own + ")";
    else if (kind != Kind::space)
      text += own;
    const bool ends_in_index = own.find('_') != std::string::npos && own.back() != ')';
    if (apart || ((kind == Kind::word || ends_in_index) && after != Kind::opening && holds_on_right(after)))
      space();
  }
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

/// Whether a bracket of the text ends with it that begins with it.
bool in_brackets(const Pieces& pieces) {
  int depth = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    depth += pieces[i].kind == Kind::opening ? 1 : pieces[i].kind == Kind::closing ? -1 : 0;
    if (depth == 0) return pieces[i].kind == Kind::closing && i + 1 == pieces.size();
  }
  return false;
}

bool is_factor(const Pieces& pieces) {
  if (pieces.size() == 1) return pieces[0].kind == Kind::ordinary || pieces[0].kind == Kind::closing;
  if (pieces.size() == 2 && (pieces[0].text == "d" || pieces[0].text == "∂"))
    return pieces[1].kind == Kind::ordinary;
  const auto bars = [](const Piece& piece) { return piece.text.starts_with('|'); };
  return in_brackets(pieces) || (pieces.size() > 2 && bars(pieces[0]) && bars(pieces.back()) &&
                                 std::ranges::count_if(pieces, bars) == 2);
}

bool is_sum(const Pieces& pieces) {
  int depth = 0;
  for (const Piece& piece : pieces) {
    depth += piece.kind == Kind::opening ? 1 : piece.kind == Kind::closing ? -1 : 0;
    if (depth == 0 && (piece.kind == Kind::relation || piece.text == "+" || piece.text == "-" ||
                       piece.text == "±" || piece.text == "∓"))
      return true;
  }
  return false;
}

std::string bracketed(const Pieces& pieces, bool bare) {
  return bare ? joined(pieces, true) : "(" + joined(pieces, true) + ")";
}
std::string as_factor(const Pieces& pieces) { return bracketed(pieces, is_factor(pieces)); }

/// In raised or lowered signs, where there is one for each; else empty.
std::string in_signs(const std::string& text, const Signs& signs) {
  std::string all;
  for (char c : text) {
    const auto found = signs.find(std::string_view(&c, 1));
    if (found == signs.end()) return "";
    all += found->second;
  }
  return all;
}

std::string exponent(const Pieces& pieces) {
  const std::string text = joined(pieces, true), signs = in_signs(text, raised);
  if (text == "∘") return "°";
  if (text == "*" || text.find_first_not_of('\'') == std::string::npos) return text;
  return !signs.empty() ? signs : "^" + bracketed(pieces, pieces.size() == 1 || in_brackets(pieces));
}

std::string index(const Pieces& pieces) {
  const std::string text = joined(pieces, true), signs = in_signs(text, lowered);
  return !signs.empty() ? signs : text.empty() ? "" : "_" + bracketed(pieces, !is_sum(pieces));
}

class Formula {
 public:
  explicit Formula(std::string_view tex) : tex_(tex) {}

  std::string text() {
    Pieces all;
    while (at_ < tex_.size()) {
      const Pieces some = until_brace();
      all.insert(all.end(), some.begin(), some.end());
      ++at_;
    }
    return joined(all);
  }

 private:
  bool sees(char c) const { return at_ < tex_.size() && tex_[at_] == c; }

  /// To the brace that ends the group, or to the end.
  Pieces until_brace() {
    Pieces pieces;
    while (at_ < tex_.size() && tex_[at_] != '}') {
      if (sees('^') || sees('_')) {
        const bool up = tex_[at_++] == '^';
        const Pieces script = atom();
        if (pieces.empty()) pieces.push_back({Kind::ordinary, ""});
        Piece& base = pieces.back();
        if (base.kind == Kind::fraction) base = {Kind::closing, "(" + base.text + ")"};
        base.text += up ? exponent(script) : index(script);
      } else {
        add(pieces);
      }
    }
    return pieces;
  }

  void add(Pieces& pieces) {
    for (Piece& piece : atom()) {
      const bool number = piece.kind == Kind::ordinary && piece.text.size() == 1 &&
                          (is_digit(piece.text[0]) || piece.text == ".");
      if (number && !pieces.empty() && pieces.back().kind == Kind::ordinary &&
          is_digit(pieces.back().text[0]) &&
          (is_digit(pieces.back().text.back()) || pieces.back().text.back() == '.'))
        pieces.back().text += piece.text;
      else if (piece.text == "'" && !pieces.empty())
        pieces.back().text += "'";
      else
        pieces.push_back(std::move(piece));
    }
  }

  /// A group, a command with what it takes, or a sign.
  Pieces atom() {
    while (sees(' ')) ++at_;
    if (at_ >= tex_.size()) return {};
    const char c = tex_[at_++];
    if (c == '{') return group();
    if (c == '\\') return command(name());
    if (c == '&' || c == '~') return {{Kind::space, ""}};
    if (c == '(' || c == '[') return {{Kind::opening, {c}}};
    if (c == ')' || c == ']') return {{Kind::closing, {c}}};
    if (c == '=' || c == '<' || c == '>') return {{Kind::relation, {c}}};
    if (std::string_view("+-*/,;:").find(c) != std::string_view::npos) return {{Kind::sign, {c}}};
    std::string sign{c};
    while (at_ < tex_.size() && (tex_[at_] & 0xC0) == 0x80) sign += tex_[at_++];
    return {{Kind::ordinary, sign}};
  }

  Pieces group() {
    Pieces pieces = until_brace();
    ++at_;
    return pieces;
  }

  std::string_view name() {
    const std::size_t begin = at_;
    while (at_ < tex_.size() && is_letter(tex_[at_])) ++at_;
    if (at_ == begin && at_ < tex_.size()) ++at_;
    return tex_.substr(begin, at_ - begin);
  }

  Pieces command(std::string_view name) {
    for (const auto& [kind, signs] : {std::pair(Kind::ordinary, &letters),
                                      {Kind::sign, &operators},
                                      {Kind::relation, &relations},
                                      {Kind::opening, &openings},
                                      {Kind::closing, &closings}})
      if (const auto found = signs->find(name); found != signs->end())
        return {{kind, std::string(found->second)}};
    if (name.ends_with("frac")) return fraction();
    if (name == "sqrt") return root();
    if (name == "begin" || name == "end") return matrix(name == "begin");
    if (name == "\\") return {{Kind::sign, ";"}, {Kind::space, ""}};
    if (spaces.contains(name)) return {{Kind::space, ""}};
    if (const auto found = accents.find(name); found != accents.end()) {
      const Pieces inside = atom();
      return {{Kind::ordinary, as_factor(inside) + std::string(found->second)}};
    }
    if (name == "mathrm" || name == "operatorname") return word(atom());
    if (name == "text") return words();
    if (unseen.contains(name)) {
      if ((name == "left" || name == "right") && sees('.')) ++at_;
      return {};
    }
    return {{Kind::word, std::string(name)}};
  }

  Pieces fraction() {
    const Pieces above = atom(), below = atom();
    return {{Kind::fraction, bracketed(above, !is_sum(above)) + "/" + as_factor(below)}};
  }

  Pieces root() {
    std::string degree;
    if (sees('[')) {
      const std::size_t begin = at_ + 1, end = std::min(tex_.find(']', begin), tex_.size());
      degree = tex_.substr(begin, end - begin);
      at_ = end + 1;
    }
    return {{Kind::ordinary, in_signs(degree, raised) + "√" + as_factor(atom())}};
  }

  /// "\begin{pmatrix}" and the like.
  Pieces matrix(bool begins) {
    atom();
    return {begins ? Piece{Kind::opening, "("} : Piece{Kind::closing, ")"}};
  }

  /// In upright letters: a name, or a unit.
  static Pieces word(const Pieces& pieces) {
    const bool name = pieces.size() > 1 && std::ranges::all_of(pieces, [](const Piece& piece) {
                        return piece.text.size() == 1 && is_letter(piece.text[0]);
                      });
    return name ? Pieces{{Kind::word, joined(pieces)}} : pieces;
  }

  /// With their spaces.
  Pieces words() {
    if (!sees('{')) return atom();
    const std::size_t begin = at_ + 1, end = std::min(tex_.find('}', begin), tex_.size());
    at_ = end + 1;
    return {{Kind::word, std::string(tex_.substr(begin, end - begin))}};
  }

  std::string_view tex_;
  std::size_t at_ = 0;
};

}  // namespace

}  // namespace tex

std::string readable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto end = c == '$' || c == '`' ? text.find(c, i + 1) : std::string::npos;
    if (end == std::string::npos || end == i + 1) {
      out += c;
      continue;
    }
    const std::string inside = text.substr(i + 1, end - i - 1);
    out += c == '$' ? tex::Formula(inside).text() : inside;
    i = end;
  }
  return out;
}

}  // namespace oddity
