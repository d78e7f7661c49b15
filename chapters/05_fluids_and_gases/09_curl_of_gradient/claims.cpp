// The claims of exercise 5.9: published components, by the pattern of indices and by nested dual numbers.

#include "chapters/05_fluids_and_gases/09_curl_of_gradient/curl_of_gradient.hpp"
#include "chapters/05_fluids_and_gases/shared/meanings.hpp"
#include "chapters/05_fluids_and_gases/shared/smooth_fields.hpp"
#include "reference/reference.hpp"

namespace oddity::ex05_09 {

namespace {

using namespace fields;

/// The derivative of phi along u, then along v.
template <class T>
double second(const ScalarField& phi, const Triple<T>& x, const Point& u, const Point& v) {
  return along([&](const auto& y) { return along(phi, y, u); }, x, v);
}

void fill(Sample& s, const Drawn& d) {
  double size = 0;
  for (const Point& u : axes) size = std::max(size, size_of(Value(along(gradient(d.phi), d.x, u))));
  s.put("zero", 0, size);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      s.put("phi," + digit(i) + digit(j), second(d.phi, d.x, axes[i], axes[j]), size);
      s.put("turned" + digit(i) + digit(j), second(d.phi, d.x, d.frame[i], d.frame[j]), size);
    }
  s.put_vector("grad", gradient(d.phi, d.frame), d.x);
  s.put("curl_grad", curl(gradient(d.phi, d.frame), d.frame)(d.x));
  s.put("curl_v", curl(d.f, d.frame)(d.x));
  s.put_scalar("phi", d.phi, d.x);
  s.put_vector("v", d.f, d.x);
}

/// Difference quotients of the slopes of Peano's function at the origin, by x of dp/dy and by y of dp/dx.
/// Steps go down to 2^-350, above which their cubes do not underflow.
Check peano_orders() {
  WorstSample worst("second derivatives at the origin", "by $y$, then by $x$", "by $x$, then by $y$");
  for (int k = 10; k <= 350; k += 10) {
    const double t = std::ldexp(1.0, -k);
    worst.add(along(peano, Point{t, 0, 0}, axes[1]) / t, along(peano, Point{0, t, 0}, axes[0]) / t, 1,
              "quotient over $2^{-" + std::to_string(k) + "}$");
  }
  return worst.check();
}

const Names names{{"grad", R"((\nabla\varphi))"},
                  {"curl_grad", R"((\nabla\times\nabla\varphi))"},
                  {"curl_v", R"((\nabla\times\mathbf v))"},
                  {"turned", R"(\varphi')"},
                  {"zero", "0"}};

constexpr const char* by_nested_duals = "nested dual numbers along two vectors of a turned frame";
const std::vector<Row> either_order{
    {"turned01", "turned10"}, {"turned12", "turned21"}, {"turned20", "turned02"}};

Proof proof_of_lines(Random random) {
  Proof proof("5.9", sampled(random, fill), names);
  proof.line("gradient", 3373, R"($\nabla\varphi=(\varphi_{,0},\varphi_{,1},\varphi_{,2})$)",
             each_component("grad#", "phi,#"), "the gradient along a turned frame, by dual numbers");
  const auto component = [&](int at, const std::string& i, const std::vector<Row>& terms,
                             const std::string& any) {
    const std::string slopes = "slopes of the gradient along a turned frame, by nested dual numbers",
                      pattern = R"(the curl of any field $\mathbf v$ along a turned frame, by dual numbers)";
    const std::vector<Row> of_any{{"curl_v" + i, any}};
    Claim claim{.printed = proof.reading(terms, slopes), .near_misses = proof.single_changes(terms, slopes)};
    const Reading same = proof.reading(of_any, pattern);
    claim.printed.text += ", by the pattern " + same.text;
    claim.printed.checks.push_back(same.checks[0]);
    for (Reading& near : proof.single_changes(of_any, pattern)) claim.near_misses.push_back(std::move(near));
    proof.claims.add("component_" + i, at,
                     R"($(\nabla\times\nabla\varphi)_)" + i + "=" + typeset(terms[0].right, names) +
                         typeset(terms[1].right, names) + "$",
                     std::move(claim));
    std::vector<Row> all = terms;
    all.push_back(of_any[0]);
    all.push_back({"curl_grad" + i, terms[0].right + " " + terms[1].right});
    proof.lines.push_back({"component_" + i, all});
  };
  component(3379, "0", {{"grad2,1", "phi,21"}, {"- grad1,2", "- phi,12"}}, "v2,1 - v1,2");
  component(3387, "1", {{"grad0,2", "phi,02"}, {"- grad2,0", "- phi,20"}}, "v0,2 - v2,0");
  component(3395, "2", {{"grad1,0", "phi,10"}, {"- grad0,1", "- phi,01"}}, "v1,0 - v0,1");
  proof.line("identity", 3403, R"($\nabla\times\nabla\varphi=0$)", each_component("curl_grad#", "zero"),
             R"($\nabla\times\nabla\varphi$ along a turned frame, by nested dual numbers)",
             {each_component("curl_v#", "zero"),
              {{"phi,21 + phi,12", "zero"}, {"phi,02 + phi,20", "zero"}, {"phi,10 + phi,01", "zero"}}});
  proof.lines.push_back({"order", either_order});
  return proof;
}

/// Along the axes, with derivatives in one order.
constexpr const char* in_axes =
    "pose proof (smooth_less 1 phi H0) as once; rewrite ?along_twice by assumption;\n"
    "  unfold dot_field, dot, sum; rewrite ?curl_is by auto using gradient_smooth; simpl; unfold plus_times;\n"
    "  rewrite ?gradient_is by auto; rewrite ?(d_swap phi 1 0), ?(d_swap phi 2 0), ?(d_swap phi 2 1) by auto; ring";

}  // namespace

std::vector<Claim> claims(Random random, const Known& mixed) {
  Proof proof = proof_of_lines(random);
  const auto& m = mixed.value;
  const Value one{m[0], m[2], m[4]}, other{m[1], m[3], m[5]};
  Claim order{
      .printed = proof.reading(either_order, by_nested_duals),
      .near_misses = {
          proof.reading({{"turned01", "turned02"}, {"turned12", "turned10"}, {"turned20", "turned21"}},
                        by_nested_duals),
          {"it is irrelevant wherever they exist (Peano's $xy(x^2-y^2)/(x^2+y^2)$)", {peano_orders()}}}};
  order.printed.checks.push_back({"second derivatives of the fixed field",
                                  {"iterated limits in 60 digits, in one order", one},
                                  {"iterated limits in 60 digits, in the other", other},
                                  rounding(size_of(one), 1)});
  proof.claims.add(
      "order", 3405,
      "the order of partial differentiation is irrelevant for a function whose second derivatives "
      "are continuous (our check: along any two axes of a turned frame, "
      "$\\varphi'_{01}=\\varphi'_{10}$)",
      std::move(order));
  return proof.claims.in_order();
}

/// For any fields v and phi, with the gradient and the curl along any frame r.
Provables proofs() {
  const auto at_the_point = [](const std::string& field) {
    return Expression::letter("(" + field + " x0 x1 x2)");
  };
  const auto by = [](std::size_t j, const std::string& field) {
    return "d " + digit(j) + " (" + field + ")";
  };
  const auto along_axis = [](std::size_t k, const std::string& field) {
    return "along (r " + digit(k) + "%nat) (" + field + ")";
  };
  Meanings m;
  m.put("zero", Expression(0.0));
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string number = digit(i) + "%nat", grad = "gradient r phi " + number, v = "v " + number;
    m.put("grad" + digit(i), at_the_point(grad));
    m.put("curl_grad" + digit(i), at_the_point("curl r (gradient r phi) " + number));
    m.put("curl_v" + digit(i), at_the_point("curl r v " + number));
    m.put("phi," + digit(i), at_the_point(by(i, "phi")));
    for (std::size_t j = 0; j < 3; ++j) {
      m.put("phi," + digit(i) + digit(j), at_the_point(by(j, by(i, "phi"))));
      m.put("turned" + digit(i) + digit(j), at_the_point(along_axis(j, along_axis(i, "phi"))));
      m.put("grad" + digit(i) + "," + digit(j), at_the_point(by(j, grad)));
      m.put("v" + digit(i) + "," + digit(j), at_the_point(by(j, v)));
    }
  }
  return m.proofs("5.9", proof_of_lines(Random(1)),
                  {.letters = "(r : nat -> nat -> R) (phi : field) (v : nat -> field) (x0 x1 x2 : R)",
                   .given = {{"frame r"}, {"smooth 2 phi"}, {"smooth_vector 1 v"}},
                   .tactic = in_axes,
                   .says = "it holds for all fields whose second derivatives are continuous, along any frame",
                   .preamble = coq_source({"fields"})});
}

}  // namespace oddity::ex05_09
