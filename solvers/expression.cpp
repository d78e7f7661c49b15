#include "solvers/expression.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace oddity {

Expression::Expression(std::string what, std::vector<Expression> of)
    : node_(std::make_shared<const Node>(std::move(what), std::move(of))) {}

Expression Expression::letter(const std::string& name) { return {name, {}}; }
Expression Expression::pi() { return {"PI", {}}; }
Expression Expression::whole(const std::string& digits) { return {digits, {}}; }

Expression Expression::exact(double value) {
  constexpr double places = 1024, largest = 0x1p40;
  if (value < 0) return Expression(0) - exact(-value);
  const double scaled = value * places;
  if (!(scaled <= largest) || scaled != std::floor(scaled))
    throw std::logic_error("the double " + std::to_string(value) +
                           " has more than 10 binary places or 30 before them: say what it stands for, as by "
                           "Expression::pi() or Expression::decimal()");
  if (value == std::floor(value)) return whole(std::to_string(static_cast<long long>(value)));
  return whole(std::to_string(static_cast<long long>(scaled))) / whole("1024");
}

Expression Expression::decimal(const std::string& written) {
  const std::size_t point = std::min(written.find('.'), written.size()),
                    places = written.size() - std::min(point + 1, written.size());
  std::string digits = written;
  if (point < written.size()) digits.erase(point, 1);
  const bool good = !digits.empty() && digits.size() <= 15 &&
                    std::ranges::all_of(digits, [](char c) { return '0' <= c && c <= '9'; });
  if (!good) throw std::logic_error("'" + written + "' is no decimal of at most 15 digits");
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return places == 0 ? whole(digits) : whole(digits) / whole("1" + std::string(places, '0'));
}

std::size_t Expression::depth() const {
  std::size_t deepest = 0;
  for (const Expression& part : node_->of) deepest = std::max(deepest, part.depth());
  return deepest + 1;
}

void Expression::require_no_integral() const {
  if (node_->what == "integral") throw std::logic_error("an integral within another cannot be recorded");
  for (const Expression& part : node_->of) part.require_no_integral();
}

std::string Expression::infix(std::string (Expression::*text)() const) const {
  return "(" + (node_->of[0].*text)() + " " + node_->what + " " + (node_->of[1].*text)() + ")";
}

std::string Expression::coq() const {
  const auto& of = node_->of;
  if (of.empty()) return node_->what;
  if (is_infix()) return infix(&Expression::coq);
  if (node_->what == "integral")
    return "(RInt (fun " + of[0].coq() + " : R => " + of[1].coq() + ") " + of[2].coq() + " " + of[3].coq() +
           ")";
  if (node_->what == "cbrt") return "(exp (ln " + of[0].coq() + " / 3))";  // of what is positive
  const std::string name = node_->what == "abs" ? "Rabs" : node_->what == "log" ? "ln" : node_->what;
  return "(" + name + " " + of[0].coq() + ")";
}

std::string Expression::pari() const {
  const auto& of = node_->of;
  if (of.empty()) return node_->what == "PI" ? "Pi" : node_->what;
  if (is_infix()) return infix(&Expression::pari);
  if (node_->what == "integral")
    return "intnum(" + of[0].pari() + " = " + of[2].pari() + ", " + of[3].pari() + ", " + of[1].pari() + ")";
  if (node_->what == "cbrt") return "sqrtn(" + of[0].pari() + ", 3)";
  return node_->what + "(" + of[0].pari() + ")";
}

}  // namespace oddity
