#include "report/pages/readable.hpp"

#include <cctype>
#include <map>
#include <string_view>

namespace oddity {

namespace {

using Signs = std::map<std::string_view, std::string_view>;

const Signs& signs() {
  static const Signs all{
      {"alpha", "α"},  {"beta", "β"},    {"gamma", "γ"},   {"delta", "δ"}, {"epsilon", "ε"},  {"theta", "θ"},
      {"lambda", "λ"}, {"mu", "µ"},      {"xi", "ξ"},      {"pi", "π"},    {"rho", "ρ"},      {"sigma", "σ"},
      {"phi", "φ"},    {"varphi", "φ"},  {"psi", "ψ"},     {"omega", "ω"}, {"Delta", "Δ"},    {"ell", "ℓ"},
      {"imath", "i"},  {"jmath", "j"},   {"partial", "∂"}, {"nabla", "∇"}, {"cdot", "·"},     {"times", "×"},
      {"pm", "±"},     {"mp", "∓"},      {"ge", "≥"},      {"le", "≤"},    {"ne", "≠"},       {"approx", "≈"},
      {"circ", "°"},   {"ldots", "..."}, {"dots", "..."},  {"sum", "∑"},   {"int", "∫"},      {"to", "→"},
      {"left", ""},    {"right", ""},    {"mathbf", ""},   {"mathrm", ""}, {"boldsymbol", ""}};
  return all;
}

const Signs& raised() {
  static const Signs all{{"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"}, {"5", "⁵"}, {"6", "⁶"},
                         {"7", "⁷"}, {"8", "⁸"}, {"9", "⁹"}, {"-", "⁻"}, {"+", "⁺"}, {"T", "ᵀ"}, {"n", "ⁿ"}};
  return all;
}

const Signs& lowered() {
  static const Signs all{{"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"},
                         {"5", "₅"}, {"6", "₆"}, {"7", "₇"}, {"8", "₈"}, {"9", "₉"},
                         {"i", "ᵢ"}, {"j", "ⱼ"}, {"k", "ₖ"}, {"n", "ₙ"}, {"x", "ₓ"}};
  return all;
}

/// Each letter by its sign, if all have one; else marked, in parentheses where there are several.
std::string set(const std::string& text, const Signs& as, char mark) {
  std::string all;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto sign = as.find(std::string_view(text).substr(i, 1));
    if (sign == as.end()) return mark + (text.size() > 1 ? "(" + text + ")" : text);
    all += sign->second;
  }
  return all;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// One thing that needs no parentheses: a number, a letter, a function of something.
bool is_single(const std::string& text) {
  return text.find_first_of("+-=/ *", 1) == std::string::npos && text.find("·") == std::string::npos;
}

std::string grouped(const std::string& text) { return is_single(text) ? text : "(" + text + ")"; }

/// A formula in TeX, read from left to right.
class Formula {
 public:
  explicit Formula(std::string_view tex) : left_(tex) {}

  std::string all() {
    std::string text;
    while (!left_.empty()) text += next();
    return text;
  }

 private:
  char take() {
    const char c = left_.front();
    left_.remove_prefix(1);
    return c;
  }

  /// What stands in braces, or the next thing alone.
  std::string argument() {
    while (left_.starts_with(' ')) take();
    return left_.empty() ? "" : next();
  }

  std::string next() {
    const char c = take();
    if (c == '\\') return command();
    if (c == '{') return braces();
    if (c == '^') return power();
    if (c == '_') return set(argument(), lowered(), '_');
    if (c == '&' || c == '~') return " ";
    return std::string(1, c);
  }

  std::string power() {
    const std::string exponent = argument();
    return exponent == "°" || exponent == "'" ? exponent : set(exponent, raised(), '^');
  }

  std::string braces() {
    std::size_t depth = 1, size = 0;
    for (; size < left_.size(); ++size) {
      depth += left_[size] == '{';
      depth -= left_[size] == '}';
      if (depth == 0) break;
    }
    const std::string inside = Formula(left_.substr(0, size)).all();
    left_.remove_prefix(std::min(size + 1, left_.size()));
    return inside;
  }

  std::string command() {
    std::size_t size = 0;
    while (size < left_.size() && is_letter(left_[size])) ++size;
    if (size == 0) return left_.empty() ? "" : spacing(take());
    const std::string_view name = left_.substr(0, size);
    left_.remove_prefix(size);
    if (name == "dot") return argument() + "'";
    if (name == "ddot") return argument() + "''";
    if (name == "bar") return argument() + "\u0304";
    if (name == "sqrt") return "√" + grouped(argument());
    if (name == "frac" || name == "tfrac") {
      const std::string above = argument();
      return grouped(above) + "/" + grouped(argument());
    }
    if (name == "begin" || name == "end") return argument(), "";
    const auto sign = signs().find(name);
    if (left_.starts_with(' ')) take();  // which ends the name
    if (sign != signs().end()) return std::string(sign->second);
    const bool applied =
        left_.empty() || std::string_view("(^_,)").find(left_.front()) != std::string_view::npos;
    return std::string(name) + (applied ? "" : " ");  // "sin x", "sin(x)"
  }

  static std::string spacing(char c) {
    if (c == '!') return "";
    return std::string_view(", ;\\").find(c) != std::string_view::npos ? " " : std::string(1, c);
  }

  std::string_view left_;
};

}  // namespace

std::string readable(const std::string& text) {
  std::string all;
  for (std::size_t at = 0; at < text.size();) {
    const char mark = text[at];
    const std::size_t end = mark == '$' || mark == '`' ? text.find(mark, at + 1) : std::string::npos;
    if (end == std::string::npos) {
      all += text[at++];
      continue;
    }
    const std::string_view inside = std::string_view(text).substr(at + 1, end - at - 1);
    all += mark == '$' ? Formula(inside).all() : std::string(inside);
    at = end + 1;
  }
  return all;
}

}  // namespace oddity
