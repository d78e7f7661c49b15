#include "chapters/claims.hpp"

#include "chapters/08_affine_algebra/05_tetrahedron_map/tetrahedron_map.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"

/// The lines of the book's derivation on random tetrahedra, coefficients by volumes.
namespace oddity::ex08_05 {

namespace {

struct Sample {
  Tetrahedron t;
  Vector3d p;
  Affine f;
  double condition;

  /// (c1, c2, c3).
  Vector3d c() const { return by_volumes(t, p); }
  double c0() const {
    return triple<double>(t.p[1] - p, t.p[2] - p, t.p[3] - p) / triple(t.edge(1), t.edge(2), t.edge(3));
  }
  Vector3d v() const { return p - t.p[0]; }
  /// `first` times c0 for the first vertex, and c1, c2, c3 times what each of the others has.
  auto combined(double first, const auto& of) const {
    const Vector3d weights = c();
    auto sum = of(t.p[0]);
    sum *= first;
    for (std::size_t i = 1; i < 4; ++i) sum += weights[static_cast<long>(i) - 1] * of(t.p[i]);
    return sum;
  }

  /// What the volumes' cancellations can do to a sum over the coefficients: it is the same whatever the
  /// letters are, and they do not show it.
  double cancelling(const auto& size_of_vertex) const {
    double sum = std::abs(c0()) * size_of_vertex(t.p[0]);
    for (std::size_t i = 1; i < 4; ++i)
      sum += std::abs(c()[static_cast<long>(i) - 1]) * size_of_vertex(t.p[i]);
    return condition * sum;
  }

  std::vector<double*> letters() {
    std::vector<double*> all{&f.b};
    for (Vector3d* x : {&t.p[0], &t.p[1], &t.p[2], &t.p[3], &p, &f.a})
      for (int i = 0; i < 3; ++i) all.push_back(&(*x)[i]);
    return all;
  }
  std::string where() const { return "condition " + format_significant(condition, 3); }
};

Vector3d vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Random tetrahedra of edges' condition below `most`, the apex let down to `height`, P inside and outside.
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

Formula<Sample> sums(std::string text, double sign_of_c0) {
  const auto point = [](const Vector3d& x) { return Eigen::Vector4d(x[0], x[1], x[2], 1); };
  return {std::move(text), [=](const Sample& s) { return Value(s.combined(sign_of_c0 * s.c0(), point)); },
          [=](const Sample& s) {
            return s.cancelling([=](const Vector3d& x) { return point(x).cwiseAbs().maxCoeff(); });
          }};
}

/// f, with or without a quadratic term.
double bent(const Sample& s, const Vector3d& x, double bend) { return s.f(x) + bend * x.dot(x); }

/// f(P) by the vertices, c0 f0 times a factor.
Reading by_vertices(std::string text, const std::vector<Sample>& all, double with_c0, double bend) {
  return {std::move(text),
          {compare<Sample>("$f(P)$",
                           {with_c0 == 0 ? "$c_1f_1+c_2f_2+c_3f_3$" : "$c_0f_0+c_1f_1+c_2f_2+c_3f_3$",
                            [=](const Sample& s) {
                              return s.combined(with_c0 * s.c0(),
                                                [&](const Vector3d& x) { return bent(s, x, bend); });
                            },
                            [=](const Sample& s) {
                              return s.cancelling([&](const Vector3d& x) {
                                return s.f.a.cwiseAbs().dot(x.cwiseAbs()) + std::abs(s.f.b);
                              });
                            }},
                           {"the map itself", [=](const Sample& s) { return bent(s, s.p, bend); }}, all)}};
}

/// The system at the coefficients by volumes.
Reading rows(std::string text, const std::vector<Sample>& all, double off_diagonal, bool from_origin) {
  return {std::move(text),
          {compare<Sample>("the system's rows at ratios of volumes",
                           {R"($\sum_j(V_i\cdot V_j)c_j$)",
                            [=](const Sample& s) {
                              Matrix3d products = s.t.edges().transpose() * s.t.edges();
                              for (int i = 0; i < 3; ++i)
                                for (int j = 0; j < 3; ++j)
                                  if (i != j) products(i, j) *= off_diagonal;
                              return Value(Vector3d(products * s.c()));
                            }},
                           {from_origin ? R"($V_i\cdot P$)" : R"($V_i\cdot V$)",
                            [=](const Sample& s) {
                              return Value(Vector3d(s.t.edges().transpose() * (from_origin ? s.p : s.v())));
                            }},
                           all)}};
}

void derivation(Claims& claims, const std::vector<Sample>& all) {
  claims
      .formula<Sample>("barycentric", 4003, "$P$ is a sum of the vertices with coefficients that add up to 1",
                       all,
                       {.quantity = R"($\sum c_iP_i$ and $\sum c_i$, the $c_i$ ratios of volumes)",
                        .truth = {"$P$ and 1",
                                  [](const Sample& s) {
                                    return Value{s.p[0], s.p[1], s.p[2], 1};
                                  }},
                        .printed = sums(R"($P=\sum c_iP_i$, $\sum c_i=1$)", 1),
                        .near_misses = {sums("$c_0$ of the other sign", -1)}})
      .add("affine", 4007, "the four values determine $f$ everywhere",
           {.printed = by_vertices(R"($f(P)=\sum c_if_i$)", all, 1, 0),
            .near_misses = {by_vertices("without $c_0f_0$", all, 0, 0),
                            by_vertices("for $f$ with a quadratic term", all, 1, 1)}})
      .formula<Sample>("first_coefficient", 4011, "$c_0-1=-c_1-c_2-c_3$", all,
                       {.truth = {R"($-c_1-c_2-c_3$ by the volumes over three faces)",
                                  [](const Sample& s) { return -s.c().sum(); }},
                        .printed = {"$c_0-1$ by the volume over the face opposite to $P_0$",
                                    [](const Sample& s) { return s.c0() - 1; }},
                        .near_misses = {{"$c_0+1$", [](const Sample& s) { return s.c0() + 1; }}}})
      .formula<Sample>("edge_sum", 4013, "$V$ is a sum of the edges", all,
                       {.truth = {"$V=P-P_0$", &Sample::v},
                        .printed = {"$c_1V_1+c_2V_2+c_3V_3$",
                                    [](const Sample& s) { return Value(Vector3d(s.t.edges() * s.c())); }},
                        .near_misses = {{"$c_1P_1+c_2P_2+c_3P_3$",
                                         [](const Sample& s) {
                                           return Value(s.combined(0, [](const Vector3d& x) { return x; }));
                                         }}}})
      .add("normal_equations", 4015, R"(the $3\times3$ system of dot products determines $c_1,c_2,c_3$)",
           {.printed = rows(R"($\sum_j(V_i\cdot V_j)c_j=V_i\cdot V$)", all, 1, false),
            .near_misses = {rows(R"($\sum_j(V_i\cdot V_j)c_j=V_i\cdot P$)", all, 1, true),
                            rows("the signs off the diagonal flipped", all, -1, false)}});
}

/// Three edges of whole numbers.
struct WholeEdges {
  using Rows = std::array<std::array<long long, 3>, 3>;
  Rows v;

  explicit WholeEdges(Random& random) {
    do
      for (auto& row : v)
        for (long long& x : row) x = random.below(201) - 100;
    while (det(v) == 0);
  }
  static long long det(const Rows& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  static long long det_of_products(const Rows& e) {
    Rows products;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        products[i][j] = e[i][0] * e[j][0] + e[i][1] * e[j][1] + e[i][2] * e[j][2];
    return det(products);
  }
  /// The third edge in the plane of the other two.
  Rows flattened() const {
    Rows flat = v;
    for (std::size_t a = 0; a < 3; ++a) flat[2][a] = 2 * v[0][a] - v[1][a];
    return flat;
  }
  std::string where() const { return R"($\det$ = )" + std::to_string(det(v)); }
};

/// The printed system by elimination, allowed the roundings that `power` of the condition number makes of
/// one.
Reading elimination(std::string text, const std::vector<Sample>& all, double power) {
  WorstSample worst("$c_1,c_2,c_3$", "elimination of the normal equations", "ratios of volumes");
  for (const Sample& s : all) {
    const Matrix3d v = s.t.edges();
    const auto c = solve(Factorization::partial_pivot_lu, v.transpose() * v, v.transpose() * s.v());
    const double size = 1 + s.c().cwiseAbs().maxCoeff();
    worst.add(c.value, s.c(), rounding(size * std::pow(s.condition, power)), size, s.where());
  }
  return {std::move(text), {worst.check()}};
}

}  // namespace

std::vector<Claim> claims(double seed) {
  Claims claims("8.5");
  const auto fair = samples(seed, 1, 50);
  derivation(claims, fair);
  claims.statement<WholeEdges>(
      "invertible", 4035, "the matrix is invertible, the edges of a tetrahedron being independent",
      draw<WholeEdges>(500, seed),
      {.printed = {R"($\det[V_i\cdot V_j]=(\det[V_1V_2V_3])^2>0$, six volumes squared)",
                   [](const WholeEdges& e) {
                     const long long all = WholeEdges::det_of_products(e.v), volumes = WholeEdges::det(e.v);
                     return all == volumes * volumes && all > 0;
                   }},
       .near_misses = {
           {R"($\det[V_i\cdot V_j]=|\det[V_1V_2V_3]|$, six volumes)",
            [](const WholeEdges& e) {
              return WholeEdges::det_of_products(e.v) == std::abs(WholeEdges::det(e.v));
            }},
           {R"($\det[V_i\cdot V_j]>0$ for four vertices in a plane too)",
            [](const WholeEdges& e) { return WholeEdges::det_of_products(e.flattened()) > 0; }}}});
  claims.add(
      "gauss", 4035, "standard Gaussian elimination solves the system",
      {.printed = elimination("to roundings times the condition number squared, condition below 50", fair, 2),
       .near_misses = {
           elimination("slivers, to roundings times the condition number", samples(seed, 1e-5, 1e8), 1)}});
  return claims.in_order();
}

}  // namespace oddity::ex08_05
