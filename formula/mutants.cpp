#include "formula/mutants.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "formula/differentiate.hpp"
#include "formula/print.hpp"
#include "formula/unreadable.hpp"

namespace oddity::formula {

namespace {

/// Limits for all mutants together, which bound their memory.
constexpr std::size_t most_nodes = 10'000'000, most = 20'000;

std::size_t nodes_of(const Tree& x) {
  std::size_t nodes = 1;
  for (const Tree& child : x->children) nodes += nodes_of(child);
  return nodes;
}

std::string shown(const std::string& text) { return "$" + text + "$"; }
std::string shown(const Tree& x) { return shown(tex(x)); }

void letters_of(const Tree& x, std::vector<Tree>& all) {
  if (x.kind() == Kind::letter &&
      std::ranges::none_of(all, [&](const Tree& one) { return one->text == x->text; }))
    all.push_back(x);
  const std::size_t n = x.kind() == Kind::time_derivative ? 1 : x->children.size();
  for (std::size_t i = 0; i < n; ++i) letters_of(x.child(i), all);
}

std::vector<std::string> neighbours_of(const std::string& function) {
  if (function == R"(\sin)") return {R"(\cos)", R"(\tan)"};
  if (function == R"(\cos)") return {R"(\sin)"};
  if (function == R"(\tan)") return {R"(\sin)", R"(\arctan)"};
  if (function == R"(\arcsin)") return {R"(\arccos)", R"(\arctan)"};
  if (function == R"(\arccos)") return {R"(\arcsin)"};
  if (function == R"(\arctan)") return {R"(\arcsin)", R"(\tan)"};
  if (function == R"(\sinh)") return {R"(\cosh)", R"(\sin)"};
  if (function == R"(\cosh)") return {R"(\sinh)", R"(\cos)"};
  if (function == R"(\tanh)") return {R"(\sinh)", R"(\tan)"};
  return {};
}

class Mutation {
 public:
  using Rebuild = std::function<Tree(const Tree&)>;

  explicit Mutation(const Tree& whole) : most_(std::min(most, most_nodes / nodes_of(whole))) {
    letters_of(whole, letters_);
  }

  void everywhere(const Tree& x, const Rebuild& rebuild) {
    here(x, rebuild);
    const std::size_t n = x.kind() == Kind::time_derivative ? 1 : x->children.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (x.kind() == Kind::along_curve && i == 1) break;
      everywhere(x.child(i), [&, i](const Tree& child) { return rebuild(with(x, i, child)); });
    }
  }
  std::vector<Mutant> all() && { return std::move(all_); }

 private:
  static Tree with(const Tree& x, std::size_t i, const Tree& child) {
    return x.kind() == Kind::time_derivative ? time_derivative_of(child) : x.with_child(i, child);
  }

  void add(const Rebuild& rebuild, const Tree& changed, std::string change) {
    if (all_.size() >= most_) return;
    try {
      all_.push_back({rebuild(changed), std::move(change)});
    } catch (const NoValue&) {  // the change has no derivative
    }
  }

  void here(const Tree& x, const Rebuild& rebuild) {
    const auto change = [&](const Tree& changed, const std::string& how) { add(rebuild, changed, how); };
    switch (x.kind()) {
      case Kind::number:
        return of_number(x, change);
      case Kind::letter:
        return of_letter(x, change);
      case Kind::sum:
        return of_sum(x, change);
      case Kind::product:
        return of_product(x, change);
      case Kind::fraction:
        change(made(Kind::fraction, {x.child(1), x.child(0)}), shown(x) + " turned over");
        change(product({x.child(0), x.child(1)}, "**"), shown(x) + " as a product");
        change(made(Kind::fraction, {number("1"), x.child(1)}), shown(x.child(0)) + " dropped");
        return change(x.child(0), shown(x.child(1)) + " dropped");
      case Kind::power:
        change(x.child(0), "the exponent of " + shown(x) + " dropped");
        return change(made(Kind::power, {x.child(0), negative(x.child(1))}),
                      "the exponent of " + shown(x) + " negative");
      case Kind::transposed:
        return change(x.child(0), shown(x) + " not transposed");
      case Kind::function:
        for (const std::string& other : neighbours_of(x->text))
          change(made(Kind::function, {x.child(0)}, other), shown(other) + " for " + shown(x->text));
        return change(x.child(0), shown(x->text) + " dropped");
      case Kind::root:
        return change(x.child(0), "the root dropped");
      case Kind::bars:
        return change(x.child(0), "the bars dropped");
      case Kind::cross:
        return change(made(Kind::cross, {x.child(1), x.child(0)}), shown(x) + " the other way about");
      case Kind::largest:
      case Kind::smallest:
        change(made(x.kind() == Kind::largest ? Kind::smallest : Kind::largest, x->children), "max for min");
        change(x.child(0), shown(x) + " without its second");
        return change(x.child(1), shown(x) + " without its first");
      case Kind::tuple:
        for (std::size_t i = 0; i + 1 < x->children.size(); ++i)
          change(x.with_child(i, x.child(i + 1)).with_child(i + 1, x.child(i)), "components exchanged");
        return;
      default:
        return;
    }
  }

  template <class Change>
  static void of_number(const Tree& x, const Change& change) {
    const std::string& digits = x->text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
      if (digits[i] == 'e' || digits[i] == 'E') return;
      if (digits[i] == '.') continue;
      for (const int by : {1, -1}) {
        std::string other = digits;
        if (other == "9" && by == 1)
          other = "10";
        else
          other[i] = static_cast<char>('0' + (other[i] - '0' + 10 + by) % 10);
        if (digits == "0" && by == -1) continue;
        change(number(other), other + " for " + digits);
      }
    }
  }

  template <class Change>
  void of_letter(const Tree& x, const Change& change) {
    for (const Tree& other : letters_)
      if (other->text != x->text && std::ranges::is_permutation(other->slots, x->slots))
        change(other, shown(other) + " for " + shown(x));
    if (x->slots.size() == 2) {
      Node node = *x;
      std::swap(node.slots[0], node.slots[1]);
      change(Tree(std::move(node)), "the indices of " + shown(x) + " exchanged");
    }
  }

  template <class Change>
  static void of_sum(const Tree& x, const Change& change) {
    for (std::size_t i = 0; i < x->children.size(); ++i) {
      const std::string term = shown(x.child(i));
      std::string marks = x->marks;
      marks[i] = marks[i] == '+' ? '-' : marks[i] == '-' ? '+' : marks[i] == 'p' ? 'm' : 'p';
      change(with_terms(x, x->children, marks), "the sign of " + term);
      if (x->children.size() > 1) {
        std::vector<Tree> others = x->children;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        std::string left = x->marks;
        left.erase(i, 1);
        change(with_terms(x, others, left), term + " dropped");
        change(x.with_child(i, product({number("2"), x.child(i)}, "**")), term + " doubled");
        change(x.with_child(i, product({x.child(i), number("2")}, "*/")), term + " halved");
      }
    }
  }

  template <class Change>
  static void of_product(const Tree& x, const Change& change) {
    for (std::size_t i = 0; i < x->children.size(); ++i) {
      const std::string factor = shown(x.child(i));
      std::vector<Tree> others = x->children;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      std::string left = x->marks;
      left.erase(i, 1);
      if (left[0] == '/') {
        others.insert(others.begin(), number("1"));
        left.insert(left.begin(), '*');
      }
      change(product(others, left), factor + " dropped");
      Node node = *x;
      node.marks[i] = node.marks[i] == '*' ? '/' : '*';
      change(Tree(std::move(node)), factor + (x->marks[i] == '*' ? " as a divisor" : " as a factor"));
    }
  }

  std::size_t most_;
  std::vector<Tree> letters_;
  std::vector<Mutant> all_;
};

}  // namespace

std::vector<Mutant> mutants(const Tree& x) {
  Mutation mutation(x);
  mutation.everywhere(x, [](const Tree& whole) { return whole; });
  std::vector<Mutant> all = std::move(mutation).all();
  if (x.kind() != Kind::sum) all.push_back({negative(x), "the sign of all"});
  all.push_back({product({number("2"), x}, "**"), "all doubled"});
  all.push_back({product({x, number("2")}, "*/"), "all halved"});
  return all;
}

}  // namespace oddity::formula
