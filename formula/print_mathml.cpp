#include <algorithm>
#include <array>

#include "formula/name_writer.hpp"
#include "formula/print.hpp"
#include "formula/signs.hpp"
#include "formula/writer.hpp"

namespace oddity::formula {

namespace {

std::string tag(const std::string& name, const std::string& inside) {
  return "<" + name + ">" + inside + "</" + name + ">";
}

std::string escaped(const std::string& text) {
  std::string all;
  for (const char c : text)
    all += c == '<'   ? "&lt;"
           : c == '&' ? "&amp;"
           : c == '>' ? "&gt;"
           : c == '"' ? "&quot;"
                      : std::string(1, c);
  return all;
}

/// Number of top-level elements in a text of MathML.
std::size_t count_of(const std::string& inside) {
  std::size_t count = 0;
  int depth = 0;
  for (std::size_t i = 0; i + 1 < inside.size(); ++i)
    if (inside[i] == '<') {
      const bool ends = inside[i + 1] == '/';
      if (!ends && depth == 0) ++count;
      depth += ends ? -1 : 1;
    }
  return count;
}
/// Combines the elements into one, for parents with a fixed number of children.
std::string single(const std::string& inside) { return count_of(inside) == 1 ? inside : tag("mrow", inside); }

/// Position of the last of these elements.
std::size_t last_of(const std::string& inside) {
  std::size_t last = 0;
  int depth = 0;
  for (std::size_t i = 0; i + 1 < inside.size(); ++i)
    if (inside[i] == '<') {
      const bool ends = inside[i + 1] == '/';
      if (!ends && depth == 0) last = i;
      depth += ends ? -1 : 1;
    }
  return last;
}
/// Attaches the exponent to the last element, such as a closing bracket; behind an index, above it.
std::string raised(const std::string& base, const std::string& exponent) {
  const std::size_t last = last_of(base);
  const std::string own = base.empty() ? tag("mrow", "") : base.substr(last);  // m$^2$
  if (own.starts_with("<msub>"))
    return base.substr(0, last) + tag("msubsup", own.substr(6, own.size() - 13) + exponent);
  return base.substr(0, last) + tag("msup", own + exponent);
}

/// Whether brackets around it have to grow.
bool is_tall(const std::string& inside) {
  return std::ranges::any_of(std::array{"<mfrac", "<mtable"},
                             [&](const char* what) { return inside.find(what) != std::string::npos; });
}
/// A bracket that grows is an operator, which opens as the first of its row and closes as the last.
std::string bracket(const std::string& sign, bool tall) { return tag(tall ? "mo" : "mi", sign); }

std::string sign_in_mathml(const std::string& command) {
  // The two forms of phi (and epsilon) are different letters.
  if (command == R"(\phi)") return "ϕ";
  if (command == R"(\epsilon)") return "ϵ";
  const Sign* sign = sign_of(command);
  return escaped(sign ? std::string(sign->shown) : command.starts_with('\\') ? command.substr(1) : command);
}

/// Bold letters are separate characters.
std::string in_font(const std::string& letter, const std::string& font) {
  const char32_t c = code_point(letter);
  if (font != R"(\mathbf)" && font != R"(\boldsymbol)") return letter;
  const bool italic = font == R"(\boldsymbol)";
  const auto from = [&](char32_t first, char32_t upright, char32_t slanted) {
    return character((italic ? slanted : upright) + c - first);
  };
  if (c >= U'A' && c <= U'Z') return from(U'A', 0x1D400, 0x1D468);
  if (c >= U'a' && c <= U'z') return from(U'a', 0x1D41A, 0x1D482);
  if (c >= U'0' && c <= U'9') return from(U'0', 0x1D7CE, 0x1D7CE);
  if (c >= U'Α' && c <= U'Ω') return from(U'Α', 0x1D6A8, 0x1D71C);
  if (c >= U'α' && c <= U'ω') return from(U'α', 0x1D6C2, 0x1D736);
  return letter;
}

/// Whether a letter without a font is upright.
bool is_upright(const std::string& token) {
  return token == R"(\partial)" || token == R"(\nabla)" || token == R"(\ell)" ||
         (token.size() > 1 && token[1] >= 'A' && token[1] <= 'Z');
}

class MathMlName : public NameWriter {
  std::string atom(const std::string& token, const std::string& font) override {
    if (token[0] >= '0' && token[0] <= '9') return tag("mn", in_font(token, font));
    if (has_role(token, Role::letter) || token.size() > 1 ||
        std::isalpha(static_cast<unsigned char>(token[0])) != 0)
      return tag(font == R"(\mathrm)" || font == R"(\text)" || is_upright(token) ? "mtext" : "mi",
                 in_font(sign_in_mathml(token), font));
    return tag("mo", sign_in_mathml(token));
  }
  std::string accented(const std::string& base, const std::string& accent) override {
    const bool stretches = accent != R"(\dot)" && accent != R"(\ddot)" && accent != R"(\dddot)";
    return tag("mover", single(base) + (stretches ? "<mo stretchy=\"false\">" : "<mo>") +
                            sign_in_mathml(accent) + "</mo>");
  }
  std::string with_scripts(const std::string& base, const std::string& below, std::size_t primes) override {
    const std::size_t last = last_of(base);
    const std::string before = base.substr(0, last), own = base.substr(last);
    const std::string above = tag("mo", std::array{"", "′", "″", "‴"}[std::min<std::size_t>(primes, 3)]);
    if (primes == 0) return before + tag("msub", own + single(below));
    return before + (below.empty() ? tag("msup", own + above) : tag("msubsup", own + single(below) + above));
  }
};

class MathMl : public Writer {
 public:
  /// The parts of a formula between which a line may end.
  struct Part {
    std::string text;
    bool relation = false, sign = false, comma = false;
  };
  std::vector<Part> parts(const Tree& x) {
    std::vector<Part> all;
    if (x.kind() == Kind::line) {
      for (const Tree& side : x->children)
        for (Part& part : parts(side)) all.push_back(std::move(part));
      return all;
    }
    if (x.kind() == Kind::sum) {
      for (std::size_t i = 0; i < x->children.size(); ++i)
        all.push_back({sign_of_term(x, i) + term(x.child(i)), false, i > 0, false});
      return all;
    }
    const bool relation = x.kind() == Kind::sign && has_role(x->text, Role::relation);
    return {{of(x), relation, false, x.kind() == Kind::sign && x->text.starts_with(",")}};
  }

 private:
  std::string number(const std::string& digits) override { return tag("mn", digits); }
  std::string letter(const std::string& name) override { return MathMlName().of(name); }
  std::string sign(const std::string& name, bool prefix) override {
    if (name == "pi") return tag("mi", "π");
    const std::string own = name == "pm"          ? "±"
                            : name == "mp"        ? "∓"
                            : name == "dot"       ? "·"
                            : name == "cross"     ? "×"
                            : name == "comma"     ? ","
                            : name == "semicolon" ? ";"
                            : name == "-"         ? "−"
                                                  : name;
    return prefix ? "<mo form=\"prefix\">" + own + "</mo>" : tag("mo", own);
  }
  /// Puts a thin space before the name of a function.
  std::string side_by_side(const std::string& left, const std::string& right) override {
    const bool function = right.starts_with("<mi>\u2061") || right.starts_with("<msup><mi>\u2061");
    return left + (function ? thin : "") + right;
  }
  std::string apart(const std::string& left, const std::string& right) override {
    return left + thin + right;
  }
  std::string bar(const std::string& left, const std::string& right) override {
    return left + tag("mi", "/") + right;
  }
  std::string fraction(const Tree& above, const Tree& below) override {
    return tag("mfrac", single(of(above)) + single(of(below)));
  }
  std::string power(const std::string& base, const Tree& exponent) override {
    return raised(base, single(of(exponent)));
  }
  std::string transposed(const std::string& base) override { return raised(base, tag("mi", "T")); }
  /// An invisible mark distinguishes the name of a function from a letter.
  std::string function(const std::string& name, const std::string& exponent, const Tree& x) override {
    const bool apart =
        exponent.empty() && is_plain_argument(x) && x.kind() != Kind::group && x.kind() != Kind::nothing;
    const std::string own = tag("mi", "\u2061" + sign_in_mathml(name) + (apart ? "\u2009" : ""));
    const std::string head = exponent.empty() ? own : tag("msup", own + single(exponent));
    if (!is_plain_argument(x)) return head + parentheses(of(x));
    return head + (apart || x.kind() == Kind::group || x.kind() == Kind::nothing ? "" : thin) + of(x);
  }
  std::string root(const Tree& x, const std::string& degree) override {
    return degree.empty() ? tag("msqrt", of(x)) : tag("mroot", single(of(x)) + single(degree));
  }
  std::string bars(const Tree& x, bool twice) override {
    const std::string sign = twice ? "‖" : "|";
    return between(sign, of(x), sign);
  }
  std::string parentheses(const std::string& inside) override { return brackets("(", inside, ")"); }
  std::string brackets(const std::string& opening, const std::string& inside,
                       const std::string& closing) override {
    return between(sign_in_mathml(opening), inside, sign_in_mathml(closing));
  }
  static std::string between(const std::string& opening, const std::string& inside,
                             const std::string& closing) {
    const bool tall = is_tall(inside);
    const std::string all = bracket(opening, tall) + inside + bracket(closing, tall);
    return tall ? tag("mrow", all) : all;
  }
  std::string matrix(const std::vector<Parts>& rows, const std::string& environment) override {
    std::string all;
    for (const Parts& row : rows) {
      std::string cells;
      for (const std::string& cell : row) cells += tag("mtd", cell);
      all += tag("mtr", cells);
    }
    const std::string table = tag("mtable", all);
    if (environment == "cases") return tag("mrow", bracket("{", true) + table);
    if (environment == "bmatrix") return brackets("[", table, "]");
    if (environment == "vmatrix") return brackets("|", table, "|");
    return environment.empty() ? parentheses(table) : table;
  }
  std::string named(const std::string& name, const std::string& inside) override {
    return tag("mi", name) + parentheses(inside);
  }
  std::string sum_over(const std::string& index, const std::string& last, const std::string& body) override {
    const std::string below = last.empty() ? letter(index) : letter(index) + tag("mo", "≤") + last;
    return tag("msub", tag("mo", "∑") + single(below)) + body;
  }
  std::string integral(const Tree& x) override {
    return tag("msubsup", tag("mo", "∫") + single(of(x.child(0))) + single(of(x.child(1)))) + of(x.child(2)) +
           thin + tag("mi", "d") + letter(x->text);
  }
  std::string along_curve(const Tree& x) override {
    return tag("mo", "∫") + of(x.child(0)) + thin + tag("mi", "d") + tag("mi", "s");
  }
  std::string time_derivative(const std::string& x) override {
    return tag("mfrac", tag("mi", "d") + tag("mrow", tag("mi", "d") + tag("mi", "t"))) + x;
  }
  std::string indexed(const std::string& base, const std::string& scripts) override {
    return scripts == "!" ? base + tag("mi", "!") : MathMlName().behind(base, scripts);
  }
  std::string relation(const std::string& command) override {
    if (command == "+") return sign("+", true);
    if (command == ", ") return "<mo>,</mo>" + thin;
    return tag(has_role(command, Role::opening) || has_role(command, Role::closing) ? "mi" : "mo",
               sign_in_mathml(command));
  }
  std::string large(const std::string& command, const Tree& below, const Tree* above) override {
    const bool name = has_role(command, Role::function) || command == R"(\lim)";
    const std::string own = tag(name ? "mi" : "mo", sign_in_mathml(command));
    const bool limits = below.kind() != Kind::nothing;
    if (!limits && !above) return own + (name ? thin : "");
    if (!limits) return tag("msup", own + single(of(*above)));
    if (!above) return tag("msub", own + single(of(below)));
    return tag("msubsup", own + single(of(below)) + single(of(*above)));
  }
  std::string words(const std::string& text) override { return tag("mtext", escaped(text)); }
  std::string upright(const Tree& x) override {
    std::string inside = of(x);
    for (std::size_t at = 0; (at = inside.find("<mi>", at)) != std::string::npos; at += 25)
      inside.replace(at, 4, "<mi mathvariant=\"normal\">");
    return inside;
  }
  std::string marked(const std::string& inside) override {
    return "<mrow class=\"differs\">" + inside + "</mrow>";
  }
  bool fraction_is_factor() const override { return true; }

  const std::string thin = "<mtext>\u2009</mtext>";
};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

/// Shortens the text and removes the marks of functions. A name gets its spaces, adjacent brackets and texts
/// are merged, and the first sign in a row is a prefix anyway.
std::string finished(std::string text) {
  replace_all(text, "<mtext>\u2009</mtext><mi>\u2061", "<mi>\u2009");
  replace_all(text, "\u2061", "");
  replace_all(text, "</mtext><mtext>", "");
  for (const std::string row : {"<math>", "<mrow>", "<mtd>"})
    replace_all(text, row + "<mo form=\"prefix\">", row + "<mo>");
  constexpr std::string_view brackets = "()[]|/", seam = "</mi><mi>";
  for (std::size_t at = 0; (at = text.find(seam, at)) != std::string::npos;) {
    const bool both = brackets.find(text[at - 1]) < brackets.size() &&
                      brackets.find(text[at + seam.size()]) < brackets.size();
    if (both)
      text.erase(at, seam.size());
    else
      at += seam.size();
  }
  return text;
}

std::size_t width_of(const std::string& text) {
  std::size_t n = 0;
  bool inside_tag = false;
  for (const char c : text) {
    inside_tag = c == '<' || (inside_tag && c != '>');
    n += !inside_tag && c != '>' && (static_cast<unsigned char>(c) & 0xC0U) != 0x80;
  }
  return n;
}

}  // namespace

std::string mathml(const Tree& x) { return finished(MathMl().of(x)); }

std::string mathml_in_pieces(const Tree& x) {
  constexpr std::size_t shortest_of_all = 16, shortest = 12;
  const auto parts = MathMl().parts(x);
  std::size_t all = 0, width = 0;
  for (const MathMl::Part& part : parts) all += width_of(part.text);
  std::string pieces = "<math>";
  bool after_comma = false;
  for (const MathMl::Part& part : parts) {
    const bool ends =
        (part.relation && width > shortest / 2) || ((part.sign || after_comma) && width > shortest);
    std::string text = part.text;
    if (all > shortest_of_all && ends) {
      pieces += "</math><math>";
      width = 0;
      const std::size_t sign = part.sign ? text.find("<mo>") : std::string::npos;
      if (sign != std::string::npos) text.replace(sign, 4, "<mo form=\"infix\">");
    }
    pieces += text;
    width += width_of(part.text);
    after_comma = part.comma;
  }
  return finished(pieces + "</math>");
}

}  // namespace oddity::formula
