#include "chapters/provable_claims.hpp"

#include "chapters/08_affine_algebra/05_tetrahedron_map/tetrahedron_map.hpp"
#include "chapters/numbers.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"

/// The book's derivation line by line on random tetrahedra, with the coefficients from volumes.
namespace oddity::ex08_05 {

template <class T>
struct SampleOf {
  TetrahedronOf<T> t;
  Vector<T> p;
  AffineOf<T> f;
  double condition;

  /// (c1, c2, c3).
  Vector<T> c() const { return by_volumes(t, p); }
  T c0() const {
    return triple<T>(t.p[1] - p, t.p[2] - p, t.p[3] - p) / triple(t.edge(1), t.edge(2), t.edge(3));
  }
  Vector<T> v() const { return p - t.p[0]; }
  /// For sums weighted by the coefficients. These are quotients of volumes, whose terms cancel, so the size
  /// of the terms does not show in the sum.
  Tolerance tolerance(double size) const {
    double terms = std::abs(c0()) * t.p[0].norm();
    for (long i = 0; i < 3; ++i) terms += std::abs(c()[i]) * t.p[static_cast<std::size_t>(i) + 1].norm();
    return rounding(condition * terms / p.norm() * size);
  }

  std::vector<T*> letters() {
    std::vector<T*> all{&f.b};
    for (Vector<T>* x : {&t.p[0], &t.p[1], &t.p[2], &t.p[3], &p, &f.a})
      for (int i = 0; i < 3; ++i) all.push_back(&(*x)[i]);
    return all;
  }
  TypesetIn<T> typeset() const {
    const auto numbers = [](const Vector<T>& x) { return std::array<T, 3>{x[0], x[1], x[2]}; };
    TypesetIn<T> all{
        {"c_0", c0()}, {"f_0", f(t.p[0])}, {"P_0", numbers(t.p[0])}, {"P", numbers(p)}, {"V", numbers(v())}};
    for (std::size_t i = 1; i < 4; ++i) {
      const std::string index = "_" + std::to_string(i);
      all.emplace_back("c" + index, c()[static_cast<long>(i) - 1]);
      all.emplace_back("f" + index, f(t.p[i]));
      all.emplace_back("V" + index, numbers(t.edge(i)));
      all.emplace_back("P" + index, numbers(t.p[i]));
    }
    return all;
  }
  std::string where() const { return "condition " + format_significant(condition, 3); }
};

namespace {

using Sample = SampleOf<double>;
using Table = ProvableClaims<SampleOf>;

Vector3d vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Random tetrahedra whose edges' condition is below `most`, with the apex lowered to `height`, and P inside
/// and outside.
std::vector<Sample> samples(double seed, double height, double most) {
  Random random(seed);
  std::vector<Sample> all;
  while (all.size() < 200) {
    Tetrahedron t;
    const double size = std::abs(random.magnitude(1e-2, 1e2));
    for (auto& vertex : t.p) vertex = vector(random.point(size));
    t.p[3] = t.p[0] + 0.3 * t.edge(1) + 0.2 * t.edge(2) + height * t.edge(3);
    const Vector3d c = vector(random.point(2));
    const double k = condition(t.edges());
    if (k < most)
      all.push_back({t, t.p[0] + t.edges() * c, {vector(random.point(3)), random.between(-3, 3)}, k});
  }
  return all;
}

void formulas(Table& table, const std::vector<Sample>& all) {
  const auto claim = table.over(all);
  claim("barycentric", 4003, "$P=c_0P_0+c_1P_1+c_2P_2+c_3P_3$ with $c_0+c_1+c_2+c_3=1$",
        {"$P$ and 1", [](const auto& s) { return values(s.p[0], s.p[1], s.p[2], 1); }},
        R"($(c_0P_0+c_1P_1+c_2P_2+c_3P_3,\ c_0+c_1+c_2+c_3)$)",
        R"($\sum c_iP_i$ and $\sum c_i$, the $c_i$ ratios of volumes)");
  claim("affine", 4007, "$f(P)=c_0f_0+c_1f_1+c_2f_2+c_3f_3$: the coefficients give the value",
        {"the map itself", [](const auto& s) { return s.f(s.p); }}, "$c_0f_0+c_1f_1+c_2f_2+c_3f_3$",
        "$f(P)$");
  claim("first_coefficient", 4011, "$c_0-1=-c_1-c_2-c_3$",
        {R"($-c_1-c_2-c_3$ by the volumes over three faces)", [](const auto& s) { return -s.c().sum(); }},
        "$c_0-1$");
  claim.equation("edge_sum", 4013, "$V=c_1V_1+c_2V_2+c_3V_3$",
                 {"$V=P-P_0$", [](const auto& s) { return s.v(); }});
  const std::string system = R"($\sum_j(V_i\cdot V_j)c_j=V_i\cdot V$)";
  claim("normal_equations", 4015, system + " for $i=1,2,3$ is a linear system for $c_1,c_2,c_3$",
        {"zero", []<class T>(const SampleOf<T>&) { return Vector<T>(T(0.0), T(0.0), T(0.0)); }}, system,
        "difference of the sides of the system's rows at ratios of volumes");
}

/// A tetrahedron's three edges from one vertex, in whole numbers.
struct WholeEdges {
  using Row = std::array<long long, 3>;
  using Rows = std::array<Row, 3>;
  Rows v;

  explicit WholeEdges(Random& random) {
    do
      for (auto& row : v)
        for (long long& x : row) x = random.below(201) - 100;
    while (flat(v));
  }
  /// Whether the common vertex, at the origin, is in the plane of the other three.
  static bool flat(const Rows& m) {
    const auto less = [](const Row& a, const Row& b) { return Row{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
    return oddity::dot(m[0], oddity::cross(less(m[1], m[0]), less(m[2], m[0]))) == 0;
  }
  /// The number of rows left nonzero by elimination in whole numbers.
  static int rank(Rows m) {
    std::size_t done = 0;
    for (std::size_t column = 0; column < 3; ++column) {
      std::size_t pivot = done;
      while (pivot < 3 && m[pivot][column] == 0) ++pivot;
      if (pivot == 3) continue;
      std::swap(m[done], m[pivot]);
      for (std::size_t i = done + 1; i < 3; ++i) {
        const long long factor = m[i][column];
        for (std::size_t j = 0; j < 3; ++j) m[i][j] = m[done][column] * m[i][j] - factor * m[done][j];
      }
      ++done;
    }
    return static_cast<int>(done);
  }
  static long long det(const Rows& m) { return oddity::dot(m[0], oddity::cross(m[1], m[2])); }
  static long long det_of_products(const Rows& e) {
    Rows products;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) products[i][j] = oddity::dot(e[i], e[j]);
    return det(products);
  }
  /// The edges with the third one moved into the plane of the other two.
  Rows flattened() const {
    Rows flat = v;
    for (std::size_t a = 0; a < 3; ++a) flat[2][a] = 2 * v[0][a] - v[1][a];
    return flat;
  }
  TypesetLetters typeset() const {
    return {{R"(\det[V_i\cdot V_j])", static_cast<double>(det_of_products(v))},
            {R"(\det[V_1V_2V_3])", static_cast<double>(det(v))}};
  }
  std::string where() const { return R"($\det$ = )" + std::to_string(det(v)); }
};

/// The pivots and the solution of elimination without row exchange.
template <class T>
struct Eliminated {
  Vector<T> pivots, x;
};
template <class T>
Eliminated<T> eliminated(Eigen::Matrix<T, 3, 3> a, Vector<T> b) {
  for (int k = 0; k < 3; ++k)
    for (int i = k + 1; i < 3; ++i) {
      const T multiple = a(i, k) / a(k, k);
      for (int j = k + 1; j < 3; ++j) a(i, j) -= multiple * a(k, j);
      b[i] -= multiple * b[k];
    }
  for (int i = 2; i >= 0; --i) {
    for (int j = i + 1; j < 3; ++j) b[i] -= a(i, j) * b[j];
    b[i] = b[i] / a(i, i);
  }
  return {a.diagonal(), b};
}

/// Checks the printed system by elimination. The tolerance is a rounding times the condition number to this
/// `power`.
Reading elimination(std::string text, const std::vector<Sample>& all, double power) {
  WorstSample exchanging("$c_1,c_2,c_3$", "elimination of the normal equations", "ratios of volumes"),
      in_order("$c_1,c_2,c_3$", "elimination without exchange of rows", "ratios of volumes");
  for (const Sample& s : all) {
    const Matrix3d v = s.t.edges(), products = v.transpose() * v;
    const Vector3d right = v.transpose() * s.v();
    const double size = 1 + s.c().cwiseAbs().maxCoeff();
    const Tolerance allowed = rounding(size * std::pow(s.condition, power));
    exchanging.add(solve(Factorization::partial_pivot_lu, products, right).value, s.c(), allowed, size,
                   s.where());
    in_order.add(eliminated(products, right).x, s.c(), allowed, size, s.where());
  }
  return {std::move(text), {exchanging.check(), in_order.check()}};
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("8.5");
  constexpr double well_conditioned = 50, sliver = 1e-5;
  const auto fair = samples(seed, 1, well_conditioned);
  Table table(claims);
  formulas(table, fair);
  const auto tetrahedra = draw<WholeEdges>(500, seed);
  claims.statement<WholeEdges>("invertible", 4035, R"(the matrix $[V_i\cdot V_j]$ is invertible)", tetrahedra,
                               {.printed = {R"($\det[V_i\cdot V_j]=(\det[V_1V_2V_3])^2>0$)"},
                                .near_misses = {{R"($\det[V_i\cdot V_j]=|\det[V_1V_2V_3]|$)"}}});
  claims.statement<WholeEdges>(
      "independent", 4035,
      "the edges $V_1$, $V_2$ and $V_3$ of a tetrahedron (our condition: one with a volume) are linearly "
      "independent",
      tetrahedra,
      {.printed = {"elimination leaves three rows, for four vertices that are not in a plane",
                   [](const WholeEdges& e) { return WholeEdges::rank(e.v) == 3; }},
       .near_misses = {{"for four vertices in a plane too",
                        [](const WholeEdges& e) { return WholeEdges::rank(e.flattened()) == 3; }}}});
  claims.add(
      "gauss", 4035,
      filled(
          "standard Gaussian elimination solves the system, printed \"the matrix\" (our check: edges with a condition number below @2)",
          {well_conditioned}),
      {.printed = elimination("to roundings times the condition number squared", fair, 2),
       .near_misses = {
           elimination("slivers, to roundings times the condition number", samples(seed, sliver, 1e8), 1)}});
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

Provables proofs() {
  auto all = for_all<SampleOf>({"b", "x0", "y0", "z0", "x1", "y1", "z1", "x2", "y2", "z2", "x3", "y3", "z3",
                                "px", "py", "pz", "ax", "ay", "az"},
                               "field; exact H", "it holds of any tetrahedron and any point");
  const SampleOf<Shortened>& any = all.any;
  all.given = {not_zero(triple(any.t.edge(1), any.t.edge(2), any.t.edge(3)).expression())};
  Claims claims("8.5");
  Table table(claims);
  formulas(table, {});
  Provables proved = table.proofs("8.5", all);
  const auto same = [](const Vector<Shortened>& a, const Vector<Shortened>& b) {
    return equal(detail::recorded_value(a), detail::recorded_value(b));
  };
  const Vector<Shortened> d(Shortened::letter("d1"), Shortened::letter("d2"), Shortened::letter("d3"));
  const Eigen::Matrix<Shortened, 3, 3> products = any.t.edges().transpose() * any.t.edges();
  const Vector<Shortened> right = any.t.edges().transpose() * any.v();
  std::vector<Proposition> solved = all.given;
  for (const Proposition& row : same(products * d, right)) solved.push_back(row);
  const Lemma no_other{"no_other", all.letters + " (d1 d2 d3 : R)", solved, same(d, any.c()),
                       "no_other x0 y0 z0 x1 y1 z1 x2 y2 z2 x3 y3 z3 px py pz d1 d2 d3"};
  Provable& system = proof_of(proved, "8.5-normal_equations");
  system.says = "they solve it, of any tetrahedron and any point, and nothing else does";
  system.lemmas.push_back(no_other);
  system.preamble = coq_source({"no_other"});
  Eigen::Matrix<Shortened, 3, 3> m;
  const auto letter = &Shortened::letter;
  m << letter("m00"), letter("m01"), letter("m02"), letter("m01"), letter("m11"), letter("m12"),
      letter("m02"), letter("m12"), letter("m22");
  const Vector<Shortened> r(letter("r0"), letter("r1"), letter("r2"));
  const auto found = eliminated(m, r);
  const auto minors = [](const Eigen::Matrix<Shortened, 3, 3>& a) {
    return std::array{a(0, 0), a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0),
                      triple<Shortened>(a.col(0), a.col(1), a.col(2))};
  };
  const auto above_zero = [](const auto& x) { return positive({x[0], x[1], x[2]}); };
  const std::string of_system = quantified({"m00", "m01", "m02", "m11", "m12", "m22", "r0", "r1", "r2"});
  proved.push_back(
      {"8.5-gauss",
       "without exchange of rows its divisors are above zero, and it finds the only solution",
       {{"of_edges", all.letters, all.given, above_zero(minors(products)),
         "minors_of_edges x0 y0 z0 x1 y1 z1 x2 y2 z2 x3 y3 z3"},
        {"pivots", of_system, above_zero(minors(m)), above_zero(found.pivots), "pivots"},
        {"solves", of_system, above_zero(minors(m)), same(m * found.x, r), "field; repeat split; nra"},
        no_other},
       0,
       coq_source({"pivots", "no_other"})});
  return proved;
}

}  // namespace oddity::ex08_05
