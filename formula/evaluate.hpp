#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "formula/gauss.hpp"
#include "formula/matrix.hpp"
#include "formula/tree.hpp"

namespace oddity::formula {

/// Pi and fractions for number types that have more digits than double. A type may specialize it.
template <class T>
struct Constants {
  static T pi() { return T(std::numbers::pi); }
};
template <>
struct Constants<long double> {
  static long double pi() { return std::numbers::pi_v<long double>; }
};

namespace detail {

/// Computes 2.5 as 25 over 10, so that decimals are as exact as the number type.
template <class T>
T of_digits(const std::string& digits) {
  double whole = 0, power = 1;
  int exponent = 0;
  bool decimals = false;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const char c = digits[i];
    if (c == '.') {
      decimals = true;
    } else if (c == 'e' || c == 'E') {
      exponent = std::stoi(digits.substr(i + 1, 5));
      break;
    } else {
      whole = 10 * whole + (c - '0');
      if (decimals) power *= 10;
    }
  }
  if (std::abs(exponent) > 300) throw NoValue("a number that is too large or too small");
  for (; exponent < 0; ++exponent) power *= 10;
  for (; exponent > 0; --exponent) power == 1 ? whole *= 10 : power /= 10;
  return power == 1 ? T(whole) : T(whole) / T(power);
}

template <class T>
T whole_power(const T& x, int n) {
  if (n < 0) return T(1) / whole_power(x, -n);
  T y = n % 2 == 0 ? T(1) : x;
  if (n > 1) {
    const T root = whole_power(x, n / 2);
    y = n % 2 == 0 ? root * root : root * root * x;
  }
  return y;
}

}  // namespace detail

/// A function of one number by its name; the type's own version, found by argument-dependent lookup. Throws
/// NoValue if the type lacks it.
template <class T>
T function_of(std::string_view name, const T& x) {
  using std::sin, std::cos, std::tan, std::asin, std::acos, std::atan, std::sinh, std::cosh, std::tanh,
      std::asinh, std::acosh, std::atanh, std::exp, std::log, std::sqrt, std::abs;
#define ODDITY_FUNCTION(written, f)    \
  if constexpr (requires { T(f(x)); }) \
    if (name == written) return T(f(x));
  ODDITY_FUNCTION(R"(\sin)", sin)
  ODDITY_FUNCTION(R"(\cos)", cos)
  ODDITY_FUNCTION(R"(\tan)", tan)
  ODDITY_FUNCTION(R"(\arcsin)", asin)
  ODDITY_FUNCTION(R"(\arccos)", acos)
  ODDITY_FUNCTION(R"(\arctan)", atan)
  ODDITY_FUNCTION(R"(\sinh)", sinh)
  ODDITY_FUNCTION(R"(\cosh)", cosh)
  ODDITY_FUNCTION(R"(\tanh)", tanh)
  ODDITY_FUNCTION(R"(\arsinh)", asinh)
  ODDITY_FUNCTION(R"(\arcosh)", acosh)
  ODDITY_FUNCTION(R"(\artanh)", atanh)
  ODDITY_FUNCTION(R"(\exp)", exp)
  ODDITY_FUNCTION(R"(\ln)", log)
  ODDITY_FUNCTION(R"(\sqrt)", sqrt)
  ODDITY_FUNCTION(R"(\abs)", abs)
#undef ODDITY_FUNCTION
  // By other functions of the type.
  if (name == R"(\tan)") return function_of(R"(\sin)", x) / function_of(R"(\cos)", x);
  if constexpr (requires { exp(x); }) {
    if (name == R"(\sinh)") return (exp(x) - exp(-x)) / T(2);
    if (name == R"(\cosh)") return (exp(x) + exp(-x)) / T(2);
    if (name == R"(\tanh)") return T(1) - T(2) / (exp(x + x) + T(1));
  }
  throw NoValue("this kind of number has no " + std::string(name));
}

/// A formula's value in any number type that has + - * / and functions. Integrals use Gauss's rule, unless
/// the type has an integral_over(f, from, to). Letters are in the order of the names with which the formula
/// was read.
template <class T>
class Evaluation {
 public:
  explicit Evaluation(std::span<const Matrix<T>> letters) : letters_(letters) {}

  Matrix<T> of(const Tree& x) {
    if (--left_ < 0) throw NoValue("a sum or an integral of too many terms");
    switch (x.kind()) {
      case Kind::number:
        return {{detail::of_digits<T>(x->text)}};
      case Kind::pi:
        return {{Constants<T>::pi()}};
      case Kind::letter:
        return letter(*x);
      case Kind::variable:
        return {{at(variables_, x->slots[0])}};
      case Kind::index:
        return {{T(static_cast<double>(at(indices_, x->slots[0])))}};
      case Kind::permutation_sign:
        return {{T(static_cast<double>(permutation_sign_))}};
      case Kind::sum:
        return of_sum(x);
      case Kind::product:
        return of_product(x);
      case Kind::dot: {
        const Matrix<T> a = of(x.child(0)), b = of(x.child(1));
        return a.is_number() || b.is_number() ? product_of(a, b) : Matrix<T>{{dot_of(a, b)}};
      }
      case Kind::cross:
        return cross_of(of(x.child(0)), of(x.child(1)));
      case Kind::fraction: {
        const Matrix<T> above = of(x.child(0));
        return divided(above, number(x.child(1)));
      }
      case Kind::power:
        return {{power(number(x.child(0)), x.child(1))}};
      case Kind::transposed:
        return of_transposed(x);
      case Kind::function:
        return {{function_of<T>(x->text, number(x.child(0)))}};
      case Kind::root:
        return {{function_of<T>(R"(\sqrt)", number(x.child(0)))}};
      case Kind::bars:
        return of_bars(of(x.child(0)));
      case Kind::tuple:
        return of_tuple(x);
      case Kind::row:
        return folded(x, [](const Matrix<T>& a, const Matrix<T>& b) { return abreast(a, b); });
      case Kind::matrix:
        return folded(x, [](const Matrix<T>& a, const Matrix<T>& b) { return stacked(a, b); });
      case Kind::diagonal:
        return diagonal_of(of(x.child(0)).entries);
      case Kind::skew:
        return skew_of(of(x.child(0)).entries);
      case Kind::unskew:
        return unskew_of(of(x.child(0)));
      case Kind::sum_over:
        return of_sum_over(x);
      case Kind::permutations:
        return of_permutations(x);
      case Kind::components:
        return of_components(x);
      case Kind::integral:
        return of_integral(x);
      case Kind::along_curve:
        return along_curve(x);
      case Kind::time_derivative:
        return of(x.child(1));
      case Kind::largest:
      case Kind::smallest:
        return {{extreme(x.kind() == Kind::largest, number(x.child(0)), number(x.child(1)))}};
      case Kind::nothing:
      case Kind::group:
      case Kind::indexed:
      case Kind::line:
      case Kind::sign:
      case Kind::large:
      case Kind::words:
      case Kind::marked:
        break;
    }
    throw NoValue("a formula that is only shown");
  }

 private:
  T number(const Tree& x) { return number_of(of(x)); }

  template <class X>
  static X& at(std::vector<X>& all, std::size_t slot) {
    if (slot >= all.size()) all.resize(slot + 1, X(0));
    return all[slot];
  }

  Matrix<T> letter(const Node& x) {
    for (const Entry& entry : x.entries) {
      bool here = true;
      for (std::size_t i = 0; i < x.slots.size(); ++i)
        here = here && at(indices_, x.slots[i]) == entry.indices[i];
      if (here) return value_of(entry, x.order);
    }
    throw NoValue("no letter " + x.text + " with these indices");
  }
  Matrix<T> value_of(const Entry& entry, std::size_t order) const {
    const auto known = [&](int i) -> const Matrix<T>& { return letters_[static_cast<std::size_t>(i)]; };
    if (order >= entry.rates.size()) return scaled(known(entry.rates[0]), T(0));
    const Matrix<T>& value = known(entry.rates[order]);
    if (nodes_ > 0 && order == 0)
      for (const int i : {entry.along, entry.rates[0]})
        if (i >= 0 && known(i).entries.size() >= nodes_ && known(i).entries.size() % nodes_ == 0)
          return at_node(known(i));
    return value;
  }
  Matrix<T> at_node(const Matrix<T>& all) const {
    const std::size_t size = all.entries.size() / nodes_;
    const auto first = all.entries.begin() + static_cast<std::ptrdiff_t>(node_ * size);
    return {std::vector<T>(first, first + static_cast<std::ptrdiff_t>(size))};
  }

  /// A lone 0 is a zero of any shape.
  Matrix<T> of_sum(const Tree& x) {
    std::optional<Matrix<T>> total;
    for (std::size_t i = 0; i < x->children.size(); ++i) {
      const bool subtract = x->marks[i] == '-' || x->marks[i] == 'm';
      if (is_number(x.child(i), "0") && (total || x->children.size() > 1)) continue;
      Matrix<T> term = of(x.child(i));
      if (x->marks[i] == 'p' || x->marks[i] == 'm')
        term = scaled(std::move(term), number_of(value_of(x->entries.at(0), 0)));
      if (total)
        total = added(std::move(*total), term, subtract);
      else
        total = subtract ? negated(term) : term;
    }
    return total ? *total : Matrix<T>{{T(0)}};
  }
  Matrix<T> of_product(const Tree& x) {
    std::optional<Matrix<T>> all;
    for (std::size_t i = 0; i < x->children.size(); ++i) {
      const Matrix<T> factor = of(x.child(i));
      if (x->marks[i] == '/')
        all = divided(all ? std::move(*all) : Matrix<T>{{T(1)}}, number_of(factor));
      else
        all = all ? product_of(*all, factor) : factor;
    }
    return *all;
  }
  T power(const T& x, const Tree& exponent) {
    int n = 0;
    if (is_whole(exponent, n)) {
      if constexpr (std::floating_point<T>)
        return std::pow(x, static_cast<T>(n));
      else if constexpr (requires { T(pow(x, n)); })
        return T(pow(x, n));
      else
        return detail::whole_power(x, n);
    }
    const T y = number(exponent);
    if constexpr (std::floating_point<T>) {
      return std::pow(x, y);
    } else if constexpr (requires { T(pow(x, y)); }) {
      return T(pow(x, y));
    } else {
      return function_of<T>(R"(\exp)", y * function_of<T>(R"(\ln)", x));
    }
  }
  Matrix<T> of_transposed(const Tree& x) {
    const Matrix<T> value = of(x.child(0));
    if (!value.is_number()) return transposed(value);
    if (x->children.size() < 2) throw NoValue("a number is not transposed");
    return {{power(value.entries[0], x.child(1))}};
  }
  Matrix<T> of_bars(const Matrix<T>& x) {
    if (x.is_number()) return {{function_of<T>(R"(\abs)", x.entries[0])}};
    return {{function_of<T>(R"(\sqrt)", dot_of(x, x))}};
  }
  Matrix<T> of_tuple(const Tree& x) {
    Matrix<T> all = of(x.child(0));
    std::size_t columns = 1;
    for (std::size_t i = 1; i < x->children.size(); ++i) {
      if (x->marks[i] == ';' && columns == 1) columns = all.entries.size();
      all = joined(std::move(all), of(x.child(i)));
    }
    if (all.entries.size() % columns != 0) throw NoValue("rows of different lengths");
    if (columns > 1 || x->children.size() > 1) all.columns = columns;
    return all;
  }
  template <class F>
  Matrix<T> folded(const Tree& x, const F& f) {
    Matrix<T> all = of(x.child(0));
    for (std::size_t i = 1; i < x->children.size(); ++i) all = f(all, of(x.child(i)));
    return all;
  }

  Matrix<T> of_sum_over(const Tree& x) {
    std::optional<Matrix<T>> total;
    const int last = x->children.size() > 1 ? whole(x.child(1)) : 99;
    for (const int i : x->range) {
      if (i > last) break;
      at(indices_, x->slots[0]) = i;
      const Matrix<T> term = of(x.child(0));
      total = total ? added(std::move(*total), term, false) : term;
    }
    if (!total) throw NoValue("a sum of no terms");
    return *total;
  }
  int whole(const Tree& x) {
    int value = 0;
    if (x.kind() == Kind::index) return at(indices_, x->slots[0]);
    if (!is_whole(x, value)) throw NoValue("a sum whose bound is not a whole number");
    return value;
  }
  Matrix<T> of_permutations(const Tree& x) {
    const std::size_t n = x->slots.size();
    std::vector<int> order;
    for (std::size_t i = 0; i < n; ++i) order.push_back(static_cast<int>(i) + 1);
    std::optional<Matrix<T>> total;
    do {
      permutation_sign_ = 1;
      for (std::size_t i = 0; i < n; ++i) {
        at(indices_, x->slots[i]) = order[i];
        for (std::size_t k = i + 1; k < n; ++k)
          if (order[i] > order[k]) permutation_sign_ = -permutation_sign_;
      }
      const Matrix<T> term = of(x.child(0));
      total = total ? added(std::move(*total), term, false) : term;
    } while (std::ranges::next_permutation(order).found);
    return *total;
  }
  Matrix<T> of_components(const Tree& x) {
    Matrix<T> all{{}, x->slots.size() > 1 ? x->range.size() : 1};
    for (const int i : x->range) {
      at(indices_, x->slots[0]) = i;
      for (const int k : x->slots.size() > 1 ? x->range : std::vector<int>{0}) {
        if (x->slots.size() > 1) at(indices_, x->slots[1]) = k;
        all.entries.push_back(number(x.child(0)));
      }
    }
    return all;
  }
  Matrix<T> of_integral(const Tree& x) {
    const T from = number(x.child(0)), to = number(x.child(1));
    const auto integrand = [&](const T& t) {
      at(variables_, x->slots[0]) = t;
      return number(x.child(2));
    };
    if constexpr (requires { T(integral_over(integrand, from, to)); }) {
      return {{integral_over(integrand, from, to)}};
    } else {
      const T half = (to - from) / T(2), middle = (to + from) / T(2);
      std::optional<T> total;
      for (const auto& [node, weight] : gauss_64()) {
        const T term = T(weight) * integrand(middle + half * T(node));
        total = total ? *total + term : term;
      }
      return {{half * *total}};
    }
  }
  Matrix<T> along_curve(const Tree& x) {
    const Entry& ds = x.child(1)->entries[0];
    const Matrix<T>& weights = letters_[static_cast<std::size_t>(ds.along >= 0 ? ds.along : ds.rates[0])];
    if (weights.entries.size() < 10) throw NoValue("ds is fewer than ten numbers");
    const std::size_t outside = std::exchange(nodes_, weights.entries.size());
    std::optional<T> total;
    for (std::size_t i = 0; i < weights.entries.size(); ++i) {
      node_ = i;
      const T term = weights.entries[i] * number(x.child(0));
      total = total ? *total + term : term;
    }
    nodes_ = outside;
    return {{*total}};
  }
  static T extreme(bool largest, const T& a, const T& b) {
    if constexpr (requires { T(max(a, b)); })
      return largest ? T(max(a, b)) : T(min(a, b));
    else if constexpr (requires { a < b ? 1 : 0; })
      return (a < b) == largest ? b : a;
    else
      throw NoValue("this kind of number has no maximum");
  }

  std::span<const Matrix<T>> letters_;
  std::vector<int> indices_;
  std::vector<T> variables_;
  std::size_t nodes_ = 0, node_ = 0;
  int permutation_sign_ = 1;
  long left_ = 2'000'000;
};

extern template class Evaluation<double>;

template <class T>
Matrix<T> evaluate(const Tree& x, std::span<const Matrix<T>> letters) {
  return Evaluation<T>(letters).of(x);
}
template <class T>
Matrix<T> evaluate(const Tree& x, const std::vector<Matrix<T>>& letters) {
  return Evaluation<T>(letters).of(x);
}

}  // namespace oddity::formula
