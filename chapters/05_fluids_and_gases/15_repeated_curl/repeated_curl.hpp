#pragma once

#include "chapters/05_fluids_and_gases/15_repeated_curl/tensor.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"

/// The curl applied n times: nested, and by the general formula of the permutation tensor,
///   ((curl)^n f)_i = e(i jn kn) e(kn j(n-1) k(n-1)) ... e(k2 j1 k1) f(k1, j1 ... jn).
namespace oddity::fields {

constexpr int most_curls = 4;

/// (curl)^n f.
template <int n, class Field>
auto repeated_curl(const Field& f, const Frame& frame = axes) {
  if constexpr (n == 0)
    return f;
  else
    return curl(repeated_curl<n - 1>(f, frame), frame);
}

/// `use` with the constants 1, ..., most_curls.
template <class Use>
void for_each_order(const Use& use) {
  [&]<int... n>(std::integer_sequence<int, n...>) { (use.template operator()<n + 1>(), ...); }
  (std::make_integer_sequence<int, most_curls>());
}

inline std::string numbered(const char* letter, int n) { return letter + std::to_string(n); }

/// The factors e(free jn kn) ... e(k2 j1 k1), the first one last; `link` writes one from its three indices.
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

// ---- the quantities ---------------------------------------------------------------------------------------

/// p sin(k.x + 1/2) + q exp(l.x); reference/make/05_15_repeated_curl.cpp has its own copy.
struct PlaneWaves {
  double w;
  template <class T>
  Triple<T> operator()(const Triple<T>& x) const {
    using std::exp, std::sin;
    const T wave = sin(w * (2.0 * x[0] + x[1] - x[2]) + 0.5);
    const T growth = exp(w * (0.5 * x[0] - x[1] + 0.25 * x[2]));
    return {wave + 0.75 * growth, growth - 2.0 * wave, 0.5 * wave - growth};
  }
};

/// f(k1, j1 ... jn) for all components k1: `js` holds j1 ... jn.
template <int n, int l = 0, class Field, class T>
Triple<T> derivative_along(const Field& f, const Triple<T>& x, const std::array<std::size_t, n>& js) {
  if constexpr (l == n)
    return f(x);
  else
    return derivative_along<n, l + 1>(partial(f, js[l]), x, js);
}

/// A sum, and how many of its terms were taken.
struct Sum {
  double value = 0;
  long terms = 0;
};

/// The sum over j_l, k_l and all below, `up` being k_(l+1): each term takes a derivative of its own.
/// Terms whose sign is zero are taken too, or left out as soon as it is known.
template <int n, int l = n, class Field>
Sum sum_of_terms(const Field& f, const Point& x, bool zeros_too, std::size_t up, double sign = 1,
                 std::array<std::size_t, n> js = {}) {
  if constexpr (l == 0) {
    return {sign * derivative_along<n>(f, x, js)[up], 1};
  } else {
    Sum sum;
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        const double next = sign * permutation_sign(up, j, k);
        if (next == 0 && !zeros_too) continue;
        js[l - 1] = j;
        const Sum below = sum_of_terms<n, l - 1>(f, x, zeros_too, k, next, js);
        sum.value += below.value;
        sum.terms += below.terms;
      }
    return sum;
  }
}
template <int n, class Field>
Answer by_terms(const Field& f, const Point& x, bool zeros_too) {
  const Sum c0 = sum_of_terms<n>(f, x, zeros_too, 0), c1 = sum_of_terms<n>(f, x, zeros_too, 1),
            c2 = sum_of_terms<n>(f, x, zeros_too, 2);
  return {Value{c0.value, c1.value, c2.value}, c0.terms + c1.terms + c2.terms};
}

/// Curls of curls by one way of differentiation; `way` is copied for each level.
template <int n, class Way, class Field>
Point curls_by(const Way& way, const Field& f, const Point& x) {
  if constexpr (n == 0) {
    return f(x);
  } else {
    Way level = way;
    return curl_by(
        level, [&](const Point& y) { return curls_by<n - 1>(way, f, y); }, x);
  }
}

template <int n>
Quantity nth_curl(const At& at, const Reference& truth) {
  std::vector<double> inputs = at.inputs();
  inputs.push_back(n);
  const Known known = truth("05_15_repeated_curl", inputs);
  const Point x = at.x;
  const PlaneWaves f{at.waves.w};
  const std::string times = std::to_string(n);
  Quantity q =
      quantity("curl_" + times, "1/m^" + times, "the curl of plane waves, applied n = " + times + " times",
               known, {1e-7 * size_of(known.value), "seven digits of the largest component"});
  const std::string dual = "nested dual numbers";
  q.add({"repeated curl", dual, no_knob(), [=](double) {
           long calls = 0;
           const auto counted = [&](const auto& y) { return ++calls, f(y); };
           const Value value = repeated_curl<n>(counted)(x);
           return Answer{value, calls};
         }});
  q.add({"tensor formula, every term", dual, no_knob(), [=](double) { return by_terms<n>(f, x, true); }});
  q.add(
      {"tensor formula, zeros left out", dual, no_knob(), [=](double) { return by_terms<n>(f, x, false); }});
  q.add({"tensor formula, derivatives kept", dual, no_knob(), [=](double) {
           long calls = 0;
           const auto counted = [&](const auto& y) { return ++calls, f(y); };
           const IndexExpression formula(chain(n, "i", as_printed) + derivative_of_f(n), "i");
           Tensors<double> tensors;
           put_permutation_tensor(tensors);
           tensors[{"f", n + 1}] = derivatives<n>(counted, x);
           return Answer{Value(formula.value(tensors)), calls};
         }});
  const auto differenced = [=](auto way) {
    long calls = 0;
    const Value value = curls_by<n>(
        way, [&](const Point& y) { return ++calls, f(y); }, x);
    return Answer{value, calls};
  };
  constexpr int finest[] = {31, 25, 17, 13};
  const std::string why = "rounding grows as eps/h^" + times;
  q.add({"repeated curl", "central differences 2", steps(finest[n - 1]),
         [=](double h) { return differenced(ByDifferences<2>{h}); }, Outcome::inaccurate, why});
  q.add({"repeated curl", "central differences 4", steps(finest[n - 1]),
         [=](double h) { return differenced(ByDifferences<4>{h}); }, Outcome::inaccurate, why});
  if (n == 4)
    q.add(Breakdown{
        "Differences of differences of differences of differences lose $\\varepsilon/h^4$: even the best "
        "step of order 2, near $\\varepsilon^{1/6}$, has five digits.",
        "repeated curl, central differences 2", 0x1p-9, Outcome::inaccurate,
        "repeated curl, nested dual numbers", 0});
  return q;
}

}  // namespace oddity::fields
