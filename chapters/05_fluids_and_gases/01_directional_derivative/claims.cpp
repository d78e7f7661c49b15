// The claims of exercise 5.1: published lines, computed from partial derivatives along the axes and compared
// with derivatives along a turned frame.

#include "chapters/05_fluids_and_gases/01_directional_derivative/directional_derivative.hpp"
#include "chapters/05_fluids_and_gases/shared/differentiation.hpp"
#include "chapters/05_fluids_and_gases/shared/meanings.hpp"
#include "reference/text.hpp"

namespace oddity::ex05_01 {

namespace {

using namespace fields;

void fill(Sample& s, const Drawn& d) {
  s.put("fgrad_g", advected(d.f, d.g, d.frame)(d.x));
  s.put("fgrad_x", advected(d.f, position, d.frame)(d.x));
  s.put("along_f", along(position, d.x, d.f(d.x)));
  s.put("div_x", divergence(position, d.frame)(d.x));
  s.put("f", d.f(d.x));
  s.put_vector("g", d.g, d.x);
  s.put_vector("x", position, d.x);
  for (std::size_t j = 0; j < 3; ++j) s.put("e" + digit(j), axes[j]);
  for (std::size_t j = 0; j < 3; ++j) s.put("slope" + digit(j), along(position, d.x, axes[j]));
}

const Names names{{"fgrad_g", R"(((\mathbf f\cdot\nabla)\mathbf g))"},
                  {"fgrad_x", R"(((\mathbf f\cdot\nabla)\mathbf x))"},
                  {"along_f", R"(((\mathbf f\cdot\nabla)\mathbf x))"},
                  {"div_x", R"((\nabla\cdot\mathbf x))"},
                  {"e0", R"((\mathbf e_0))"},
                  {"e1", R"((\mathbf e_1))"},
                  {"e2", R"((\mathbf e_2))"},
                  {"slope0", R"((\partial\mathbf x/\partial x_0))"},
                  {"slope1", R"((\partial\mathbf x/\partial x_1))"},
                  {"slope2", R"((\partial\mathbf x/\partial x_2))"}};

Proof proof_of_lines(Random random) {
  Proof proof("5.1", sampled(random, fill), names);
  const std::string turned = R"($\mathbf f\cdot\nabla$ along a turned frame, by dual numbers)";
  proof.line(
      "operator", 3105,
      R"($\mathbf f\cdot\nabla$ is $f_0\,\partial/\partial x_0+f_1\,\partial/\partial x_1+f_2\,\partial/\partial x_2$ )"
      R"((our check: on any field $\mathbf g$))",
      each_component("fgrad_g#", "f0 g#,0 + f1 g#,1 + f2 g#,2"), turned);
  const auto distributed = each_component("fgrad_x#", "f0 x#,0 + f1 x#,1 + f2 x#,2");
  proof.line(
      "distributed", 3115,
      R"($(\mathbf f\cdot\nabla)\mathbf x=f_0\,\partial\mathbf x/\partial x_0+f_1\,\partial\mathbf x/\partial x_1+f_2\,\partial\mathbf x/\partial x_2$)",
      distributed, turned, {each_component("fgrad_x#", "f1 x#,0 + f0 x#,1 + f2 x#,2")});
  Reading dot = proof.reading(each_component("fgrad_x#", "f0 x0,0 + f1 x1,1 + f2 x2,2"), turned);
  dot.text = "a dot product, the number $f_0x_{0,0}+f_1x_{1,1}+f_2x_{2,2}$";
  double dotted = 0;  // f_j dx_j/dx_j at any point, f = (1, 2, 3)
  for (std::size_t j = 0; j < 3; ++j)
    dotted += static_cast<double>(j + 1) * ByDuals{}.along(position, Point{0.5, 0.25, 2}, axes[j])[j];
  proof.claims.add(
      "dot", 3113,
      R"($(\mathbf f\cdot\nabla)\mathbf x$ is the operator applied to $(x_0,x_1,x_2)$, printed with a dot between them)",
      {.printed = dot,
       .meant = proof.reading(distributed, turned),
       .near_misses = {proof.reading(each_component("fgrad_x#", "f0 x#,0 + f1 x#,1"), turned)},
       .why = filled(
           R"(The operator acts like a scalar and is applied to a vector: no dot belongs between them. )"
           R"(Read as a dot product the line is the number $f_0+f_1+f_2$, @1 for $\mathbf f=(1,2,3)$, and )"
           R"(not the vector $\mathbf f$. The next line goes on without it.)",
           {dotted}),
       .kind = Fault::formula});
  proof.lines.push_back({"dot", distributed, "meant"});
  for (std::size_t j = 0; j < 3; ++j) {
    const std::string by = digit(j), slope = "slope" + by + "#";
    proof.line("unit_vector_" + by, 3125,
               "$\\partial\\mathbf x/\\partial x_" + by + "=\\mathbf e_" + by + "$, the unit vector",
               each_component(slope, "e" + by + "#"),
               "the position differentiated along an axis, by dual numbers",
               {each_component(slope, "e" + digit((j + 1) % 3) + "#")});
  }
  proof.line("sum_of_unit_vectors", 3125,
             R"($(\mathbf f\cdot\nabla)\mathbf x=f_0\mathbf e_0+f_1\mathbf e_1+f_2\mathbf e_2$)",
             each_component("fgrad_x#", "f0 e0# + f1 e1# + f2 e2#"), turned,
             {each_component("fgrad_x#", "f0 e1# + f1 e0# + f2 e2#"),
              each_component("fgrad_x#", "f0 e0# + f1 e1# - f2 e2#")});
  proof.line("components", 3127, R"($(\mathbf f\cdot\nabla)\mathbf x=(f_0,f_1,f_2)$)",
             each_component("fgrad_x#", "f#"), turned);
  proof.line("identity", 3129, R"($(\mathbf f\cdot\nabla)\mathbf x=\mathbf f$)",
             each_component("along_f#", "f#"),
             R"(the position differentiated along $\mathbf f$, by dual numbers)",
             {each_component("along_f#", "div_x f#")});
  return proof;
}

CoqVector unit_vector(std::size_t j) {
  CoqVector e;
  for (std::size_t i = 0; i < 3; ++i) e[i].at = [=](const auto&) { return Expression(i == j ? 1.0 : 0.0); };
  return e;
}

}  // namespace

std::vector<Claim> claims(const Random& random) { return proof_of_lines(random).claims.in_order(); }

Provables proofs() {
  Meanings m;
  const CoqVector f = m.any_vector("f"), g = m.any_vector("g"), x = Meanings::position();
  m.put("fgrad_g", advected(f, g));
  m.put("fgrad_x", advected(f, x));
  m.put("along_f", advected(f, x));
  m.put("div_x", divergence(x));
  m.put("f", f);
  m.put_vector("g", g);
  m.put_vector("x", x);
  for (std::size_t j = 0; j < 3; ++j) {
    m.put("e" + digit(j), unit_vector(j));
    m.put("slope" + digit(j), CoqVector{partial(x[0], j), partial(x[1], j), partial(x[2], j)});
  }
  return m.proofs("5.1", proof_of_lines(Random(1)));
}

}  // namespace oddity::ex05_01
