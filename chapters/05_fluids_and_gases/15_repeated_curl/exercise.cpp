// Exercise 5.15: the curl applied n times, by the permutation tensor e:
//   ((curl)^n f)_i = e(i jn kn) e(kn j(n-1) k(n-1)) ... e(k2 j1 k1) f(k1, j1 ... jn)
// Every published index expression is evaluated as it is written, from derivatives along the axes, and
// compared with curls nested in one another by dual numbers along a frame turned at random. The quantity's
// reference is the closed form for plane waves, whose curl is k x p cos.

#include "chapters/05_fluids_and_gases/15_repeated_curl/tensor_proof.hpp"

namespace oddity {

namespace ex05_15 {

using namespace fields;

constexpr auto parameters = [] {
  std::array<Parameter, 6> all{
      {{"n", most_curls, "", "how often the curl is applied, at most", 1, most_curls}}};
  for (std::size_t i = 0; i < 5; ++i) all[1 + i] = field_parameters[i];
  return all;
}();

std::vector<Claim> claims(Random random) {
  const Tensorial t(random);
  Claims claims("5.15");
  const auto add = [&](const char* slug, int line, const char* says, const std::vector<Said>& printed,
                       const std::vector<std::vector<Said>>& near_misses) {
    claims.add(slug, line, says, t.claim(printed, near_misses));
  };
  add("cross_product", 3687, R"($\mathbf g\times\mathbf f$ in index notation)",
      {{"g x f", "e(i j k) g(j) f(k)"}},
      {{{"g x f", "e(i j k) g(k) f(j)"}}, {{"g x f", "e(j i k) g(j) f(k)"}}});
  claims.add("cross_product_sums", 3689, "$j$ and $k$ are summed over, $i$ is the only free index",
             summed("e(i j k) g(j) f(k)", "e(i j k) g(j) f(j)"));
  add("cross_product_vector", 3689,
      R"(with $i$ free it is a vector: it turns with its factors, which are $u$ and $v$ in the turned frame)",
      {{"g x f, turned", "e(i j k) u(j) v(k)"}},
      {{{"g x f, mirrored", "e(i j k) mirrored_u(j) mirrored_v(k)"}}});
  add("curl", 3691, R"($\nabla\times\mathbf f$ in index notation)", {{"curl1", "e(i j k) f(k, j)"}},
      {{{"curl1", "e(i j k) f(j, k)"}}, {{"curl1", "e(k j i) f(k, j)"}}});
  add("twice_nested", 3695,
      R"($\nabla\times\nabla\times\mathbf f$ is $e_{ijk}\,\partial_j(e_{klm}\,\partial_lf_m)$)",
      {{"curl2", "e(i j k) once(k, j)"}}, {{{"curl2", "e(i j k) once(j, k)"}}});
  add("twice_factored", 3695, R"(that is $e_{ijk}e_{klm}\,\partial_j\partial_lf_m$)",
      {{"curl2", "e(i j k) e(k l m) f(m, l j)"}},
      {{{"curl2", "e(i j k) e(l k m) f(m, l j)"}}, {{"curl2", "e(i j k) e(j l m) f(m, l k)"}}});
  add("twice_comma", 3695, "the same with a comma for the derivatives",
      {{"curl2", "e(i j k) e(k l m) f(m, j l)"}},
      {{{"curl2", "e(i j k) e(k l m) f(j, m l)"}}, {{"curl2", "e(i j k) e(k l m) f(l, j m)"}}});
  add("constant", 3697, "$e$, being constant, moves out of the derivative",
      {{"curl2", "e(i j k) e(k l m) f(m, l j)"}, {"curl2", "e(i j k) once(k, j)"}},
      {{{"phi curl2", "e(i j k) phi_once(k, j)"}}});
  claims.add("twice_sums", 3697, "$j$, $k$, $l$ and $m$ are summed over, $i$ is the only free index",
             summed("e(i j k) e(k l m) f(m, j l)", "e(i j k) e(k l m) f(m, j j)"));
  add("twice_vector", 3697,
      R"(with $i$ free it is a vector: it turns with the field, which is $v$ in the turned frame)",
      {{"curl2, turned", "e(i j k) e(k l m) v(m, j l)"}}, {{{"curl2", "e(i j k) e(k l m) v(m, j l)"}}});
  add("comma", 3697,
      R"($f_{m,jl}$ is the derivative of the component $f_m$ by $x_j$ and $x_l$: below along any $\mathbf a$, $\mathbf b$)",
      {{"f along a, b", "f(m, j l) a(j) b(l)", "m"}}, {{{"f along a, b", "f(j, m l) a(j) b(l)", "m"}}});
  add("renamed_once", 3701, R"($\nabla\times\mathbf f$ in the new names)",
      {{"curl1", "e(i j1 k1) f(k1, j1)"}}, {{{"curl1", "e(i k1 j1) f(k1, j1)"}}});
  add("renamed_twice", 3703, R"($\nabla\times\nabla\times\mathbf f$ in the new names)",
      {{"curl2", "e(i j2 k2) e(k2 j1 k1) f(k1, j1 j2)"}},
      {{{"curl2", "e(i j2 k2) e(k1 j1 k2) f(k1, j1 j2)"}},
       {{"curl2", "e(i j1 k2) e(k2 k1 j2) f(k1, j1 j2)"}}});
  add("thrice_nested", 3707, "the third curl is one of the second", {{"curl3", "e(i j3 k3) twice(k3, j3)"}},
      {{{"curl3", "e(i j3 k3) twice(j3, k3)"}}});
  add("thrice_factored", 3709, "its three tensors in front of the derivatives",
      {{"curl3", "e(i j3 k3) e(k3 j2 k2) e(k2 j1 k1) f(k1, j1 j2 j3)"}},
      {{{"curl3", "e(i j3 k3) e(k2 j2 k3) e(k2 j1 k1) f(k1, j1 j2 j3)"}},
       {{"curl3", "e(i j3 k3) e(k3 j2 k2) e(k2 j1 k1) f(j1, k1 j2 j3)"}}});
  add("appended", 3711,
      R"(the derivative by $x_{j_3}$ is one more index behind the comma: below along any $\mathbf a$, $\mathbf b$, $\mathbf c$)",
      {{"f along a, b, c", "f(k1, j1 j2 j3) a(j1) b(j2) c(j3)", "k1"}},
      {{{"f along a, b, c", "f(j3, j1 j2 k1) a(j1) b(j2) c(j3)", "k1"}}});

  std::vector<Said> general, reversed_link, reversed_all, wrong_component, product, reversed_product;
  std::vector<Check> wellformed;
  for (int n = 1; n <= most_curls; ++n) {
    const std::string left = numbered("curl", n), free = numbered("k", n + 1), f = derivative_of_f(n);
    general.push_back({left, chain(n, "i", as_printed) + f});
    reversed_link.push_back({left, chain(n, "i", first_reversed) + f});
    reversed_all.push_back({left, chain(n, "i", reversed) + f});
    wrong_component.push_back({left, chain(n, "i", as_printed) + derivative_of_f(n, "j1", "k1")});
    product.push_back({left, chain(n, free, as_printed) + f, free});
    reversed_product.push_back({left, chain(n, free, reversed) + f, free});
    wellformed.push_back(well_formed(product.back().right, free));
  }
  add("general", 3715, R"(the chain of $n$ tensors, $n=1,\ldots,4$)", general,
      {reversed_link, reversed_all, wrong_component});
  Claim same = t.claim(product, {reversed_product});
  same.printed.checks.insert(same.printed.checks.end(), wellformed.begin(), wellformed.end());
  claims.add("product", 3723, R"(the same as a product over $l$ of $e_{k_{l+1}j_lk_l}$, $n=1,\ldots,4$)",
             std::move(same));
  return claims.in_order();
}

Findings study(const Parameters& p, const Reference& truth) {
  Findings findings{claims(Random(p["seed"])), {}};
  for_each_order([&]<int n>() {
    if (n <= p["n"]) findings.quantities.push_back(nth_curl<n>(At(p), truth));
  });
  return findings;
}

}  // namespace ex05_15

Exercise exercise_5_15() {
  using namespace ex05_15;
  return {
      "Repeated curl in index notation",
      "Write $(\\nabla\\times)^n\\mathbf f$ with the permutation tensor $e_{ijk}$. Below $f_{m,jl}$ is the "
      "derivative of $f_m$ by $x_j$ and $x_l$.",
      parameters,
      {},
      study};
}

}  // namespace oddity
