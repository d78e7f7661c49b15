#include "formula/print.hpp"
#include "formula/signs.hpp"
#include "formula/tokens.hpp"
#include "formula/writer.hpp"

namespace oddity::formula {

namespace {

class Plain : public Writer {
  std::string number(const std::string& digits) override { return digits; }
  std::string letter(const std::string& name) override { return plain_name(name); }
  std::string sign(const std::string& name, bool) override {
    if (name == "comma") return ", ";
    if (name == "semicolon") return "; ";
    if (name == "pi") return "pi";
    if (name == "dot") return " . ";
    if (name == "cross") return " x ";
    return name == "-" || name == "+" ? " " + name + " "
                                      : " " + (name == "pm" ? std::string("+-") : "-+") + " ";
  }
  std::string side_by_side(const std::string& left, const std::string& right) override {
    return left + " " + right;
  }
  std::string bar(const std::string& left, const std::string& right) override { return left + "/" + right; }
  std::string fraction(const Tree& above, const Tree& below) override {
    return written(above, Level::factor) + "/" + written(below, Level::factor);
  }
  std::string power(const std::string& base, const Tree& exponent) override {
    return base + "^" + written(exponent, Level::base);
  }
  std::string transposed(const std::string& base) override { return base + "^T"; }
  std::string function(const std::string& name, const std::string& exponent, const Tree& x) override {
    std::string own = name == R"(\ln)" ? "log" : name.substr(1);
    if (own.starts_with("arc")) own.erase(1, 2);
    if (own.starts_with("ar") && own.ends_with('h')) own.erase(1, 1);
    if (x.kind() == Kind::nothing) return own;
    const std::string all = x.kind() == Kind::group ? own + of(x) : own + "(" + of(x) + ")";
    const bool single = exponent.find_first_not_of("0123456789") == std::string::npos;
    return exponent.empty() ? all : all + "^" + (single ? exponent : "(" + exponent + ")");
  }
  std::string root(const Tree& x, const std::string& degree) override {
    return degree.empty() ? "sqrt(" + of(x) + ")" : "(" + of(x) + ")^(1/" + degree + ")";
  }
  std::string bars(const Tree& x, bool) override { return "abs(" + of(x) + ")"; }
  std::string parentheses(const std::string& inside) override { return "(" + trimmed(inside) + ")"; }
  std::string matrix(const std::vector<Parts>& rows, const std::string&) override {
    std::string all;
    for (const Parts& row : rows) {
      all += all.empty() ? "" : "; ";
      for (std::size_t i = 0; i < row.size(); ++i) all += (i == 0 ? "" : ", ") + row[i];
    }
    return "(" + all + ")";
  }
  std::string named(const std::string& name, const std::string& inside) override {
    return name + "(" + inside + ")";
  }
  std::string sum_over(const std::string& index, const std::string& last, const std::string& body) override {
    return "sum_" + plain_name(index) + (last.empty() ? "" : "<=" + last) + " " + body;
  }
  std::string integral(const Tree& x) override {
    return "integral(" + of(x.child(2)) + ", " + plain_name(x->text) + ", " + of(x.child(0)) + ", " +
           of(x.child(1)) + ")";
  }
  std::string along_curve(const Tree& x) override { return "integral(" + of(x.child(0)) + ", s)"; }
  std::string time_derivative(const std::string& x) override { return "d/dt " + x; }
  std::string brackets(const std::string& opening, const std::string& inside,
                       const std::string& closing) override {
    return shown(opening) + trimmed(inside) + shown(closing);
  }
  std::string indexed(const std::string& base, const std::string& scripts) override {
    return base + (scripts == "!" ? scripts : plain_name(scripts));
  }
  std::string relation(const std::string& command) override {
    if (command.starts_with(R"(\le)")) return " <= ";
    if (command.starts_with(R"(\ge)")) return " >= ";
    if (command.starts_with(R"(\ne)")) return " != ";
    const bool comma = command.starts_with(",") || command == ";";
    return (comma ? "" : " ") + shown(comma ? command.substr(0, 1) : command) + " ";
  }
  std::string large(const std::string& command, const Tree& below, const Tree* above) override {
    std::string all = command == R"(\int)" ? "integral" : command.substr(1);
    if (below.kind() != Kind::nothing) all += "_(" + of(below) + ")";
    if (above) all += "^" + written(*above, Level::base);
    return all;
  }
  std::string words(const std::string& text) override { return text; }
  static std::string shown(const std::string& command) {
    const Sign* sign = sign_of(command);
    return sign ? std::string(sign->shown) : command;
  }
  bool fraction_is_factor() const override { return false; }

 public:
  /// Removes the spaces around a sign that begins a sum.
  static std::string trimmed(std::string text) {
    if (text.starts_with(" - ")) text = "-" + text.substr(3);
    return text;
  }
};

}  // namespace

std::string plain(const Tree& x) {
  std::string text = Plain().of(x);
  // Signs after a bracket or a comma begin a sum as well.
  for (const char* const before : {"( - ", ", - ", "; - "})
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1))
      text.replace(at, 4, std::string(before).substr(0, before[0] == '(' ? 1 : 2) + "-");
  return Plain::trimmed(text);
}

}  // namespace oddity::formula
