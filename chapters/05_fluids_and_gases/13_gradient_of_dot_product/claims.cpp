// The claims of exercise 5.13: published components, and their sum as an expression, term by term.

#include <algorithm>
#include <map>

#include "chapters/05_fluids_and_gases/13_gradient_of_dot_product/gradient_of_dot_product.hpp"
#include "chapters/05_fluids_and_gases/shared/meanings.hpp"

namespace oddity::ex05_13 {

namespace {

using namespace fields;

using Components = std::array<std::string, 3>;

// clang-format off
const Components left_8{"f0,0 g0 + f0 g0,0 + f1,0 g1 + f1 g1,0 + f2,0 g2 + f2 g2,0",
                        "f0,1 g0 + f0 g0,1 + f1,1 g1 + f1 g1,1 + f2,1 g2 + f2 g2,1",
                        "f0,2 g0 + f0 g0,2 + f1,2 g1 + f1 g1,2 + f2,2 g2 + f2 g2,2"};
const Components first_9{"f1 (g1,0 - g0,1) - f2 (g0,2 - g2,0)",
                         "f2 (g2,1 - g1,2) - f0 (g1,0 - g0,1)",
                         "f0 (g0,2 - g2,0) - f1 (g2,1 - g1,2)"};
const Components second_10{"g1 (f1,0 - f0,1) - g2 (f0,2 - f2,0)",
                           "g2 (f2,1 - f1,2) - g0 (f1,0 - f0,1)",
                           "g0 (f0,2 - f2,0) - g1 (f2,1 - f1,2)"};
const Components third_11{"f0 g0,0 + f1 g0,1 + f2 g0,2",
                          "f0 g1,0 + f1 g1,1 + f2 g1,2",
                          "f0 g2,0 + f1 g2,1 + f2 g2,2"};
const Components fourth_12{"g0 f0,0 + g1 f0,1 + g2 f0,2",
                           "g0 f1,0 + g1 f1,1 + g2 f1,2",
                           "g0 f2,0 + g1 f2,1 + g2 f2,2"};
// clang-format on

void fill(Sample& s, const Drawn& d) {
  s.put("grad_fg", gradient(dot_product(d.f, d.g), d.frame)(d.x));
  s.put("f_x_curl_g", cross(d.f(d.x), curl(d.g, d.frame)(d.x)));
  s.put("g_x_curl_f", cross(d.g(d.x), curl(d.f, d.frame)(d.x)));
  s.put("fgrad_g", advected(d.f, d.g, d.frame)(d.x));
  s.put("ggrad_f", advected(d.g, d.f, d.frame)(d.x));
  s.put_vector("f", d.f, d.x);
  s.put_vector("g", d.g, d.x);
}

/// A line as a polynomial: the coefficient of each product of symbols, without zeros.
std::map<std::vector<std::size_t>, double> polynomial(const std::string& line, const Sample& symbols) {
  std::map<std::vector<std::size_t>, double> counts;
  for (Term& t : read_terms(line, symbols)) {
    std::ranges::sort(t.factors);
    counts[t.factors] += t.sign;
  }
  std::erase_if(counts, [](const auto& entry) { return entry.second == 0; });
  return counts;
}

/// Compares terms that cancel, and the sum as an expression, component by component and without numbers.
std::vector<Check> cancellation(const Sample& symbols, bool with_fourth) {
  long differing = 0;
  Value cancelled{0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string sum =
        first_9[i] + " + " + second_10[i] + " + " + third_11[i] + (with_fourth ? " + " + fourth_12[i] : "");
    const auto left = polynomial(sum, symbols), right = polynomial(left_8[i], symbols);
    differing += left != right;
    cancelled[i] = static_cast<double>(read_terms(sum, symbols).size() - left.size());
  }
  return {
      no_violations("components in which the sum of (9) to (12) is another polynomial than (8)", differing,
                    3),
      {"terms that cancel in each component", {"counted", cancelled}, {"$14-6$", Value{8, 8, 8}}, exact()}};
}

const Names names{{"grad_fg", R"((\nabla(\mathbf f\cdot\mathbf g)))"},
                  {"f_x_curl_g", R"((\mathbf f\times(\nabla\times\mathbf g)))"},
                  {"g_x_curl_f", R"((\mathbf g\times(\nabla\times\mathbf f)))"},
                  {"fgrad_g", R"(((\mathbf f\cdot\nabla)\mathbf g))"},
                  {"ggrad_f", R"(((\mathbf g\cdot\nabla)\mathbf f))"}};

Proof proof_of_lines(Random random) {
  Proof proof("5.13", sampled(random, fill), names);
  const auto components = [&](const std::string& slug, std::array<int, 3> at, const std::string& says,
                              const std::string& left, const Components& right, const std::string& by) {
    for (std::size_t i = 0; i < 3; ++i)
      proof.line(slug + "_" + digit(i), at[i], "component " + digit(i) + " of " + says,
                 {{left + digit(i), right[i]}}, by);
  };
  components(
      "gradient", {3481, 3495, 3509}, "the left-hand side, equation (8)", "grad_fg", left_8,
      R"($\mathbf f\cdot\mathbf g$ differentiated as one field along a turned frame, by dual numbers)");
  const std::string turned = "the operator along a turned frame, by dual numbers";
  components("first_term", {3529, 3543, 3557}, "the first term, equation (9)", "f_x_curl_g", first_9, turned);
  components("second_term", {3577, 3591, 3605}, "the second term, equation (10)", "g_x_curl_f", second_10,
             turned);
  components("third_term", {3625, 3633, 3641}, "the third term, equation (11)", "fgrad_g", third_11, turned);
  components("fourth_term", {3655, 3663, 3671}, "the fourth term, equation (12)", "ggrad_f", fourth_12,
             turned);

  proof.line(
      "sum", 3681,
      R"($\nabla(\mathbf f\cdot\mathbf g)=\mathbf f\times(\nabla\times\mathbf g)+\mathbf g\times(\nabla\times\mathbf f))"
      R"(+(\mathbf f\cdot\nabla)\mathbf g+(\mathbf g\cdot\nabla)\mathbf f$: the four terms add up to equation (8))",
      each_component("grad_fg#", "f_x_curl_g# + g_x_curl_f# + fgrad_g# + ggrad_f#"),
      R"($\mathbf f\cdot\mathbf g$ differentiated as one field along a turned frame, by dual numbers)");
  proof.claims.add(
      "cancellation", 3681, "in the sum of the equations (9) to (12) quite a few terms cancel",
      {.printed = {"8 of 14 terms cancel in each component", cancellation(proof.samples[0], true)},
       .near_misses = {{"without the fourth term", cancellation(proof.samples[0], false)}}});
  return proof;
}

}  // namespace

std::vector<Claim> claims(const Random& random) { return proof_of_lines(random).claims.in_order(); }

Provables proofs() {
  Meanings m;
  const CoqVector f = m.any_vector("f"), g = m.any_vector("g");
  m.put("grad_fg", gradient(dot(f, g)));
  m.put("f_x_curl_g", cross(f, curl(g)));
  m.put("g_x_curl_f", cross(g, curl(f)));
  m.put("fgrad_g", advected(f, g));
  m.put("ggrad_f", advected(g, f));
  m.put_vector("f", f);
  m.put_vector("g", g);
  return m.proofs("5.13", proof_of_lines(Random(1)));
}

}  // namespace oddity::ex05_13
