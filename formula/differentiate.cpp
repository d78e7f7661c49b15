#include "formula/differentiate.hpp"

#include <algorithm>
#include <utility>

namespace oddity::formula {

namespace {

constexpr std::size_t largest_derivative = 200'000;

using Maybe = std::optional<Tree>;

Tree times(const Tree& a, const Tree& b) {
  if (is_number(a, "1")) return b;
  if (is_number(b, "1")) return a;
  return product({a, b}, "**");
}
Tree square(const Tree& x) { return made(Kind::power, {x, number("2")}); }
Tree applied(std::string name, const Tree& x) { return made(Kind::function, {x}, std::move(name)); }
Tree one_plus(const Tree& x, char sign) { return sum({number("1"), x}, std::string("+") + sign); }
Tree over(const Tree& a, const Tree& b) { return made(Kind::fraction, {a, b}); }

/// Derivative of a function at x.
Tree slope_of(const std::string& name, const Tree& x) {
  if (name == R"(\sin)") return applied(R"(\cos)", x);
  if (name == R"(\cos)") return negative(applied(R"(\sin)", x));
  if (name == R"(\tan)") return one_plus(square(applied(R"(\tan)", x)), '+');
  if (name == R"(\sinh)") return applied(R"(\cosh)", x);
  if (name == R"(\cosh)") return applied(R"(\sinh)", x);
  if (name == R"(\tanh)") return one_plus(square(applied(R"(\tanh)", x)), '-');
  if (name == R"(\exp)") return applied(R"(\exp)", x);
  if (name == R"(\ln)") return over(number("1"), x);
  if (name == R"(\arctan)") return over(number("1"), one_plus(square(x), '+'));
  if (name == R"(\artanh)") return over(number("1"), one_plus(square(x), '-'));
  const Tree root = made(Kind::root, {name == R"(\arsinh)"   ? one_plus(square(x), '+')
                                      : name == R"(\arcosh)" ? sum({square(x), number("1")}, "+-")
                                                             : one_plus(square(x), '-')});
  return name == R"(\arccos)" ? negative(over(number("1"), root)) : over(number("1"), root);
}

/// Derivatives of a tree. No tree means zero.
class Derivative {
 public:
  explicit Derivative(const Slope& slope) : slope_(slope) {}

  Maybe of(const Tree& x) {
    if (++made_ > largest_derivative) throw NoValue("the derivative is too long");
    switch (x.kind()) {
      case Kind::number:
      case Kind::pi:
      case Kind::variable:
      case Kind::index:
      case Kind::permutation_sign:
        return std::nullopt;
      case Kind::letter:
        return slope_(x);
      case Kind::sum:
        return of_sum(x);
      case Kind::product:
        return of_product(x);
      case Kind::dot:
      case Kind::cross:
        return of_pair(x);
      case Kind::fraction:
        return of_product(product({x.child(0), x.child(1)}, "*/"));
      case Kind::power:
        return of_power(x);
      case Kind::transposed:
        if (x->children.size() > 1) throw NoValue("no derivative of a power or a transposed matrix");
        return componentwise(x);
      case Kind::function:
        if (const Maybe inner = of(x.child(0))) return times(slope_of(x->text, x.child(0)), *inner);
        return std::nullopt;
      case Kind::root:
        if (const Maybe inner = of(x.child(0))) return over(*inner, product({number("2"), x}, "**"));
        return std::nullopt;
      case Kind::bars:
        if (const Maybe inner = of(x.child(0))) return over(made(Kind::dot, {x.child(0), *inner}), x);
        return std::nullopt;
      case Kind::integral:
        if (of(x.child(0)) || of(x.child(1)))
          throw NoValue("no derivative of an integral whose bounds change");
        return of_last(x, 2);
      case Kind::along_curve:
        return of_last(x, 0);
      case Kind::sum_over:
      case Kind::permutations:
        return of_last(x, 0);
      case Kind::time_derivative:
        if (const Maybe twice = of(x.child(1))) return twice;
        return std::nullopt;
      case Kind::largest:
      case Kind::smallest:
        throw NoValue("no derivative of a maximum or a minimum");
      default:
        return componentwise(x);
    }
  }

 private:
  Maybe of_sum(const Tree& x) {
    std::vector<Tree> terms;
    std::string marks;
    for (std::size_t i = 0; i < x->children.size(); ++i)
      if (const Maybe term = of(x.child(i))) {
        terms.push_back(*term);
        marks += x->marks[i];
      }
    if (terms.empty()) return std::nullopt;
    return with_terms(x, std::move(terms), std::move(marks));
  }
  Maybe of_product(const Tree& x) {
    std::vector<Tree> terms;
    std::string marks;
    for (std::size_t i = 0; i < x->children.size(); ++i) {
      const Maybe slope = of(x.child(i));
      if (!slope) continue;
      std::vector<Tree> factors = x->children;
      std::string own = x->marks;
      const bool below = own[i] == '/';
      if (below) {
        factors.insert(factors.end(), {x.child(i), *slope});
        own += "/*";
      } else {
        factors[i] = *slope;
      }
      terms.push_back(product(std::move(factors), std::move(own)));
      marks += below ? '-' : '+';
    }
    if (terms.empty()) return std::nullopt;
    return sum(std::move(terms), std::move(marks));
  }
  Maybe of_pair(const Tree& x) {
    std::vector<Tree> terms;
    for (std::size_t i = 0; i < 2; ++i)
      if (const Maybe slope = of(x.child(i))) terms.push_back(x.with_child(i, *slope));
    if (terms.empty()) return std::nullopt;
    const std::string marks(terms.size(), '+');
    return sum(std::move(terms), marks);
  }
  Maybe of_power(const Tree& x) {
    const Tree &base = x.child(0), &exponent = x.child(1);
    std::vector<Tree> terms;
    if (const Maybe slope = of(base)) {
      int n = 0;
      const Tree less = is_whole(exponent, n) ? number(n - 1) : sum({exponent, number("1")}, "+-");
      const Tree power = is_number(less, "1") ? base : made(Kind::power, {base, less});
      terms.push_back(product({exponent, power, *slope}, "***"));
    }
    if (const Maybe slope = of(exponent))
      terms.push_back(product({x, applied(R"(\ln)", base), *slope}, "***"));
    if (terms.empty()) return std::nullopt;
    const std::string marks(terms.size(), '+');
    return sum(std::move(terms), marks);
  }
  Maybe of_last(const Tree& x, std::size_t i) {
    if (const Maybe slope = of(x.child(i))) return x.with_child(i, *slope);
    return std::nullopt;
  }
  /// A component with zero derivative becomes zero in its own shape.
  Maybe componentwise(const Tree& x) {
    std::vector<Tree> all;
    bool changes = false;
    for (const Tree& child : x->children) {
      const Maybe slope = of(child);
      changes = changes || slope;
      all.push_back(slope ? *slope : product({number("0"), child}, "**"));
    }
    if (!changes) return std::nullopt;
    Node node = *x;
    node.children = std::move(all);
    return Tree(std::move(node));
  }

  const Slope& slope_;
  std::size_t made_ = 0;
};

}  // namespace

Tree differentiate(const Tree& x, const Slope& slope) {
  return Derivative(slope).of(x).value_or(product({number("0"), x}, "**"));
}

Tree differentiate(const Tree& x, const std::string& letter) {
  return differentiate(x, [&](const Tree& one) -> Maybe {
    if (one->text == letter && one->order == 0) return number("1");
    return std::nullopt;
  });
}

Tree time_derivative_of(const Tree& x) {
  const auto rate = [](const Tree& letter) -> Maybe {
    const bool has_one = std::ranges::any_of(
        letter->entries, [&](const Entry& entry) { return letter->order + 1 < entry.rates.size(); });
    if (!has_one) return std::nullopt;
    Node node = *letter;
    node.text = rate_name(node.text);
    ++node.order;
    return Tree(std::move(node));
  };
  return made(Kind::time_derivative, {x, differentiate(x, rate)});
}

Tree substitute(const Tree& x, const std::function<Maybe(const Tree& letter)>& other) {
  if (x.kind() == Kind::letter) return other(x).value_or(x);
  if (x.kind() == Kind::time_derivative) return time_derivative_of(substitute(x.child(0), other));
  if (x->children.empty()) return x;
  Node node = *x;
  for (Tree& child : node.children) child = substitute(child, other);
  return Tree(std::move(node));
}

}  // namespace oddity::formula
