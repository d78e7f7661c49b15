#include "formula/print.hpp"
#include "formula/tokens.hpp"
#include "formula/writer.hpp"

namespace oddity::formula {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Whether a text ends with a command, which a following letter would extend.
bool ends_in_command(const std::string& text) {
  std::size_t n = text.size();
  while (n > 0 && is_letter(text[n - 1])) --n;
  return n < text.size() && n > 0 && text[n - 1] == '\\';
}

class Tex : public Writer {
  std::string number(const std::string& digits) override {
    const std::size_t e = digits.find_first_of("eE");
    if (e == std::string::npos) return digits;
    return "(" + digits.substr(0, e) + R"(\cdot10^{)" + digits.substr(digits[e + 1] == '+' ? e + 2 : e + 1) +
           "})";
  }
  std::string letter(const std::string& name) override { return name; }
  std::string sign(const std::string& name, bool) override {
    if (name == "semicolon") return R"(;\ )";
    if (name == "comma") return ",";
    return name.size() > 1 ? "\\" + (name == "dot" ? "cdot" : name == "cross" ? "times" : name) + " " : name;
  }
  std::string side_by_side(const std::string& left, const std::string& right) override {
    if (is_digit(right[0]) && is_digit(left.back())) return left + "(" + right + ")";
    const bool command = ends_in_command(left) && (is_letter(right[0]) || is_digit(right[0]));
    return left + (command ? " " : "") + right;
  }
  std::string bar(const std::string& left, const std::string& right) override { return left + "/" + right; }
  std::string fraction(const Tree& above, const Tree& below) override {
    return R"(\frac{)" + of(above) + "}{" + of(below) + "}";
  }
  std::string power(const std::string& base, const Tree& exponent) override {
    return base + "^{" + of(exponent) + "}";
  }
  std::string transposed(const std::string& base) override { return base + "^T"; }
  std::string function(const std::string& name, const std::string& exponent, const Tree& x) override {
    const std::string own = name + (exponent.empty() ? "" : "^{" + exponent + "}");
    if (x.kind() == Kind::group || x.kind() == Kind::nothing) return own + of(x);
    return own + "(" + of(x) + ")";
  }
  std::string root(const Tree& x, const std::string& degree) override {
    return R"(\sqrt)" + (degree.empty() ? "" : "[" + degree + "]") + "{" + of(x) + "}";
  }
  std::string bars(const Tree& x, bool twice) override {
    const std::string inside = of(x);
    if (twice) return R"(\|)" + inside + R"(\|)";
    return inside.find('|') == std::string::npos ? "|" + inside + "|" : "|(" + inside + ")|";
  }
  std::string parentheses(const std::string& inside) override { return "(" + inside + ")"; }
  std::string matrix(const std::vector<Parts>& rows, const std::string& environment) override {
    std::string all;
    for (const Parts& row : rows) {
      all += all.empty() ? "" : R"(\\)";
      for (std::size_t i = 0; i < row.size(); ++i) all += (i == 0 ? "" : "&") + row[i];
    }
    const std::string name = environment.empty() ? "pmatrix" : environment;
    return R"(\begin{)" + name + "}" + all + R"(\end{)" + name + "}";
  }
  std::string named(const std::string& name, const std::string& inside) override {
    return (name[0] == 'm' ? "\\" + name : R"(\mathrm{)" + name + "}") + "(" + inside + ")";
  }
  std::string sum_over(const std::string& index, const std::string& last, const std::string& body) override {
    const std::string below = last.empty() ? index : "{" + index + R"(\le )" + last + "}";
    return R"(\sum_)" + below + (is_letter(body[0]) || ends_in_command(index) ? " " : "") + body;
  }
  std::string integral(const Tree& x) override {
    return R"(\int_{)" + of(x.child(0)) + "}^{" + of(x.child(1)) + "}" + of(x.child(2)) + R"(\,d)" + x->text;
  }
  std::string along_curve(const Tree& x) override { return R"(\int )" + of(x.child(0)) + R"(\,ds)"; }
  std::string time_derivative(const std::string& x) override { return R"(\frac{d}{dt})" + x; }
  std::string apart(const std::string& left, const std::string& right) override {
    return left + R"(\,)" + right;
  }
  std::string brackets(const std::string& opening, const std::string& inside,
                       const std::string& closing) override {
    return opening + (is_letter(opening.back()) ? " " : "") + inside + closing;
  }
  std::string indexed(const std::string& base, const std::string& scripts) override { return base + scripts; }
  std::string relation(const std::string& command) override {
    return command + (is_letter(command.back()) ? " " : command == ", " ? R"(\ )" : "");
  }
  std::string large(const std::string& command, const Tree& below, const Tree* above) override {
    std::string all = command;
    if (below.kind() != Kind::nothing) all += "_{" + of(below) + "}";
    if (above) all += "^{" + of(*above) + "}";
    return all;
  }
  std::string words(const std::string& text) override { return R"(\text{)" + text + "}"; }
  std::string upright(const Tree& x) override { return R"(\mathrm{)" + of(x) + "}"; }
  bool fraction_is_factor() const override { return true; }
};

}  // namespace

std::string tex(const Tree& x) { return Tex().of(x); }

}  // namespace oddity::formula
