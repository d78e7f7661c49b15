// The claims of exercise 5.5: published sums over indices, written out. Products of M with a vector are
// computed by Eigen.

#include <Eigen/Core>

#include "chapters/05_fluids_and_gases/05_divergence_of_matrix_times_vector/matrix_times_vector.hpp"
#include "chapters/05_fluids_and_gases/shared/meanings.hpp"
#include "chapters/05_fluids_and_gases/shared/smooth_fields.hpp"
#include "reference/text.hpp"

namespace oddity::ex05_05 {

namespace {

using namespace fields;

using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
Eigen::Vector3d eigen(const Point& v) { return {v[0], v[1], v[2]}; }
Point point(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

void fill(Sample& s, const Drawn& d) {
  const Matrix<double>& m = d.m;
  const Rows eigen_m = Eigen::Map<const Rows>(m[0].data()), turn = Eigen::Map<const Rows>(d.frame[0].data());
  const Rows turned_m = turn * eigen_m * turn.transpose();
  const Eigen::Vector3d f = eigen(d.f(d.x)), g = eigen(d.g(d.x));
  s.put("Mf", point(eigen_m * f));
  s.put("gTM", point((g.transpose() * eigen_m).transpose()));
  s.put("MTg", point(eigen_m.transpose() * g));
  s.put("MTgrad_phi", point(eigen_m.transpose() * eigen(gradient(d.phi, d.frame)(d.x))));
  s.put("turned_Mf", point(turn * (eigen_m * f)));
  s.put("turned_gTM", point(turn * (g.transpose() * eigen_m).transpose()));
  s.put("div_Mf", divergence(product(m, d.f), d.frame)(d.x));
  s.put("div_phi_Mf", divergence(product(m, times(d.phi, d.f)), d.frame)(d.x));
  for (std::size_t i = 0; i < 3; ++i) {
    s.put("m" + digit(i), m[i]);
    s.put("n" + digit(i), point(turned_m.row(static_cast<int>(i))));
    s.put("column" + digit(i) + "_f", along(d.f, d.x, column(m, i)));
    s.put("row" + digit(i) + "_f", along(d.f, d.x, m[i]));
  }
  s.put("v", point(turn * f));
  s.put("u", point(turn * g));
  s.put("over_x", Point{1 / d.x[0], 1 / d.x[1], 1 / d.x[2]});
  s.put("g", point(g));
  s.put_scalar("phi", d.phi, d.x);
  s.put_vector("f", d.f, d.x);
  s.put_vector("h", product(m, d.f), d.x);
}

const Names names{{"Mf", R"((M\mathbf f))"},
                  {"over_x", R"((1/x))"},
                  {"gTM", R"((\mathbf g^TM))"},
                  {"MTg", R"((M^T\mathbf g))"},
                  {"MTgrad_phi", R"((M^T\nabla\varphi))"},
                  {"turned_Mf", R"((M\mathbf f)')"},
                  {"turned_gTM", R"((\mathbf g^TM)')"},
                  {"div_Mf", R"(\nabla\cdot(M\mathbf f))"},
                  {"div_phi_Mf", R"(\nabla\cdot(\varphi M\mathbf f))"},
                  {"column0_f", R"(((M\mathbf e_0)\cdot\nabla\mathbf f))"},
                  {"column1_f", R"(((M\mathbf e_1)\cdot\nabla\mathbf f))"},
                  {"column2_f", R"(((M\mathbf e_2)\cdot\nabla\mathbf f))"},
                  {"row0_f", R"(((M^T\mathbf e_0)\cdot\nabla\mathbf f))"},
                  {"row1_f", R"(((M^T\mathbf e_1)\cdot\nabla\mathbf f))"},
                  {"row2_f", R"(((M^T\mathbf e_2)\cdot\nabla\mathbf f))"}};

Proof proof_of_lines(Random random) {
  Proof proof("5.5", sampled(random, fill), names);
  const std::string whole =
      R"($M\mathbf f$ differentiated as one field along a turned frame, by dual numbers)";
  const std::string by_eigen = "the product by Eigen";
  const std::string outside =
      "m00 f0,0 + m01 f1,0 + m02 f2,0 + m10 f0,1 + m11 f1,1 + m12 f2,1 + m20 f0,2 + m21 f1,2 + m22 f2,2";
  const std::string quotient =
      "m00 over_x0 f0 + m01 over_x0 f1 + m02 over_x0 f2 + m10 over_x1 f0 + m11 over_x1 f1 + m12 over_x1 f2 + "
      "m20 over_x2 f0 + m21 over_x2 f1 + m22 over_x2 f2";

  proof.line("product", 3271, R"($(M\mathbf f)_i=m_{ij}f_j$, summed over $j$)",
             each_component("Mf#", "m#0 f0 + m#1 f1 + m#2 f2"), by_eigen);
  proof.line(
      "free_i", 3271,
      R"($i$ being the only free index, $m_{ij}f_j$ is a vector: $(M\mathbf f)'_i=n_{ij}v_j$ in a turned )"
      R"(frame, in which $M$ has the entries $n_{ij}$ and $\mathbf f$ the components $v_j$)",
      each_component("turned_Mf#", "n#0 v0 + n#1 v1 + n#2 v2"), R"($M\mathbf f$, turned)");
  proof.line(
      "divergence", 3273,
      R"($\nabla\cdot(M\mathbf f)$ is $\partial(m_{ij}f_j)/\partial x_i$, with $\mathbf h=M\mathbf f$)",
      {{"div_Mf", "h0,0 + h1,1 + h2,2"}}, whole);

  const auto square = [](const auto& x) { return x * x; };
  const std::vector<Row> constants{{"div_Mf", outside}};
  Reading lost = proof.reading({{"div_Mf", quotient}}, whole);
  lost.text =
      R"($(m_{ij}/\partial x_i)f_j$, a quotient without a value; the nearest with one is $m_{ij}f_j/x_i$)";
  lost.as_typeset = false;
  Reading meant = proof.reading(constants, whole);
  meant.text = R"($(m_{ij}\,\partial/\partial x_i)f_j$: )" + meant.text;
  meant.as_typeset = false;
  auto changes = proof.single_changes(constants, whole);
  changes.push_back(proof.reading({{"div_phi_Mf", "phi (" + outside + ")"}}, whole));
  changes.back().text = "the formula for a matrix that varies, $\\varphi M$";
  changes.back().as_typeset = false;
  proof.claims.add(
      "constants_outside", 3277,
      R"($\nabla\cdot(M\mathbf f)=(m_{ij}/\partial x_i)f_j$, the constants $m_{ij}$ moved out of the derivative)",
      {.printed = lost,
       .meant = std::move(meant),
       .near_misses = std::move(changes),
       .why = filled(
           R"(A $\partial$ is lost above the bar in the text at hand, here and in line 3295; the manual has it: line )"
           R"(3285 says that this display has the expression $m_{ij}\,\partial/\partial x_i$, and line 3287 shows it. )"
           R"(A quotient by $\partial x_i$ differentiates nothing. For $M=I$ and $\mathbf f=(x_0^2,0,0)$ at $x_0=3$ )"
           R"($m_{ij}f_j/x_i$ is @1, where the divergence is @1.)",
           {square(3.0) / 3, derivative(square, 3.0)}),
       .kind = Fault::lost_typography});
  proof.lines.push_back({"constants_outside", constants, "meant"});

  proof.line("row_times_matrix", 3285, R"($(\mathbf g^TM)_j=g_im_{ij}$, summed over $i$)",
             each_component("gTM#", "g0 m0# + g1 m1# + g2 m2#"), by_eigen);
  proof.line(
      "free_j", 3285,
      R"($j$ being the only free index, $g_im_{ij}$ is a vector: $(\mathbf g^TM)'_j=u_in_{ij}$ in a turned )"
      R"(frame, in which $\mathbf g$ has the components $u_i$ and $M$ the entries $n_{ij}$)",
      each_component("turned_gTM#", "u0 n0# + u1 n1# + u2 n2#"), R"($\mathbf g^TM$, turned)");
  proof.line("commuted", 3285, R"($(\mathbf g^TM)_j=g_im_{ij}=m_{ij}g_i$, as multiplication commutes)",
             each_component("gTM#", "m0# g0 + m1# g1 + m2# g2"), by_eigen);
  proof.line("transposed", 3285, R"($m_{ij}g_i=(M^T\mathbf g)_j$)",
             each_component("MTg#", "m0# g0 + m1# g1 + m2# g2"), by_eigen);
  proof.line("operator", 3291,
             R"($m_{ij}\,\partial/\partial x_i=(M^T\nabla)_j$ (our check: on any field $\varphi$))",
             each_component("MTgrad_phi#", "m0# phi,0 + m1# phi,1 + m2# phi,2"),
             "$M^T$ times the gradient along a turned frame, by Eigen");

  const std::vector<Row> identity{{"div_Mf", "column0_f0 + column1_f1 + column2_f2"}};
  changes = proof.single_changes(identity, whole);
  changes.push_back(proof.reading({{"div_Mf", "row0_f0 + row1_f1 + row2_f2"}}, whole));
  changes.back().text = R"($(M\nabla)\cdot\mathbf f$)";
  proof.claims.add(
      "identity", 3293,
      R"($\nabla\cdot(M\mathbf f)=(M^T\nabla)\cdot\mathbf f$: each $f_j$ along column $j$ of $M$, $M\mathbf e_j$)",
      {.printed = proof.reading(identity, whole), .near_misses = std::move(changes)});
  proof.lines.push_back({"identity", identity});
  return proof;
}

/// Proofs that quantities rotate with their factors, for any matrix and vectors in any frame r.
Provables proofs_of_turned(const Proof& proof) {
  const std::array r{numbers("r 0%nat"), numbers("r 1%nat"), numbers("r 2%nat")},
      m{numbers("m 0%nat"), numbers("m 1%nat"), numbers("m 2%nat")};
  const auto f = numbers("f"), g = numbers("g");
  const std::array mf{dot(m[0], f), dot(m[1], f), dot(m[2], f)};
  const auto column = [&](std::size_t j) { return std::array{m[0][j], m[1][j], m[2][j]}; };
  const std::array gm{dot(g, column(0)), dot(g, column(1)), dot(g, column(2))};
  Meanings in_frame;
  const auto put = [&](const std::string& name, const Shortened& x) { in_frame.put(name, x.expression()); };
  for (std::size_t i = 0; i < 3; ++i) {
    put("v" + digit(i), dot(r[i], f));
    put("u" + digit(i), dot(r[i], g));
    put("turned_Mf" + digit(i), dot(r[i], mf));
    put("turned_gTM" + digit(i), dot(r[i], gm));
    for (std::size_t j = 0; j < 3; ++j) {
      const std::array m_along{dot(m[0], r[j]), dot(m[1], r[j]), dot(m[2], r[j])};
      put("n" + digit(i) + digit(j), dot(r[i], m_along));
    }
  }
  return in_frame.proofs("5.5", proof,
                         {.letters = "(r m : nat -> nat -> R) (f g : nat -> R)",
                          .given = {{"frame r"}},
                          .tactic = "first [in_turned_frame r f H | in_turned_frame r g H]",
                          .says = "it holds for any matrix and vectors in any right-handed orthonormal frame",
                          .preamble = coq_source({"turned_fields"})});
}

}  // namespace

std::vector<Claim> claims(const Random& random) { return proof_of_lines(random).claims.in_order(); }

Provables proofs() {
  Meanings m;
  const CoqField phi = m.any_scalar("phi");
  const CoqVector f = m.any_vector("f"), g = m.any_vector("g");
  const std::array<CoqVector, 3> rows{m.any_numbers("m0"), m.any_numbers("m1"), m.any_numbers("m2")};
  const CoqVector product{dot(rows[0], f), dot(rows[1], f), dot(rows[2], f)};
  for (std::size_t i = 0; i < 3; ++i) {
    const CoqVector column{rows[0][i], rows[1][i], rows[2][i]};
    m.put("m" + digit(i), rows[i]);
    m.put("column" + digit(i) + "_f", advected(column, f));
  }
  m.put("div_Mf", divergence(product));
  m.put_vector("h", product);
  m.put_vector("f", f);
  m.put("g", g);
  m.put_scalar("phi", phi);
  const Proof proof = proof_of_lines(Random(1));
  Provables all = m.proofs("5.5", proof);
  for (Provable& of_turned : proofs_of_turned(proof)) all.push_back(std::move(of_turned));
  return all;
}

}  // namespace oddity::ex05_05
