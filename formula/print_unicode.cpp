#include <algorithm>
#include <cctype>

#include "formula/name_writer.hpp"
#include "formula/print.hpp"
#include "formula/signs.hpp"
#include "formula/writer.hpp"

namespace oddity::formula {

namespace {

/// Marks a place where a word needs a space next to letters, and the end of an index, after which a letter
/// needs one.
constexpr char word_gap = '\x01', behind_index = '\x02';
/// Marks around a difference.
constexpr char differs = '\x03', differs_no_more = '\x04';

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
}

/// The text in raised or lowered characters; empty if one is missing.
std::string in_signs(const std::string& text, const std::string& from, const std::vector<std::string>& to) {
  std::string all;
  for (const char c : text) {
    const std::size_t at = from.find(c);
    if (at == std::string::npos) return "";
    all += to[at];
  }
  return all;
}
std::string raised(const std::string& text) {
  return in_signs(text, "0123456789+-", {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁺", "⁻"});
}
std::string lowered(const std::string& text) {
  return in_signs(text, "0123456789+-", {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉", "₊", "₋"});
}

std::string sign_in_unicode(const std::string& command) {
  if (command == R"(\ldots)" || command == R"(\dots)" || command == R"(\cdots)") return "...";
  if (command == R"(\imath)" || command == R"(\jmath)") return command.substr(1, 1);
  if (command == R"(\prime)") return "'";
  const Sign* sign = sign_of(command);
  return sign ? std::string(sign->shown) : command.starts_with('\\') ? command.substr(1) : command;
}

bool is_sum(const std::string& text) {
  return std::ranges::any_of(std::initializer_list<const char*>{"+", "-", "=", "≤", "<", "≥", ">", "±"},
                             [&](const char* sign) { return text.find(sign, 1) != std::string::npos; });
}

std::string index(const std::string& text) {
  if (text.empty()) return "";
  const std::string signs = lowered(text);
  if (!signs.empty()) return signs;
  return is_sum(text) ? "_(" + text + ")" : "_" + text + behind_index;
}

class UnicodeName : public NameWriter {
  std::string atom(const std::string& token, const std::string&) override {
    return token == "-" ? token : sign_in_unicode(token);
  }
  std::string accented(const std::string& base, const std::string& accent) override {
    if (accent == R"(\dot)") return base + "'";
    if (accent == R"(\ddot)") return base + "''";
    if (accent == R"(\dddot)") return base + "'''";
    return base + (accent == R"(\hat)"     ? "\u0302"
                   : accent == R"(\tilde)" ? "\u0303"
                   : accent == R"(\vec)"   ? "\u20d7"
                                           : "\u0304");
  }
  std::string with_scripts(const std::string& base, const std::string& below, std::size_t primes) override {
    std::string own = index(below);
    const bool ends = own.ends_with(behind_index) && primes > 0;
    if (ends) own.pop_back();
    return base + own + std::string(primes, '\'') + (ends ? std::string(1, behind_index) : "");
  }
};

class Unicode : public Writer {
  std::string number(const std::string& digits) override { return digits; }
  std::string letter(const std::string& name) override { return UnicodeName().of(name); }
  std::string sign(const std::string& name, bool) override {
    if (name == "pi") return "π";
    if (name == "comma") return ",";
    if (name == "semicolon") return "; ";
    return name == "pm" ? "±" : name == "mp" ? "∓" : name == "dot" ? "·" : name == "cross" ? "×" : name;
  }
  std::string side_by_side(const std::string& left, const std::string& right) override {
    const bool digits = std::isdigit(static_cast<unsigned char>(right[0])) != 0 && !left.empty() &&
                        std::isdigit(static_cast<unsigned char>(left.back())) != 0;
    return left + (digits ? " " : "") + right;
  }
  std::string bar(const std::string& left, const std::string& right) override { return left + "/" + right; }
  std::string fraction(const Tree& above, const Tree& below) override {
    return written(above, Level::product) + "/" +
           (is_differential(below)
                ? of(below)
                : written(below, below.kind() == Kind::function ? Level::base : Level::factor));
  }
  /// Whether x is a differential: dt, \partial\dot q.
  static bool is_differential(const Tree& x) {
    return x.kind() == Kind::product && x->children.size() == 2 && x.child(0).kind() == Kind::letter &&
           (x.child(0)->text == "d" || x.child(0)->text == R"(\partial)") &&
           x.child(1).kind() == Kind::letter;
  }
  std::string power(const std::string& own, const Tree& exponent) override {
    if (exponent.kind() == Kind::marked && !raised(of(exponent.child(0))).empty())
      return without_end(own) + marked(raised(of(exponent.child(0))));
    const std::string base = without_end(own), text = of(exponent), signs = raised(text);
    if (text == "∘") return base + "°";
    if (text == "*") return base + text;
    if (text.find_first_not_of('\'') == std::string::npos) return base + text;
    const bool single = exponent.kind() == Kind::letter || exponent.kind() == Kind::number ||
                        exponent.kind() == Kind::group || exponent.kind() == Kind::words;
    if (!signs.empty()) return base + signs;
    return base + (single ? "^" + text + behind_index : "^(" + text + ")");
  }
  std::string transposed(const std::string& base) override { return base + "^T"; }
  std::string function(const std::string& name, const std::string& exponent, const Tree& x) override {
    const std::string signs = raised(exponent);
    const std::string own = word_gap + sign_in_unicode(name) +
                            (exponent.empty() ? ""
                             : !signs.empty() ? signs
                                              : "^(" + exponent + ")");
    if (!is_plain_argument(x) || x.kind() == Kind::fraction) return own + "(" + of(x) + ")";
    return own + word_gap + of(x);
  }
  std::string root(const Tree& x, const std::string& degree) override {
    const bool bare = x.kind() == Kind::letter || x.kind() == Kind::number || x.kind() == Kind::pi ||
                      x.kind() == Kind::group || x.kind() == Kind::bars;
    return raised(degree) + "√" + (bare ? of(x) : "(" + of(x) + ")");
  }
  std::string bars(const Tree& x, bool twice) override {
    const std::string sign = twice ? "‖" : "|", inside = of(x);
    return sign + (inside.starts_with(word_gap) ? inside.substr(1) : inside) + sign;
  }
  std::string parentheses(const std::string& inside) override { return "(" + inside + ")"; }
  std::string brackets(const std::string& opening, const std::string& inside,
                       const std::string& closing) override {
    return sign_in_unicode(opening) + inside + sign_in_unicode(closing);
  }
  std::string matrix(const std::vector<Parts>& rows, const std::string&) override {
    std::string all;
    for (const Parts& row : rows) {
      all += all.empty() ? "" : "; ";
      for (std::size_t i = 0; i < row.size(); ++i) all += (i == 0 ? "" : " ") + row[i];
    }
    return "(" + all + ")";
  }
  std::string named(const std::string& name, const std::string& inside) override {
    return word_gap + name + "(" + inside + ")";
  }
  std::string sum_over(const std::string& below, const std::string& last, const std::string& body) override {
    return "Σ" + index(letter(below) + (last.empty() ? "" : "≤" + last)) + body;
  }
  std::string integral(const Tree& x) override {
    return "∫" + index(of(x.child(0))) + "^(" + of(x.child(1)) + ")" + of(x.child(2)) + " d" +
           letter(x->text);
  }
  std::string along_curve(const Tree& x) override { return "∫" + of(x.child(0)) + " ds"; }
  std::string time_derivative(const std::string& x) override { return "(d/dt)" + x; }
  std::string indexed(const std::string& base, const std::string& scripts) override {
    return scripts == "!" ? base + scripts : UnicodeName().behind(base, scripts);
  }
  std::string relation(const std::string& command) override {
    if (has_role(command, Role::relation) && command != ":") return " " + sign_in_unicode(command) + " ";
    return command == "*" ? "*" : command == "-" ? "-" : command == ", " ? command : sign_in_unicode(command);
  }
  std::string large(const std::string& command, const Tree& below, const Tree* above) override {
    const std::string sign = command == R"(\sum)"    ? "Σ"
                             : command == R"(\prod)" ? "Π"
                                                     : sign_in_unicode(command);
    std::string all = is_word(sign[0]) && sign.size() > 2 && static_cast<unsigned char>(sign[0]) < 0x80
                          ? word_gap + sign
                          : sign;
    if (below.kind() != Kind::nothing) all += index(tight(of(below)));
    return above ? power(all, *above) : all;
  }
  static std::string without_end(std::string text) {
    if (text.ends_with(behind_index) || text.ends_with(word_gap)) text.pop_back();
    return text;
  }
  static std::string tight(std::string text) {
    std::erase(text, ' ');
    return text;
  }
  std::string words(const std::string& text) override { return word_gap + text + word_gap; }
  std::string marked(const std::string& inside) override { return differs + inside + differs_no_more; }
  bool fraction_is_factor() const override { return false; }
};

bool holds_on_left(const std::string& text) {
  return !text.empty() && (is_word(text.back()) || std::string_view(")]}|'*_").find(text.back()) < 8) &&
         !text.ends_with("·") && !text.ends_with("×") && !text.ends_with("±") && !text.ends_with("√");
}

}  // namespace

std::string unicode(const Tree& x, const Marks& marks) {
  std::string text = Unicode().of(x);
  for (std::size_t at = 0; (at = text.find("\x04\x03", at)) != std::string::npos;) text.erase(at, 2);
  std::string all, seen;  // with the marks, and without
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == differs || c == differs_no_more) {
      all += c == differs ? marks.begin : marks.end;
      continue;
    }
    if (c != word_gap && c != behind_index) {
      if (c == ' ' && seen.ends_with(' ')) continue;
      all += c, seen += c;
      continue;
    }
    const std::size_t next = std::min(text.find_first_not_of("\x01\x02\x03\x04", i), text.size());
    const std::string_view rest = std::string_view(text).substr(next);
    const bool sign = rest.starts_with("·") || rest.starts_with("×") || rest.starts_with("±");
    const bool word = !rest.empty() && is_word(rest[0]) && !sign;
    if (word && holds_on_left(seen)) all += ' ', seen += ' ';
  }
  while (all.ends_with(' ')) all.pop_back();
  return all.starts_with(' ') ? all.substr(1) : all;
}

namespace {

/// Whether a letter and a group form a function's value: W(T), K(m,n).
bool is_value_at(const Tree& letter, const Tree& group) {
  if (letter.kind() != Kind::letter || group.kind() != Kind::group) return false;
  const Tree& inside = group.child(0);
  return inside.kind() == Kind::letter || inside.kind() == Kind::number || inside.kind() == Kind::pi ||
         inside.kind() == Kind::line;
}

Tree grouped(Tree x) { return made(Kind::group, {std::move(x)}, "( )"); }

Tree as_operand(const Tree& x);

/// Groups factors from left to right: a/bc is (a/b)c.
Tree read_product(const Tree& x) {
  std::vector<Tree> factors;
  std::string marks;
  for (std::size_t i = 0; i < x->children.size(); ++i) {
    const Tree& factor = x.child(i);
    const bool is_value = i > 0 && x->marks[i] != '/' && is_value_at(x.child(i - 1), factor);
    if (x->marks[i] == '/' && factors.size() > 1) {
      factors = {grouped(product(factors, marks))};
      marks = "*";
    }
    factors.push_back(is_value ? factor : as_operand(factor));
    marks += x->marks[i];
    const bool goes_on = i + 1 < x->children.size() && x->marks[i + 1] != '/';
    if (x->marks[i] == '/' && goes_on) {
      factors = {grouped(product(factors, marks))};
      marks = "*";
    }
  }
  return product(std::move(factors), std::move(marks));
}

}  // namespace

Tree with_all_brackets(const Tree& x) {
  const bool tuple = x.kind() == Kind::group && x.child(0).kind() == Kind::line;
  if ((x.kind() == Kind::group && !tuple) || x.kind() == Kind::marked) return with_all_brackets(x.child(0));
  if (x.kind() == Kind::product) return read_product(x);
  Tree read = x;
  const bool bare = tuple || x.kind() == Kind::line || x.kind() == Kind::fraction || x.kind() == Kind::root ||
                    x.kind() == Kind::bars || x.kind() == Kind::large || x.kind() == Kind::row ||
                    x.kind() == Kind::matrix;
  for (std::size_t i = 0; i < x->children.size(); ++i) {
    const bool exponent = i > 0 && (x.kind() == Kind::power || x.kind() == Kind::function);
    const bool argument = i == 0 && x.kind() == Kind::function;
    const Tree own = with_all_brackets(x.child(i));
    read = read.with_child(i, bare || exponent ? own : argument ? grouped(own) : as_operand(x.child(i)));
  }
  return read;
}

namespace {

Tree as_operand(const Tree& x) {
  const Tree own = with_all_brackets(x);
  const bool compound = own.kind() == Kind::sum || own.kind() == Kind::product || own.kind() == Kind::dot ||
                        own.kind() == Kind::cross || own.kind() == Kind::fraction || own.kind() == Kind::line;
  return compound ? grouped(own) : own;
}

}  // namespace

}  // namespace oddity::formula
