// Every index expression as printed, evaluated from derivatives along the axes, and compared with curls
// nested by dual numbers along a randomly rotated frame.
#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <set>

#include "chapters/05_fluids_and_gases/15_repeated_curl/lines.hpp"
#include "chapters/05_fluids_and_gases/15_repeated_curl/repeated_curl.hpp"
#include "reference/text.hpp"

namespace oddity::ex05_15 {

namespace {

using namespace fields;

struct Sampled {
  std::string where;
  Tensors<double> tensors;
  std::map<std::string, Point> left;
};

/// The field that an index expression of f's derivatives of one order defines.
template <int order, class Field>
auto contracted(const Field& f, const IndexExpression& expression) {
  return [f, expression]<class T>(const Triple<T>& x) {
    Tensors<T> tensors;
    put_permutation_tensor(tensors);
    tensors[{"f", order + 1}] = derivatives<order>(f, x);
    return expression.value(tensors);
  };
}

Sampled sample(Random& random, int number) {
  const ScalarField phi(random, 1, 1);
  const double rate = random.magnitude(0.1, 3), size = random.magnitude(1e-6, 1e6);
  const VectorField f(random, size, rate);
  const VectorField g(random, random.magnitude(1e-6, 1e6), 1);
  const Point x = random.point(), a = random.point(), b = random.point(), c = random.point();
  const Frame r = random_frame(random), mirror{r[1], r[0], r[2]};
  const Point of_f = f(x), of_g = g(x);
  Sampled s{"draw " + std::to_string(number) + " at (" + format_shortest(x[0]) + ", " +
                format_shortest(x[1]) + ", " + format_shortest(x[2]) + ")",
            {},
            {}};
  put_permutation_tensor(s.tensors);
  const std::map<std::string, Point> vectors{{"a", a},    {"u", turned(r, of_g)},
                                             {"b", b},    {"v", turned(r, of_f)},
                                             {"c", c},    {"mirrored_u", turned(mirror, of_g)},
                                             {"f", of_f}, {"mirrored_v", turned(mirror, of_f)},
                                             {"g", of_g}};
  for (const auto& [name, v] : vectors) s.tensors[{name, 1}] = {v.begin(), v.end()};
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

  using Vector = Eigen::Map<const Eigen::Vector3d>;
  Eigen::Map<Eigen::Vector3d>(s.left["g x f"].data()) = Vector(of_g.data()).cross(Vector(of_f.data()));
  s.left["g x f, turned"] = turned(r, s.left["g x f"]);
  s.left["g x f, mirrored"] = turned(mirror, s.left["g x f"]);
  s.left["curl2, turned"] = turned(r, s.left["curl2"]);
  s.left["curl1 along a"] = along(repeated_curl<1>(f, r), x, a);
  s.left["phi curl1 along a"] = combined(phi(x), s.left["curl1 along a"], 0, a);
  const auto along_a = [f, a](const auto& y) { return along(f, y, a); };
  const auto along_b = [along_a, b](const auto& y) { return along(along_a, y, b); };
  s.left["f along a, b, c"] = along(along_b, x, c);
  return s;
}

/// "k1" as k_1.
std::string typeset_index(const std::string& index) {
  return index.size() < 2 ? index : index.substr(0, 1) + "_" + index.substr(1);
}

/// "e(i j k) f(k, j)" as e_{ijk}f_{k,j}, without the dollars.
std::string typeset(const std::string& expression) {
  static const std::map<std::string, std::string> names{{"once", R"((\nabla\times\mathbf f))"},
                                                        {"twice", R"(((\nabla\times)^2\mathbf f))"},
                                                        {"phi_once", R"((\varphi\nabla\times\mathbf f))"},
                                                        {"mirrored_u", R"(\bar u)"},
                                                        {"mirrored_v", R"(\bar v)"}};
  std::string tex, word;
  for (char c : expression) {
    if (std::isalnum(c) || c == '_') {
      word += c;
      continue;
    }
    if (c == '(')
      tex += (names.contains(word) ? names.at(word) : word) + "_{";
    else
      tex += typeset_index(word) + (c == ')' ? "}" : c == ',' ? "," : "");
    word.clear();
  }
  return tex;
}

/// The left side, including its free index.
std::string typeset_left(const Said& said) {
  static const std::map<std::string, std::string> names{
      {"g x f", R"((\mathbf g\times\mathbf f))"},
      {"g x f, turned", R"((\mathbf g\times\mathbf f)')"},
      {"g x f, mirrored", R"(\overline{(\mathbf g\times\mathbf f)})"},
      {"curl1", R"((\nabla\times\mathbf f))"},
      {"curl2", R"(((\nabla\times)^2\mathbf f))"},
      {"curl3", R"(((\nabla\times)^3\mathbf f))"},
      {"curl4", R"(((\nabla\times)^4\mathbf f))"},
      {"curl2, turned", R"(((\nabla\times)^2\mathbf f)')"},
      {"curl1 along a", R"(((\mathbf a\cdot\nabla)(\nabla\times\mathbf f)))"},
      {"phi curl1 along a", R"((\varphi(\mathbf a\cdot\nabla)(\nabla\times\mathbf f)))"},
      {"f along a, b, c",
       R"(((\mathbf a\cdot\nabla)(\mathbf b\cdot\nabla)(\mathbf c\cdot\nabla)\mathbf f))"}};
  return names.at(said.left) + "_{" + typeset_index(said.free) + "}";
}

/// Description of how the left side is computed.
std::string route_to(const Said& said) {
  if (said.left.starts_with("g x f")) return "Eigen's cross product";
  if (said.left.starts_with("f along")) return "derivatives along given vectors, by nested dual numbers";
  return "curls along a turned frame, by dual numbers";
}

/// Letters of the components: f_{0,12}.
TypesetLetters letters_of(const Tensors<double>& tensors) {
  TypesetLetters letters;
  for (const auto& [tensor, components] : tensors)
    for (std::size_t n = 0; n < components.size(); ++n) {
      const auto& [name, rank] = tensor;
      std::string indices;
      for (std::size_t k = 0, rest = n; k < rank; ++k, rest /= 3)
        indices.insert(0, " " + std::to_string(rest % 3));
      if (rank > 1 && name != "e") indices.insert(2, ",");
      letters.emplace_back(typeset(name + "(" + indices.substr(1) + ")"), components[n]);
    }
  return letters;
}

struct Tensorial {
  std::vector<Sampled> samples = {};

  explicit Tensorial(Random random) {
    for (int n = 0; n < 12; ++n) samples.push_back(sample(random, n));
  }

  Check compare(const Said& said) const {
    const IndexExpression expression(said.right, said.free);
    WorstSample worst("$" + typeset_left(said) + "$", "the index expression as it is written",
                      route_to(said));
    for (const Sampled& s : samples)
      worst.add(expression.value(s.tensors), s.left.at(said.left), expression.size(s.tensors), s.where);
    return worst.check();
  }
  /// Compares the typeset right side with the values at the first draws.
  bool is_right_side_as_typeset(const Said& said) const {
    const IndexExpression expression(said.right, said.free);
    std::vector<std::pair<TypesetLetters, Value>> computed;
    for (const Sampled& s : {samples[0], samples[1]})
      computed.emplace_back(letters_of(s.tensors), expression.value(s.tensors));
    return is_as_typeset(compare_typeset("$" + typeset(said.right) + "$", computed));
  }
  Reading reading(const std::vector<Said>& all) const {
    Reading reading;
    for (const Said& said : all) {
      reading.text +=
          (reading.text.empty() ? "$" : ", $") + typeset_left(said) + "=" + typeset(said.right) + "$";
      reading.checks.push_back(compare(said));
    }
    reading.as_typeset = all.size() == 1 && is_right_side_as_typeset(all[0]);
    return reading;
  }
  Claim claim(const std::vector<Said>& printed, const std::vector<std::vector<Said>>& near_misses) const {
    Claim claim{.printed = reading(printed)};
    for (const auto& near : near_misses) claim.near_misses.push_back(reading(near));
    return claim;
  }
};

/// Claims that the indices that occur `times` times in the expression are exactly these.
Claim occurring(int times, const std::set<std::string>& these, const std::string& expression,
                const std::string& near) {
  const auto reading = [&](const std::string& text) {
    const std::set<std::string> found = IndexExpression(text, "i").occurring(times);
    std::vector<std::string> others;
    std::ranges::set_symmetric_difference(these, found, std::back_inserter(others));
    const std::string how_often = times == 1 ? "once" : "twice";
    return Reading{
        "the indices of $" + typeset(text) + "$ that occur " + how_often,
        {no_violations("indices that are named and do not occur " + how_often + ", or the other way round",
                       static_cast<long>(others.size()), static_cast<long>(these.size()))}};
  };
  return {.printed = reading(expression), .near_misses = {reading(near)}};
}

}  // namespace

Lines lines(Random random) {
  const Tensorial t(random);
  Lines all;
  Claims& claims = all.claims;
  const auto add = [&](const char* slug, int line, const char* says, const std::vector<Said>& printed,
                       const std::vector<std::vector<Said>>& near_misses) {
    std::string sentence = says;
    Claim claim = t.claim(printed, near_misses);
    if (printed.size() == 1 && sentence.find('=') == std::string::npos) sentence += ": " + claim.printed.text;
    claims.add(slug, line, std::move(sentence), std::move(claim));
    all.printed.emplace_back(slug, printed);
  };
  add("cross_product", 3687, "the cross product in index notation", {{"g x f", "e(i j k) g(j) f(k)"}},
      {{{"g x f", "e(i j k) g(k) f(j)"}}, {{"g x f", "e(j i k) g(j) f(k)"}}});
  const std::string product_of_two = "e(i j k) g(j) f(k)", product_near = "e(i j k) g(j) f(j)";
  claims.add("cross_product_sums", 3689,
             "in $e_{ijk}g_jf_k$ the repeated indices $j$ and $k$ are summed over",
             occurring(2, {"j", "k"}, product_of_two, product_near));
  claims.add("cross_product_free", 3689, "in $e_{ijk}g_jf_k$ the only free index is $i$",
             occurring(1, {"i"}, product_of_two, product_near));
  add("cross_product_vector", 3689,
      R"(with $i$ free it is a vector (our check, as the text does for the second curl: it turns with its )"
      R"(factors, $u$ and $v$ in the turned frame))",
      {{"g x f, turned", "e(i j k) u(j) v(k)"}},
      {{{"g x f, mirrored", "e(i j k) mirrored_u(j) mirrored_v(k)"}}});
  add("curl", 3691, "the curl in index notation", {{"curl1", "e(i j k) f(k, j)"}},
      {{{"curl1", "e(i j k) f(j, k)"}}, {{"curl1", "e(k j i) f(k, j)"}}});
  add("twice_nested", 3695, R"(the curl of the curl is $e_{ijk}\,\partial_j(e_{klm}\,\partial_lf_m)$)",
      {{"curl2", "e(i j k) once(k, j)"}}, {{{"curl2", "e(i j k) once(j, k)"}}});
  add("twice_factored", 3695, R"(the curl of the curl is $e_{ijk}e_{klm}\,\partial_j\partial_lf_m$)",
      {{"curl2", "e(i j k) e(k l m) f(m, l j)"}},
      {{{"curl2", "e(i j k) e(l k m) f(m, l j)"}}, {{"curl2", "e(i j k) e(j l m) f(m, l k)"}}});
  add("twice_comma", 3695, "the curl of the curl with a comma for the derivatives",
      {{"curl2", "e(i j k) e(k l m) f(m, j l)"}},
      {{{"curl2", "e(i j k) e(k l m) f(j, m l)"}}, {{"curl2", "e(i j k) e(k l m) f(l, j m)"}}});
  add("constant", 3697,
      R"(the permutation tensor is constant and moves out of the derivative: $\partial_j(e_{klm}\,\partial_lf_m)=e_{klm}\,\partial_j\partial_lf_m$)",
      {{"curl1 along a", "e(k l m) f(m, l j) a(j)", "k"}},
      {{{"phi curl1 along a", "phi_once(k, j) a(j)", "k"}}});
  const std::string curl_of_curl = "e(i j k) e(k l m) f(m, j l)", curl_near = "e(i j k) e(k l m) f(m, j j)";
  claims.add("twice_sums", 3697,
             "in $e_{ijk}e_{klm}f_{m,jl}$ the repeated indices $j$, $k$, $l$ and $m$ are summed over",
             occurring(2, {"j", "k", "l", "m"}, curl_of_curl, curl_near));
  claims.add("twice_free", 3697, "in $e_{ijk}e_{klm}f_{m,jl}$ the only free index is $i$",
             occurring(1, {"i"}, curl_of_curl, curl_near));
  add("twice_vector", 3697,
      R"(with $i$ free it is a vector: it turns with the field, which is $v$ in the turned frame)",
      {{"curl2, turned", "e(i j k) e(k l m) v(m, j l)"}}, {{{"curl2", "e(i j k) e(k l m) v(m, j l)"}}});
  add("renamed_once", 3701, "the curl in the new names", {{"curl1", "e(i j1 k1) f(k1, j1)"}},
      {{{"curl1", "e(i k1 j1) f(k1, j1)"}}});
  add("renamed_twice", 3703, "the curl of the curl in the new names",
      {{"curl2", "e(i j2 k2) e(k2 j1 k1) f(k1, j1 j2)"}},
      {{{"curl2", "e(i j2 k2) e(k1 j1 k2) f(k1, j1 j2)"}},
       {{"curl2", "e(i j1 k2) e(k2 k1 j2) f(k1, j1 j2)"}}});
  add("thrice_nested", 3707, "the third curl is the curl of the second",
      {{"curl3", "e(i j3 k3) twice(k3, j3)"}}, {{{"curl3", "e(i j3 k3) twice(j3, k3)"}}});
  add("thrice_factored", 3709, "the third curl has its three tensors in front of the derivatives",
      {{"curl3", "e(i j3 k3) e(k3 j2 k2) e(k2 j1 k1) f(k1, j1 j2 j3)"}},
      {{{"curl3", "e(i j3 k3) e(k2 j2 k3) e(k2 j1 k1) f(k1, j1 j2 j3)"}},
       {{"curl3", "e(i j3 k3) e(k3 j2 k2) e(k2 j1 k1) f(j1, k1 j2 j3)"}}});
  add("appended", 3711,
      R"(the derivative by $x_{j_3}$ adds an index behind the comma: $\partial_{j_3}f_{k_1,j_1j_2}=f_{k_1,j_1j_2j_3}$)",
      {{"f along a, b, c", "f(k1, j1 j2 j3) a(j1) b(j2) c(j3)", "k1"}},
      {{{"f along a, b, c", "f(j3, j1 j2 k1) a(j1) b(j2) c(j3)", "k1"}}});

  std::vector<Said> general, reversed_link, wrong_component, product, reversed_product;
  std::vector<Check> wellformed;
  for (int n = 1; n <= most_curls; ++n) {
    const std::string left = numbered("curl", n), free = numbered("k", n + 1), f = derivative_of_f(n);
    general.push_back({left, chain(n, "i", as_printed) + f});
    reversed_link.push_back({left, chain(n, "i", first_reversed) + f});
    wrong_component.push_back({left, chain(n, "i", as_printed) + derivative_of_f(n, "j1", "k1")});
    product.push_back({left, chain(n, free, as_printed) + f, free});
    reversed_product.push_back({left, chain(n, free, reversed) + f, free});
    wellformed.push_back(no_violations("indices that occur once or thrice, but the free one",
                                       IndexExpression(product.back().right, free).ill_formed(), 1));
  }
  add("general", 3715,
      R"($((\nabla\times)^n\mathbf f)_i=e_{ij_nk_n}e_{k_nj_{n-1}k_{n-1}}\cdots e_{k_2j_1k_1}f_{k_1,j_1\cdots j_n}$ )"
      R"((our check: for $n=1,\ldots,4$))",
      general, {reversed_link, wrong_component});
  Claim same = t.claim(product, {reversed_product});
  same.printed.checks.insert(same.printed.checks.end(), wellformed.begin(), wellformed.end());
  claims.add(
      "product", 3723,
      R"($c_{k_{n+1}}=(\prod_{l=1}^ne_{k_{l+1}j_lk_l})f_{k_1,j_1\cdots j_n}$ for $\mathbf c=(\nabla\times)^n\mathbf f$ )"
      R"((our check: for $n=1,\ldots,4$))",
      std::move(same));
  all.printed.emplace_back("product", product);
  return all;
}

std::vector<Claim> claims(const Random& random) { return lines(random).claims.in_order(); }

}  // namespace oddity::ex05_15
