// Exercise 5.15: the curl applied n times, by the permutation tensor e:
//   ((curl)^n f)_i = e(i jn kn) e(kn j(n-1) k(n-1)) ... e(k2 j1 k1) f(k1, j1 ... jn)
// Every published index expression is evaluated as it is written, from derivatives along the axes, and
// compared with curls nested in one another by dual numbers along a frame turned at random. The quantity's
// reference is the closed form for plane waves, whose curl is k x p cos.

#include <Eigen/Geometry>

#include "chapters/05_fluids_and_gases/differentiation.hpp"
#include "chapters/05_fluids_and_gases/tensor.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

using namespace fields;

constexpr int most = 4;

constexpr auto parameters = [] {
  std::array<Parameter, 6> all{{{"n", most, "", "how often the curl is applied", 1, most}}};
  for (std::size_t i = 0; i < 5; ++i) all[1 + i] = field_parameters[i];
  return all;
}();

/// (curl)^n f.
template <int n, class Field>
auto repeated_curl(const Field& f, const Frame& frame = axes) {
  if constexpr (n == 0)
    return f;
  else
    return curl(repeated_curl<n - 1>(f, frame), frame);
}

/// `use` with the constants 1, ..., most.
template <class Use>
void for_each_order(const Use& use) {
  [&]<int... n>(std::integer_sequence<int, n...>) { (use.template operator()<n + 1>(), ...); }
  (std::make_integer_sequence<int, most>());
}

std::string numbered(const char* letter, int n) { return letter + std::to_string(n); }

/// The factors e(free jn kn) ... e(k2 j1 k1), the first one last; `link` writes one from its three indices.
using Link = std::string (*)(const std::string& up, const std::string& j, const std::string& k);
std::string chain(int n, const std::string& free, Link link) {
  std::string text;
  for (int l = n; l >= 1; --l)
    text += link(l == n ? free : numbered("k", l + 1), numbered("j", l), numbered("k", l));
  return text;
}
std::string as_printed(const std::string& up, const std::string& j, const std::string& k) {
  return "e(" + up + " " + j + " " + k + ") ";
}
std::string reversed(const std::string& up, const std::string& j, const std::string& k) {
  return "e(" + k + " " + j + " " + up + ") ";
}
std::string first_reversed(const std::string& up, const std::string& j, const std::string& k) {
  return j == "j1" ? reversed(up, j, k) : as_printed(up, j, k);
}
/// f(k1, j1 ... jn)
std::string derivative_of_f(int n, const std::string& component = "k1", const std::string& first = "j1") {
  std::string text = "f(" + component + ", " + first;
  for (int l = 2; l <= n; ++l) text += " " + numbered("j", l);
  return text + ")";
}

// ---- samples ----------------------------------------------------------------------------------------------

struct Sampled {
  std::string where;
  Tensors<double> tensors;
  std::map<std::string, Point> left;
};

/// The field that an index expression of f's derivatives of one order is.
template <int order, class Field>
auto contracted(const Field& f, const IndexExpression& expression) {
  return [f, expression]<class T>(const Triple<T>& x) {
    Tensors<T> tensors;
    put_permutation_tensor(tensors);
    tensors[{"f", order + 1}] = derivatives<order>(f, x);
    return expression.value(tensors);
  };
}

Point turned(const Frame& r, const Point& v) { return {dot(r[0], v), dot(r[1], v), dot(r[2], v)}; }

/// The field in the coordinates of a turned frame.
template <class Field>
auto turned_field(const Field& f, const Frame& r) {
  return [f, r](const auto& y) {
    const auto v = f(std::array{r[0][0] * y[0] + r[1][0] * y[1] + r[2][0] * y[2],
                                r[0][1] * y[0] + r[1][1] * y[1] + r[2][1] * y[2],
                                r[0][2] * y[0] + r[1][2] * y[1] + r[2][2] * y[2]});
    return std::array{dot(r[0], v), dot(r[1], v), dot(r[2], v)};
  };
}

Sampled sample(Random& random, int number) {
  const ScalarField phi(random, 1, 1);
  const VectorField f(random, random.magnitude(1e-6, 1e6), random.magnitude(0.1, 3));
  const VectorField g(random, random.magnitude(1e-6, 1e6), 1);
  const Point x = random.point(), a = random.point(), b = random.point(), c = random.point();
  const Frame r = random_frame(random), mirror{r[1], r[0], r[2]};
  Sampled s{"draw " + std::to_string(number) + " at (" + shortest(x[0]) + ", " + shortest(x[1]) + ", " +
                shortest(x[2]) + ")",
            {},
            {}};
  const auto put = [&](const std::string& name, const Point& v) {
    s.tensors[{name, 1}] = {v.begin(), v.end()};
  };
  put_permutation_tensor(s.tensors);
  put("f", f(x));
  put("g", g(x));
  put("a", a);
  put("b", b);
  put("c", c);
  put("u", turned(r, g(x)));
  put("v", turned(r, f(x)));
  put("mirrored_u", turned(mirror, g(x)));
  put("mirrored_v", turned(mirror, f(x)));
  for_each_order([&]<int n>() {
    s.tensors[{"f", n + 1}] = derivatives<n>(f, x);
    s.left[numbered("curl", n)] = repeated_curl<n>(f, r)(x);
  });
  s.tensors[{"v", 3}] = derivatives<2>(turned_field(f, r), turned(r, x));
  const auto once = contracted<1>(f, {"e(k l m) f(m, l)", "k"});
  const auto twice = contracted<2>(f, {"e(k3 j2 k2) e(k2 j1 k1) f(k1, j1 j2)", "k3"});
  s.tensors[{"once", 2}] = derivatives<1>(once, x);
  s.tensors[{"phi_once", 2}] = derivatives<1>(times(phi, once), x);
  s.tensors[{"twice", 2}] = derivatives<1>(twice, x);

  const Eigen::Vector3d eigen_f(f(x)[0], f(x)[1], f(x)[2]), eigen_g(g(x)[0], g(x)[1], g(x)[2]);
  const Eigen::Vector3d product = eigen_g.cross(eigen_f);
  s.left["g x f"] = {product[0], product[1], product[2]};
  s.left["g x f, turned"] = turned(r, s.left["g x f"]);
  s.left["g x f, mirrored"] = turned(mirror, s.left["g x f"]);
  s.left["curl2, turned"] = turned(r, s.left["curl2"]);
  s.left["phi curl2"] = combined(phi(x), s.left["curl2"], 0, a);
  const auto along_a = [f, a](const auto& y) { return along(f, y, a); };
  const auto along_b = [along_a, b](const auto& y) { return along(along_a, y, b); };
  s.left["f along a, b"] = along_b(x);
  s.left["f along a, b, c"] = along(along_b, x, c);
  return s;
}

// ---- claims -----------------------------------------------------------------------------------------------

/// What an index expression is said to equal.
struct Said {
  std::string left, right, free = "i";
};

class Tensorial {
 public:
  explicit Tensorial(Random random) {
    for (int n = 0; n < 12; ++n) samples_.push_back(sample(random, n));
  }

  Check compare(const Said& said) const {
    const IndexExpression expression(said.right, said.free);
    Worst worst(said.left + " = " + said.right, "curls nested along a turned frame, or as it is named",
                "the index expression as it is written");
    for (const Sampled& s : samples_) {
      const Point left = s.left.at(said.left);
      worst.see(left, expression.value(s.tensors), expression.size(s.tensors), s.where);
    }
    return worst.check();
  }
  Reading reading(const std::vector<Said>& all) const {
    Reading reading;
    for (const Said& said : all) {
      reading.text += (reading.text.empty() ? "" : "; ") + said.right;
      reading.checks.push_back(compare(said));
    }
    return reading;
  }
  Claim claim(const std::string& slug, int at, std::string says, const std::vector<Said>& printed,
              const std::vector<std::vector<Said>>& near_misses) const {
    Claim claim{"5.15-" + slug, at, std::move(says), reading(printed)};
    for (const auto& near : near_misses) claim.near_misses.push_back(reading(near));
    return claim;
  }

 private:
  std::vector<Sampled> samples_;
};

/// Only the free index occurs once, every other one twice.
Claim summed(const std::string& slug, int at, std::string says, const std::string& expression,
             const std::string& near) {
  const auto reading = [](const std::string& text) {
    return Reading{text, {never("an index repeated wrongly", IndexExpression(text, "i").ill_formed(), 1)}};
  };
  return {"5.15-" + slug, at, std::move(says), reading(expression), {}, {}, {reading(near)}};
}

std::vector<Claim> claims(Random random) {
  const Tensorial t(random);
  std::vector<Claim> all{
      t.claim("cross_product", 3687, "g x f is e_ijk g_j f_k", {{"g x f", "e(i j k) g(j) f(k)"}},
              {{{"g x f", "e(i j k) g(k) f(j)"}}, {{"g x f", "e(j i k) g(j) f(k)"}}}),
      summed("cross_product_sums", 3689, "j and k are summed over, i is the only free index",
             "e(i j k) g(j) f(k)", "e(i j k) g(j) f(j)"),
      t.claim("cross_product_vector", 3689, "with i free it is a vector: it turns with its factors (u, v)",
              {{"g x f, turned", "e(i j k) u(j) v(k)"}},
              {{{"g x f, mirrored", "e(i j k) mirrored_u(j) mirrored_v(k)"}}}),
      t.claim("curl", 3691, "curl f is e_ijk d_j f_k", {{"curl1", "e(i j k) f(k, j)"}},
              {{{"curl1", "e(i j k) f(j, k)"}}, {{"curl1", "e(k j i) f(k, j)"}}}),
      t.claim("twice_nested", 3695, "curl curl f is e_ijk d_j (e_klm d_l f_m)",
              {{"curl2", "e(i j k) once(k, j)"}}, {{{"curl2", "e(i j k) once(j, k)"}}}),
      t.claim("twice_factored", 3695, "that is e_ijk e_klm d_j d_l f_m",
              {{"curl2", "e(i j k) e(k l m) f(m, l j)"}},
              {{{"curl2", "e(i j k) e(l k m) f(m, l j)"}}, {{"curl2", "e(i j k) e(j l m) f(m, l k)"}}}),
      t.claim("twice_comma", 3695, "that is e_ijk e_klm f_m,jl", {{"curl2", "e(i j k) e(k l m) f(m, j l)"}},
              {{{"curl2", "e(i j k) e(k l m) f(j, m l)"}}, {{"curl2", "e(i j k) e(k l m) f(l, j m)"}}}),
      t.claim("constant", 3697, "e, being constant, moves out of the derivative",
              {{"curl2", "e(i j k) e(k l m) f(m, l j)"}, {"curl2", "e(i j k) once(k, j)"}},
              {{{"phi curl2", "e(i j k) phi_once(k, j)"}}}),
      summed("twice_sums", 3697, "j, k, l and m are summed over, i is the only free index",
             "e(i j k) e(k l m) f(m, j l)", "e(i j k) e(k l m) f(m, j j)"),
      t.claim("twice_vector", 3697, "with i free it is a vector: it turns with the field (v)",
              {{"curl2, turned", "e(i j k) e(k l m) v(m, j l)"}},
              {{{"curl2", "e(i j k) e(k l m) v(m, j l)"}}}),
      t.claim("comma", 3697, "f_m,jl is the derivative of the component f_m by x_j and x_l",
              {{"f along a, b", "f(m, j l) a(j) b(l)", "m"}},
              {{{"f along a, b", "f(j, m l) a(j) b(l)", "m"}}}),
      t.claim("renamed_once", 3701, "curl f in the new names", {{"curl1", "e(i j1 k1) f(k1, j1)"}},
              {{{"curl1", "e(i k1 j1) f(k1, j1)"}}}),
      t.claim("renamed_twice", 3703, "curl curl f in the new names",
              {{"curl2", "e(i j2 k2) e(k2 j1 k1) f(k1, j1 j2)"}},
              {{{"curl2", "e(i j2 k2) e(k1 j1 k2) f(k1, j1 j2)"}},
               {{"curl2", "e(i j1 k2) e(k2 k1 j2) f(k1, j1 j2)"}}}),
      t.claim("thrice_nested", 3707, "the third curl: e_ij3k3 d_j3 of the second",
              {{"curl3", "e(i j3 k3) twice(k3, j3)"}}, {{{"curl3", "e(i j3 k3) twice(j3, k3)"}}}),
      t.claim("thrice_factored", 3709, "its three tensors in front of the derivatives",
              {{"curl3", "e(i j3 k3) e(k3 j2 k2) e(k2 j1 k1) f(k1, j1 j2 j3)"}},
              {{{"curl3", "e(i j3 k3) e(k2 j2 k3) e(k2 j1 k1) f(k1, j1 j2 j3)"}},
               {{"curl3", "e(i j3 k3) e(k3 j2 k2) e(k2 j1 k1) f(j1, k1 j2 j3)"}}}),
      t.claim("appended", 3711, "the derivative by x_j3 is one more index behind the comma",
              {{"f along a, b, c", "f(k1, j1 j2 j3) a(j1) b(j2) c(j3)", "k1"}},
              {{{"f along a, b, c", "f(j3, j1 j2 k1) a(j1) b(j2) c(j3)", "k1"}}}),
  };
  std::vector<Said> general, reversed_link, reversed_all, wrong_component, product, reversed_product;
  std::vector<Check> wellformed;
  for (int n = 1; n <= most; ++n) {
    const std::string left = numbered("curl", n), free = numbered("k", n + 1), f = derivative_of_f(n);
    general.push_back({left, chain(n, "i", as_printed) + f});
    reversed_link.push_back({left, chain(n, "i", first_reversed) + f});
    reversed_all.push_back({left, chain(n, "i", reversed) + f});
    wrong_component.push_back({left, chain(n, "i", as_printed) + derivative_of_f(n, "j1", "k1")});
    product.push_back({left, chain(n, free, as_printed) + f, free});
    reversed_product.push_back({left, chain(n, free, reversed) + f, free});
    wellformed.push_back(
        never("an index repeated wrongly", IndexExpression(product.back().right, free).ill_formed(), 1));
  }
  all.push_back(t.claim("general", 3715, "the chain of n tensors, n = 1 to 4", general,
                        {reversed_link, reversed_all, wrong_component}));
  all.push_back(t.claim("product", 3723,
                        "the same as a product over l of e with indices k_(l+1) j_l k_l, n = 1 to 4", product,
                        {reversed_product}));
  all.back().printed.checks.insert(all.back().printed.checks.end(), wellformed.begin(), wellformed.end());
  return all;
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

using Indices = std::array<std::size_t, 2 * most + 1>;

/// f(k1, j1 ... jn): indices are i, then j1 k1, j2 k2 ...
template <int n, int l = 1, class Field, class T>
Triple<T> derivative_along(const Field& f, const Triple<T>& x, const Indices& at) {
  if constexpr (l > n)
    return f(x);
  else
    return derivative_along<n, l + 1>(partial(f, at[2 * l - 1]), x, at);
}

/// The product of the chain's tensors.
template <int n>
double sign_of(const Indices& at) {
  double sign = 1;
  for (std::size_t l = 1; l <= n; ++l)
    sign *= permutation_sign(l == n ? at[0] : at[2 * l + 2], at[2 * l - 1], at[2 * l]);
  return sign;
}

/// The general formula term by term, each with a derivative of its own; terms known to be zero may be left
/// out.
template <int n, class Field>
Answer by_terms(const Field& f, const Point& x, bool zeros_too) {
  Point sum{};
  long calls = 0;
  Indices at{};
  const auto advance = [&] {
    for (std::size_t l = 0; l <= 2 * n; ++l) {
      if (++at[l] < 3) return true;
      at[l] = 0;
    }
    return false;
  };
  do {
    const double sign = sign_of<n>(at);
    if (sign == 0 && !zeros_too) continue;
    sum[at[0]] += sign * derivative_along<n>(f, x, at)[at[2]];
    ++calls;
  } while (advance());
  return {Value(sum), calls};
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
  Quantity q = quantity("curl_" + times, "1/m^" + times, "the curl of plane waves taken " + times + " times",
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
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  Findings findings{claims(Random(p["seed"])), {}};
  for_each_order([&]<int n>() {
    if (n <= p["n"]) findings.quantities.push_back(nth_curl<n>(At(p), truth));
  });
  findings.quantities.back().add(
      Breakdown{"Differences of differences of differences of differences lose $\\varepsilon/h^4$: even the "
                "best step of order 2, "
                "near $\\varepsilon^{1/6}$, has five digits.",
                "repeated curl, central differences 2", 0x1p-9, Outcome::inaccurate,
                "repeated curl, nested dual numbers", 0});
  return findings;
}

}  // namespace

Exercise exercise_5_15() {
  return {"Repeated curl in index notation",
          "Write $(\\nabla\\times)^n\\mathbf f$ with the permutation tensor $e_{ijk}$. Below `e(i j k)` is "
          "the tensor, and "
          "`f(m, j l)` the derivative of $f_m$ by $x_j$ and $x_l$.",
          parameters, false, study};
}

}  // namespace oddity
