#pragma once

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "chapters/exercise.hpp"
#include "chapters/expression.hpp"
#include "chapters/random.hpp"

/// Index notation, parsed and evaluated, and the curl applied n times: nested, and by the general formula
/// with the permutation tensor,
///   ((curl)^n f)_i = e(i jn kn) e(kn j(n-1) k(n-1)) ... e(k2 j1 k1) f(k1, j1 ... jn).
namespace oddity::fields {

/// Tensors by name and rank, with their components in the order of the indices.
template <class T>
using Tensors = std::map<std::pair<std::string, std::size_t>, std::vector<T>>;

/// The sign of the permutation (i j k) of (0 1 2), by its inversions; 0 if two indices are equal.
constexpr double permutation_sign(std::size_t i, std::size_t j, std::size_t k) {
  if (i == j || j == k || i == k) return 0;
  return ((i > j) + (j > k) + (i > k)) % 2 == 0 ? 1 : -1;
}

template <class T>
void put_permutation_tensor(Tensors<T>& tensors) {
  std::vector<T>& e = tensors[{"e", 3}];
  for (std::size_t n = 0; n < 27; ++n) e.push_back(T(permutation_sign(n / 9, n / 3 % 3, n % 3)));
}

/// f(m, j1 ... jn) for all values of the indices.
template <int order, class Field, class T>
std::vector<T> derivatives(const Field& f, const Triple<T>& x) {
  if constexpr (order == 0) {
    const Triple<T> value = f(x);
    return {value.begin(), value.end()};
  } else {
    std::vector<T> all;
    std::array<std::vector<T>, 3> of_slope;
    for (std::size_t j = 0; j < 3; ++j) of_slope[j] = derivatives<order - 1>(partial(f, j), x);
    const std::size_t block = of_slope[0].size() / 3;
    for (std::size_t m = 0; m < 3; ++m)
      for (const std::vector<T>& slope : of_slope)
        for (std::size_t n = 0; n < block; ++n) all.push_back(slope[m * block + n]);
    return all;
  }
}

class IndexExpression {
 public:
  /// Every index except the free one is summed over 0, 1, 2.
  IndexExpression(std::string text, const std::string& free) : text_(std::move(text)), indices_{free} {
    std::string spaced;
    for (char c : text_) spaced += c == '(' ? ' ' : c == ',' ? ' ' : c == ')' ? ';' : c;
    std::istringstream factors(spaced);
    for (std::string factor; std::getline(factors, factor, ';');) {
      std::istringstream words(factor);
      Factor& read = factors_.emplace_back();
      words >> read.tensor;
      for (std::string index; words >> index;) read.indices.push_back(place(index));
    }
  }

  const std::string& text() const { return text_; }

  /// The indices that occur this many times.
  std::set<std::string> occurring(int times) const {
    std::map<std::size_t, int> counts;
    for (const Factor& factor : factors_)
      for (std::size_t k : factor.indices) ++counts[k];
    std::set<std::string> all;
    for (const auto& [k, count] : counts)
      if (count == times) all.insert(indices_[k]);
    return all;
  }

  /// Violations of the convention: a free index that does not occur once, or another that does not occur
  /// twice.
  long ill_formed() const {
    std::vector<int> counts(indices_.size());
    for (const Factor& factor : factors_)
      for (std::size_t k : factor.indices) ++counts[k];
    long violations = counts[0] != 1;
    for (std::size_t k = 1; k < counts.size(); ++k) violations += counts[k] != 2;
    return violations;
  }

  /// Size of the terms that are added up: the largest product of components, times the number of nonzero
  /// terms.
  double size(Tensors<double> tensors) const {
    for (auto& [name, components] : tensors) {
      if (name.first == "e") continue;
      const double largest = size_of(Value(components));
      for (double& c : components) c = largest;
    }
    for (double& sign : tensors.at({"e", 3})) sign = std::abs(sign);
    return size_of(Value(value(tensors)));
  }

  /// The three components for the values of the free index.
  template <class T>
  Triple<T> value(const Tensors<T>& tensors) const {
    std::vector<const std::vector<T>*> found;
    for (const Factor& factor : factors_)
      found.push_back(&tensors.at({factor.tensor, factor.indices.size()}));
    Triple<T> sum{};
    std::vector<std::size_t> at(indices_.size());
    do {
      T product(1.0);
      for (std::size_t n = 0; n < factors_.size() && !is_zero(product); ++n) {
        std::size_t place = 0;
        for (std::size_t k : factors_[n].indices) place = 3 * place + at[k];
        product = product * (*found[n])[place];
      }
      sum[at[0]] += product;
    } while (advance(at));
    return sum;
  }

 private:
  struct Factor {
    std::string tensor;
    std::vector<std::size_t> indices;
  };

  static bool is_zero(double x) { return x == 0; }
  static bool is_zero(const Shortened& x) { return x.expression().coq() == "0"; }
  template <class T>
  static bool is_zero(const Dual<T>& x) {
    return is_zero(x.value) && is_zero(x.slope);
  }
  static bool advance(std::vector<std::size_t>& at) {
    for (std::size_t& k : at) {
      if (++k < 3) return true;
      k = 0;
    }
    return false;
  }
  std::size_t place(const std::string& index) {
    const auto found = std::ranges::find(indices_, index);
    if (found == indices_.end()) indices_.push_back(index);
    return static_cast<std::size_t>(std::ranges::find(indices_, index) - indices_.begin());
  }

  std::string text_;
  std::vector<std::string> indices_;
  std::vector<Factor> factors_;
};

// ---- repeated curls ---------------------------------------------------------------------------------------

constexpr int most_curls = 4;

/// (curl)^n f.
template <int n, class Field>
auto repeated_curl(const Field& f, const Frame& frame = axes) {
  if constexpr (n == 0)
    return f;
  else
    return curl(repeated_curl<n - 1>(f, frame), frame);
}

/// Calls `use` with the constants 1, ..., most_curls.
template <class Use>
void for_each_order(const Use& use) {
  [&]<int... n>(std::integer_sequence<int, n...>) { (use.template operator()<n + 1>(), ...); }
  (std::make_integer_sequence<int, most_curls>());
}

inline std::string numbered(const char* letter, int n) { return letter + std::to_string(n); }

/// The factors e(free jn kn) ... e(k2 j1 k1), the first one last; `link` formats one from its three indices.
using Link = std::string (*)(const std::string& up, const std::string& j, const std::string& k);
inline std::string chain(int n, const std::string& free, Link link) {
  std::string text;
  for (int l = n; l >= 1; --l)
    text += link(l == n ? free : numbered("k", l + 1), numbered("j", l), numbered("k", l));
  return text;
}
inline std::string as_printed(const std::string& up, const std::string& j, const std::string& k) {
  return "e(" + up + " " + j + " " + k + ") ";
}
inline std::string reversed(const std::string& up, const std::string& j, const std::string& k) {
  return "e(" + k + " " + j + " " + up + ") ";
}
inline std::string first_reversed(const std::string& up, const std::string& j, const std::string& k) {
  return j == "j1" ? reversed(up, j, k) : as_printed(up, j, k);
}
/// f(k1, j1 ... jn)
inline std::string derivative_of_f(int n, const std::string& component = "k1",
                                   const std::string& first = "j1") {
  std::string text = "f(" + component + ", " + first;
  for (int l = 2; l <= n; ++l) text += " " + numbered("j", l);
  return text + ")";
}

// ---- in the coordinates of a rotated frame ----------------------------------------------------------------

template <class T>
using FrameOf = std::array<Triple<T>, 3>;

template <class T>
Triple<T> turned(const FrameOf<T>& r, const Triple<T>& v) {
  return {dot(r[0], v), dot(r[1], v), dot(r[2], v)};
}
/// The field as a function of y = R x.
template <class Field, class R>
auto turned_field(const Field& f, const FrameOf<R>& r) {
  return [f, r](const auto& y) {
    const auto v = f(std::array{r[0][0] * y[0] + r[1][0] * y[1] + r[2][0] * y[2],
                                r[0][1] * y[0] + r[1][1] * y[1] + r[2][1] * y[2],
                                r[0][2] * y[0] + r[1][2] * y[1] + r[2][2] * y[2]});
    return std::array{dot(r[0], v), dot(r[1], v), dot(r[2], v)};
  };
}

}  // namespace oddity::fields

namespace oddity::ex05_15 {

/// The curls applied 1, ..., `most` times.
std::vector<Quantity> quantities(const fields::At&, double most, const Reference&);

std::vector<Claim> claims(const Random&);
Provables proofs();

}  // namespace oddity::ex05_15
