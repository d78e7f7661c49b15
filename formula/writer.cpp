#include "formula/writer.hpp"

#include <algorithm>
#include <utility>

namespace oddity::formula {

Writer::Level Writer::level_of(const Tree& x) const {
  switch (x.kind()) {
    case Kind::sum:
      return Level::sum;
    case Kind::dot:
    case Kind::permutations:
    case Kind::along_curve:
    case Kind::integral:
      return Level::sum;
    case Kind::cross:
      return Level::cross;
    case Kind::product:
    case Kind::sum_over:
    case Kind::time_derivative:
      return Level::product;
    case Kind::fraction:
      return fraction_is_factor() ? Level::factor : Level::product;
    case Kind::power:
    case Kind::transposed:
    case Kind::function:
      return Level::factor;
    case Kind::components:
    case Kind::marked:
      return level_of(x.child(0));
    case Kind::line:
      return Level::sum;
    case Kind::letter:
      return x->text.find('/') == std::string::npos ? Level::base : Level::product;
    default:
      return Level::base;
  }
}

std::string Writer::written(const Tree& x, Level place) {
  return level_of(x) < place ? parentheses(bare(x)) : bare(x);
}

bool Writer::is_plain_argument(const Tree& x) {
  const auto simple = [](const Tree& part) {
    const Tree& own = part.kind() == Kind::power || part.kind() == Kind::marked ? part.child(0) : part;
    return own.kind() == Kind::number || own.kind() == Kind::letter || own.kind() == Kind::pi ||
           own.kind() == Kind::variable || own.kind() == Kind::indexed;
  };
  if (x.kind() == Kind::product)
    return x->marks.find('/') == std::string::npos && std::ranges::all_of(x->children, simple);
  return simple(x) || x.kind() == Kind::group || x.kind() == Kind::fraction || x.kind() == Kind::root ||
         x.kind() == Kind::bars || x.kind() == Kind::nothing;
}

std::string Writer::sign_of_term(const Tree& sum, std::size_t i) {
  const char mark = sum->marks[i];
  if (i == 0 && mark == '+') return "";
  const std::string own = sign(mark == 'p' ? "pm" : mark == 'm' ? "mp" : std::string(1, mark), i == 0);
  return sum.child(i).kind() == Kind::marked && sum.child(i)->text == "sign" ? marked(own) : own;
}
std::string Writer::term(const Tree& x) {
  const bool may_be_bare = x.kind() != Kind::sum && x.kind() != Kind::permutations;
  return may_be_bare ? bare(x) : parentheses(bare(x));
}

std::string Writer::sum(const Tree& x) {
  std::string all;
  for (std::size_t i = 0; i < x->children.size(); ++i) all += sign_of_term(x, i) + term(x.child(i));
  return all;
}

/// A sum over an index takes everything that follows it, as does a function.
std::string Writer::product(const Tree& x) {
  std::string all;
  const std::size_t n = x->children.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Tree& factor = x.child(i);
    const bool takes_all = factor.kind() == Kind::sum_over || factor.kind() == Kind::time_derivative;
    const bool below = x->marks[i] == '/';
    const Level place = takes_all && i + 1 == n && !below ? Level::product : Level::factor;
    const std::string own = written(factor, place);
    if (i == 0)
      all = below ? bar(number("1"), own) : own;
    else
      all = below ? bar(all, own) : x->marks[i] == ' ' ? apart(all, own) : side_by_side(all, own);
  }
  return all;
}

std::string Writer::tuple(const Tree& x) {
  std::string all = of(x.child(0));
  for (std::size_t i = 1; i < x->children.size(); ++i)
    all += sign(x->marks[i] == ';' ? "semicolon" : "comma") + of(x.child(i));
  return all;
}

std::string Writer::bare(const Tree& x) {
  switch (x.kind()) {
    case Kind::number:
      return number(x->text);
    case Kind::pi:
      return sign("pi");
    case Kind::letter:
    case Kind::variable:
    case Kind::index:
      return letter(x->text);
    case Kind::permutation_sign:
      return letter(R"(\varepsilon_\sigma)");
    case Kind::sum:
      return sum(x);
    case Kind::product:
      return product(x);
    case Kind::dot:
      return (x.child(0).kind() == Kind::dot ? bare(x.child(0)) : written(x.child(0), Level::cross)) +
             sign("dot") + written(x.child(1), Level::cross);
    case Kind::cross:
      return written(x.child(0), Level::cross) + sign("cross") + written(x.child(1), Level::product);
    case Kind::fraction:
      return fraction(x.child(0), x.child(1));
    case Kind::power:
      // \sin^{-1} is a different function.
      if (x.child(0).kind() == Kind::function && x.child(1).kind() != Kind::sum)
        return function(x.child(0)->text, of(x.child(1)), x.child(0).child(0));
      return power(written(x.child(0), Level::base), x.child(1));
    case Kind::transposed:
      if (x->children.size() > 1) return power(written(x.child(0), Level::base), x.child(1));
      return transposed(written(x.child(0), Level::base));
    case Kind::function:
      return function(x->text, x->children.size() > 1 ? of(x.child(1)) : "", x.child(0));
    case Kind::root:
      return root(x.child(0), x->children.size() > 1 ? of(x.child(1)) : "");
    case Kind::bars:
      return bars(x.child(0), !x->text.empty());
    case Kind::tuple:
      return parentheses(tuple(x));
    case Kind::row:
      return matrix({{of(x.child(0))}}, "");
    case Kind::matrix: {
      std::vector<Parts> rows;
      for (const Tree& row : x->children) {
        rows.emplace_back();
        for (const Tree& entry : row->children) rows.back().push_back(of(entry));
      }
      return matrix(rows, x->text);
    }
    case Kind::diagonal:
      return named("Diag", x.child(0).kind() == Kind::tuple ? tuple(x.child(0)) : of(x.child(0)));
    case Kind::skew:
      return named("Skew", x.child(0).kind() == Kind::tuple ? tuple(x.child(0)) : of(x.child(0)));
    case Kind::unskew:
      return named("Unskew", of(x.child(0)));
    case Kind::sum_over:
      // In index notation, a sum over 0, 1, 2 without a sign.
      return x->text.empty() ? bare(x.child(0))
                             : sum_over(x->text, x->children.size() > 1 ? of(x.child(1)) : "",
                                        written(x.child(0), Level::product));
    case Kind::permutations:
      return sum_over(x->text, "", of(x.child(0)));
    case Kind::components:
      return bare(x.child(0));
    case Kind::integral:
      return integral(x);
    case Kind::along_curve:
      return along_curve(x);
    case Kind::time_derivative:
      return time_derivative(written(x.child(0), Level::base));
    case Kind::largest:
      return named("max", of(x.child(0)) + sign("comma") + of(x.child(1)));
    case Kind::smallest:
      return named("min", of(x.child(0)) + sign("comma") + of(x.child(1)));
    case Kind::nothing:
      return "";
    case Kind::group: {
      const std::size_t space = x->text.find(' ');
      return brackets(x->text.substr(0, space), of(x.child(0)), x->text.substr(space + 1));
    }
    case Kind::indexed:
      return indexed(written(x.child(0), Level::base), x->text);
    case Kind::line: {
      std::string all;
      for (const Tree& part : x->children) all += of(part);
      return all;
    }
    case Kind::sign:
      return relation(x->text);
    case Kind::large:
      return large(x->text, x.child(0), x->children.size() > 1 ? &x.child(1) : nullptr);
    case Kind::words:
      return x->children.empty() ? words(x->text) : upright(x.child(0));
    case Kind::marked:
      return x->text.empty() ? marked(bare(x.child(0))) : bare(x.child(0));
  }
  return "";
}

}  // namespace oddity::formula
