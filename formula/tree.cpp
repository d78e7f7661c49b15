#include "formula/tree.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace oddity::formula {

namespace {

constexpr std::pair<std::string_view, std::string_view> inverses[]{
    {R"(\sin)", R"(\arcsin)"},  {R"(\cos)", R"(\arccos)"},  {R"(\tan)", R"(\arctan)"},
    {R"(\arcsin)", R"(\sin)"},  {R"(\arccos)", R"(\cos)"},  {R"(\arctan)", R"(\tan)"},
    {R"(\sinh)", R"(\arsinh)"}, {R"(\cosh)", R"(\arcosh)"}, {R"(\tanh)", R"(\artanh)"},
    {R"(\arsinh)", R"(\sinh)"}, {R"(\arcosh)", R"(\cosh)"}, {R"(\artanh)", R"(\tanh)"},
    {R"(\exp)", R"(\ln)"},      {R"(\ln)", R"(\exp)"}};

const std::pair<std::string_view, std::string_view>* found(std::string_view function) {
  const auto* one =
      std::ranges::find(inverses, function, &std::pair<std::string_view, std::string_view>::first);
  return one == std::end(inverses) ? nullptr : one;
}

}  // namespace

Tree::Tree(Node node) : node_(std::make_shared<const Node>(std::move(node))) {}

Tree Tree::with_child(std::size_t i, Tree child) const {
  Node changed = *node_;
  changed.children.at(i) = std::move(child);
  return Tree(std::move(changed));
}

Tree number(std::string digits) { return Tree({.kind = Kind::number, .text = std::move(digits)}); }
Tree number(int x) { return x < 0 ? negative(number(std::to_string(-x))) : number(std::to_string(x)); }

Tree sum(std::vector<Tree> terms, std::string marks) {
  if (terms.empty()) return number("0");
  if (terms.size() == 1 && marks == "+") return terms[0];
  return Tree({.kind = Kind::sum, .children = std::move(terms), .marks = std::move(marks)});
}

Tree with_terms(const Tree& whole, std::vector<Tree> terms, std::string marks) {
  if (marks.find_first_of("pm") == std::string::npos) return sum(std::move(terms), std::move(marks));
  Node node = *whole;
  node.children = std::move(terms);
  node.marks = std::move(marks);
  return Tree(std::move(node));
}

Tree product(std::vector<Tree> factors, std::string marks) {
  if (factors.empty()) return number("1");
  if (factors.size() == 1 && marks == "*") return factors[0];
  return Tree({.kind = Kind::product, .children = std::move(factors), .marks = std::move(marks)});
}

Tree made(Kind kind, std::vector<Tree> children, std::string text) {
  return Tree({.kind = kind, .text = std::move(text), .children = std::move(children)});
}

Tree negative(const Tree& x) { return sum({x}, "-"); }

bool is_number(const Tree& x, std::string_view digits) {
  return x.kind() == Kind::number && x->text == digits;
}

bool is_whole(const Tree& x, int& value) {
  if (x.kind() == Kind::sum && x->marks == "-") {
    const bool is = is_whole(x.child(0), value);
    value = -value;
    return is;
  }
  const char* const end = x->text.data() + x->text.size();
  return x.kind() == Kind::number && x->text.size() <= 4 &&
         std::from_chars(x->text.data(), end, value).ptr == end;
}

std::string_view inverse_of(std::string_view function) {
  const auto* one = found(function);
  return one ? one->second : "";
}
bool is_function(std::string_view function) { return found(function) != nullptr; }

std::string rate_name(std::string_view letter) {
  if (letter.starts_with(R"(\dot)") && letter.size() > 4 && (letter[4] == ' ' || letter[4] == '\\'))
    return R"(\ddot)" + std::string(letter.substr(4));
  if (letter.ends_with('\'')) return std::string(letter) + "'";
  return (letter.starts_with('\\') ? R"(\dot)" : R"(\dot )") + std::string(letter);
}

}  // namespace oddity::formula
