// The curl of plane waves, applied up to four times: nested, term by term by the tensors' formula, and by
// differences.
#include "chapters/05_fluids_and_gases/15_repeated_curl/repeated_curl.hpp"

namespace oddity::ex05_15 {

namespace {

using namespace fields;

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

/// A sum and the number of evaluated terms.
struct Sum {
  double value = 0;
  long terms = 0;
};

/// The sum over j_l, k_l and all below, where `up` is k_(l+1). Each term computes its own derivative. Terms
/// whose sign is zero are either evaluated too, or skipped as soon as the sign is known.
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

/// Nested curls by one way of differentiation; `way` is copied for each level.
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
  Quantity q = quantity("curl_" + times, n == 1 ? "1/m" : "1/m^" + times,
                        "the curl of plane waves, applied $n=" + times + "$ times", known,
                        {1e-7 * size_of(known.value), "seven digits of the largest component"});
  const std::string dual = "nested dual numbers";
  q.add({"repeated curl", dual, no_resolution(), [=](double) {
           long calls = 0;
           const auto counted = [&](const auto& y) { return ++calls, f(y); };
           const Value value = repeated_curl<n>(counted)(x);
           return Answer{value, calls};
         }});
  q.add(
      {"tensor formula, every term", dual, no_resolution(), [=](double) { return by_terms<n>(f, x, true); }});
  q.add({"tensor formula, zeros left out", dual, no_resolution(),
         [=](double) { return by_terms<n>(f, x, false); }});
  q.add({"tensor formula, derivatives kept", dual, no_resolution(), [=](double) {
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
  const std::string why =
      n == 1 ? std::string("rounding grows as $1/h$") : "rounding grows as $1/h^" + times + "$";
  q.add({"repeated curl", "central differences 2", steps(finest[n - 1]),
         [=](double h) { return differenced(ByDifferences<2>{h}); }, Outcome::inaccurate, why});
  q.add({"repeated curl", "central differences 4", steps(finest[n - 1]),
         [=](double h) { return differenced(ByDifferences<4>{h}); }, Outcome::inaccurate, why});
  if (n == 4)
    q.add(Breakdown{
        R"(Differences of differences of differences of differences lose $\varepsilon/h^4$: even the )"
        R"(best step of order 2, near $\varepsilon^{1/6}/w$, keeps @1 digits.)",
        "repeated curl, central differences 2",
        step_near(best_power(6, at.waves.w)),
        Outcome::inaccurate,
        "repeated curl, nested dual numbers",
        0,
        {digits_of(Side::broken)}});
  return q;
}

}  // namespace

std::vector<Quantity> quantities(const At& at, double most, const Reference& truth) {
  std::vector<Quantity> all;
  for_each_order([&]<int n>() {
    if (n <= most) all.push_back(nth_curl<n>(at, truth));
  });
  return all;
}

}  // namespace oddity::ex05_15
