// Exercise 5.7: curl (phi f) = phi curl f + grad phi x f.
// Left side: the product is differentiated as one field by dual numbers along a frame turned at random,
// curl h = sum_k u_k x (u_k.grad) h, which has none of the proof's index lists. Right side: each published
// line read as it is printed, from partial derivatives along the axes. The quantity's reference
// differentiates the product in 60 digits by extrapolated differences and by Cauchy's integral.

#include "chapters/05_fluids_and_gases/differentiation.hpp"
#include "chapters/05_fluids_and_gases/proof.hpp"

namespace oddity {

namespace {

using namespace fields;

constexpr Parameter parameters[] = {
    {"w", 1, "1/m", "wave number of the fields", 0.0625, 16},
    {"x0", 0.3, "m", "where the curl is taken", -1, 1},
    {"x1", -0.7, "m", "where the curl is taken", -1, 1},
    {"x2", 0.9, "m", "where the curl is taken", -1, 1},
    {"seed", 57, "", "of the random fields", 0, 9e15},
};

std::vector<Sample> samples(Random random) {
  std::vector<Sample> all;
  for (int n = 0; n < 64; ++n) {
    const ScalarField phi(random, random.magnitude(1e-6, 1e6), random.magnitude(0.01, 10));
    const VectorField f(random, random.magnitude(1e-6, 1e6), random.magnitude(0.01, 10));
    const Point x = random.point();
    Sample s(place(n, x));
    s.put("curl_phi_f", curl(times(phi, f), random_frame(random))(x));
    s.put_scalar("phi", phi, x);
    s.put_vector("f", f, x);
    s.put_vector("phi_f", times(phi, f), x);
    s.put("curl_f", curl(f, random_frame(random))(x));
    s.put("grad_phi", gradient(phi, random_frame(random))(x));
    s.put("grad_phi_x_f", cross(gradient(phi, random_frame(random))(x), f(x)));
    all.push_back(std::move(s));
  }
  return all;
}

std::vector<Claim> claims(const std::vector<Sample>& s) {
  const std::string whole = "phi f differentiated as one field along a turned frame";
  const std::string parts = "curl f and grad phi along turned frames";
  std::vector<Claim> all;
  const auto component = [&](const std::string& step, char i, int line, const std::string& says,
                             const std::string& right) {
    all.push_back(published("5.7-" + step + "_" + i, line, says + ", component " + i, s,
                            {{std::string("curl_phi_f") + i, right}}, whole));
  };
  component("definition", '0', 3305, "the curl of the product in coordinates", "phi_f2,1 - phi_f1,2");
  component("definition", '1', 3309, "the curl of the product in coordinates", "phi_f0,2 - phi_f2,0");
  component("definition", '2', 3311, "the curl of the product in coordinates", "phi_f1,0 - phi_f0,1");
  const std::string rule = "every derivative of a product has two terms";
  component("product_rule", '0', 3317, rule, "phi f2,1 + phi,1 f2 - phi f1,2 - phi,2 f1");
  component("product_rule", '1', 3323, rule, "phi f0,2 + phi,2 f0 - phi f2,0 - phi,0 f2");
  component("product_rule", '2', 3331, rule, "phi f1,0 + phi,0 f1 - phi f0,1 - phi,1 f0");
  const std::string gathered = "the terms gathered into two vectors";
  component("gathered", '0', 3343, gathered, "phi (f2,1 - f1,2) + (phi,1 f2 - phi,2 f1)");
  component("gathered", '1', 3345, gathered, "phi (f0,2 - f2,0) + (phi,2 f0 - phi,0 f2)");
  component("gathered", '2', 3349, gathered, "phi (f1,0 - f0,1) + (phi,0 f1 - phi,1 f0)");

  all.push_back(published("5.7-first_vector", 3343, "the first of the two vectors, times phi, is phi curl f",
                          s,
                          {{"phi curl_f0", "phi (f2,1 - f1,2)"},
                           {"phi curl_f1", "phi (f0,2 - f2,0)"},
                           {"phi curl_f2", "phi (f1,0 - f0,1)"}},
                          parts));
  all.push_back(published("5.7-second_vector", 3353, "the second of the two vectors is grad phi x f", s,
                          {{"grad_phi_x_f0", "phi,1 f2 - phi,2 f1"},
                           {"grad_phi_x_f1", "phi,2 f0 - phi,0 f2"},
                           {"grad_phi_x_f2", "phi,0 f1 - phi,1 f0"}},
                          parts));
  all.push_back(published("5.7-identity", 3367, "curl (phi f) = phi curl f + grad phi x f", s,
                          {{"curl_phi_f0", "phi curl_f0 + grad_phi_x_f0"},
                           {"curl_phi_f1", "phi curl_f1 + grad_phi_x_f1"},
                           {"curl_phi_f2", "phi curl_f2 + grad_phi_x_f2"}},
                          whole));
  return all;
}

Quantity curl_of_product(const Parameters& p, const Reference& truth) {
  const Waves waves{p["w"]};
  const Point x{p["x0"], p["x1"], p["x2"]};
  const Known known = truth("05_07_curl", {p["w"], x[0], x[1], x[2]});
  const auto phi = [waves](const auto& y) { return waves.phi(y); };
  const auto f = [waves](const auto& y) { return waves.f(y); };
  Quantity q = quantity("curl_of_product", "1", "curl (phi f) at x, for two fields of wave number w", known,
                        nine_digits(known.value));
  add_ways(q, "product as one field", 2, [=](auto& way) { return curl_by(way, times(phi, f), x); });
  add_ways(q, "phi curl f + grad phi x f", 1, [=](auto& way) {
    const double factor = phi(x);
    const Point curl_f = curl_by(way, f, x), turned = cross(gradient_by(way, phi, x), f(x));
    way.calls += 2;
    return detail::combined(factor, curl_f, 1, turned);
  });
  add_breakdowns(q, "product as one field");
  return q;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(samples(Random(p["seed"]))), {curl_of_product(p, truth)}};
}

}  // namespace

Exercise exercise_5_7() {
  return {"Curl of a scalar times a vector",
          "Show that $\\nabla\\times(\\varphi\\mathbf f) = \\varphi\\,\\nabla\\times\\mathbf f + "
          "\\nabla\\varphi\\times\\mathbf f$. Below `f2,1` is the derivative of $f_2$ by $x_1$.",
          parameters, false, study};
}

}  // namespace oddity
