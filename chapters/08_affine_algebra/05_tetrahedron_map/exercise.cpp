// Exercise 8.5: an affine map f is known at the four vertices of a tetrahedron; what is f(P)?
//   P = sum c_i P_i, sum c_i = 1, f(P) = sum c_i f_i, and with V_i = P_i - P_0, V = P - P_0
//   [V_i . V_j] c = [V_i . V]                                the book's normal equations
//   [V_1 V_2 V_3] c = V                                      the edges themselves
// Independent routes: ratios of signed volumes; the map f(P) = A . P + b itself; exact integers. The
// condition of the normal equations' matrix is the square of the edges' [Higham, Accuracy and Stability, 2nd
// ed., ch. 20].

#include <limits>
#include <string>

#include "chapters/08_affine_algebra/05_tetrahedron_map/tetrahedron_map.hpp"
#include "chapters/inputs.hpp"
#include "solvers/counted.hpp"
#include "solvers/linear.hpp"

namespace oddity {

namespace ex08_05 {

constexpr auto parameters = together(
    std::array{
        Parameter{"height", 1, "", "height of the apex over its base, in units of the base", 0.0625, 1},
        Parameter{"c1", 0.25, "", "barycentric coordinate of $P$ at $P_1$", -4, 4},
        Parameter{"c2", 0.375, "", "barycentric coordinate of $P$ at $P_2$", -4, 4},
        Parameter{"c3", 0.125, "", "barycentric coordinate of $P$ at $P_3$", -4, 4},
        Parameter{"seed", 1, "", "seed of the random tetrahedra", 0, 1e9, whole_number}},
    numbers<3>({"p0x", "p0y", "p0z"}, {1, 2, -1}, "", "vertex $P_0$ of a tetrahedron that you choose", 1e3),
    numbers<3>({"p1x", "p1y", "p1z"}, {5, 2, -1}, "", "vertex $P_1$", 1e3),
    numbers<3>({"p2x", "p2y", "p2z"}, {3, 6, 1}, "", "vertex $P_2$", 1e3),
    numbers<3>({"p3x", "p3y", "p3z"}, {2, 3, 4}, "", "vertex $P_3$", 1e3));

// ---- f(P) -------------------------------------------------------------------------------------------------

/// Vertices and map with few binary digits, so that vertices, points and values are exact.
Tetrahedron tetrahedron(double height) {
  const Vector3d p0(1.0625, 2.3125, -0.9375), v1 = Vector3d(3217, 1021, 2053) / 1024,
                                              v2 = Vector3d(-1171, 2237, 997) / 1024;
  return {{p0, p0 + v1, p0 + v2, p0 + 0.5 * v1 + 0.25 * v2 + height * Vector3d(-0.75, -1.25, 2)}};
}

/// All four vertices in a plane, and every elimination exact: the last pivot is exactly 0.
Tetrahedron flat() {
  const Vector3d p0(1, 2, -1), v1(4, 0, 0), v2(2, 4, 2);
  return {{p0, p0 + v1, p0 + v2, p0 + 0.5 * v1 + 0.25 * v2}};
}

const Affine map{Vector3d(2, -3, 1), 5};

struct Problem {
  Tetrahedron t;
  std::vector<Vector3d> points;

  Problem(Tetrahedron tetra, const std::vector<Vector3d>& coordinates) : t(std::move(tetra)) {
    for (const Vector3d& c : coordinates) points.push_back(t.p[0] + t.edges() * c);
  }
};

/// c0 f0 + c1 f1 + c2 f2 + c3 f3.
template <class T>
T blended(const Vector<T>& c, const std::array<T, 4>& f) {
  return (T(1.0) - c.sum()) * f[0] + c[0] * f[1] + c[1] * f[2] + c[2] * f[3];
}

using Number = Counted<double>;

Vector<Number> counted(const Vector3d& x) { return x.cast<Number>(); }

/// f at all points, from three coordinates found by `find`, with `extra` multiplications per point.
template <class Find>
Answer values(const Problem& problem, long extra, const Find& find) {
  const auto& p = problem.t.p;
  const std::array<double, 4> known{map(p[0]), map(p[1]), map(p[2]), map(p[3])};
  extra += operations_of([] { return blended(Vector<Number>(0.0, 0.0, 0.0), {}); }).all_but_additions();
  Answer all;
  std::vector<double> f;
  for (const Vector3d& x : problem.points) {
    const Solved<VectorXd> c = find(x);
    all.evaluations += c.evaluations + extra;
    if (!c.reached()) {
      all.ending = c.ending;
      all.message = c.message;
      return all;
    }
    f.push_back(blended<double>(c.value, known));
  }
  all.value = Value(std::move(f));
  return all;
}

Answer by_edges(const Problem& problem, Factorization how) {
  return values(problem, 0,
                [&](const Vector3d& x) { return solve(how, problem.t.edges(), x - problem.t.p[0]); });
}

Answer by_normal_equations(const Problem& problem, Factorization how) {
  const Matrix3d v = problem.t.edges();
  const Eigen::Matrix<Number, 3, 3> edges = v.cast<Number>();
  const Operations products = operations_of([&] {
    const Eigen::Matrix<Number, 3, 3> matrix = edges.transpose() * edges;
    const Vector<Number> right = edges.transpose() * edges.col(0);
    return matrix(0, 0) + right[0];
  });
  return values(problem, products.all_but_additions(), [&](const Vector3d& x) {
    return solve(how, v.transpose() * v, v.transpose() * (x - problem.t.p[0]));
  });
}

Answer by_four_equations(const Problem& problem) {
  Eigen::Matrix4d a;
  for (int i = 0; i < 4; ++i) a.col(i) << problem.t.p[static_cast<std::size_t>(i)], 1;
  return values(problem, 0, [&](const Vector3d& x) {
    Solved<VectorXd> c = solve(Factorization::partial_pivot_lu, a, Eigen::Vector4d(x[0], x[1], x[2], 1));
    c.value = c.value.tail(3).eval();
    return c;
  });
}

Answer by_signed_volumes(const Problem& problem) {
  const Number one = 1.0;
  const Vector<Number> v = Vector<Number>::Constant(one);
  const Operations each = operations_of([&] { return by_volumes(v, v, v, v); });
  return values(problem, each.all_but_additions(), [&](const Vector3d& x) {
    return Solved<VectorXd>{by_volumes(problem.t, x), 0};
  });
}

/// f's gradient from its differences along the edges, then f(P0) + gradient . V.
Answer by_gradient(const Problem& problem) {
  const auto& p = problem.t.p;
  const Vector3d differences(map(p[1]) - map(p[0]), map(p[2]) - map(p[0]), map(p[3]) - map(p[0]));
  const auto g = solve(Factorization::partial_pivot_lu, problem.t.edges().transpose(), differences);
  Answer all{{}, g.evaluations, std::numeric_limits<double>::quiet_NaN(), 0, g.ending, g.message};
  std::vector<double> f;
  for (const Vector3d& x : problem.points) f.push_back(map(p[0]) + g.value.dot(x - p[0]));
  const Operations each = operations_of([&] { return counted(p[0]).dot(counted(p[1])); });
  all.evaluations += each.all_but_additions() * static_cast<long>(f.size());
  all.value = Value(std::move(f));
  return all;
}

/// Uses the base alone: two coordinates from areas over the face, none for the apex.
Answer by_base(const Problem& problem) {
  const auto areas = []<class T>(const Vector<T>& v, const Vector<T>& v1, const Vector<T>& v2) {
    const Vector<T> n = cross(v1, v2);
    const T whole = n.dot(n);
    return Vector<T>(triple(n, v, v2) / whole, triple(n, v1, v) / whole, T(0.0));
  };
  const Vector3d v1 = problem.t.edge(1), v2 = problem.t.edge(2);
  const Operations each = operations_of([&] { return areas(counted(v1), counted(v1), counted(v2)); });
  return values(problem, each.all_but_additions(), [&](const Vector3d& x) {
    return Solved<VectorXd>{areas(Vector3d(x - problem.t.p[0]), v1, v2), 0};
  });
}

std::vector<Vector3d> points(const Parameters& p) {
  return {{p["c1"], p["c2"], p["c3"]}, {0.25, 0.25, 0.25}, {0.5, 0.375, 0}, {0, 0, 1}, {1.5, -0.25, 0.125}};
}

/// Expected outcomes of the methods.
struct Expected {
  Outcome normal = Outcome::ok, cholesky = Outcome::ok, volumes = Outcome::ok, edges = Outcome::ok;
  std::string why = {};
};

Quantity values_of(std::string name, std::string says, const Tetrahedron& tetra,
                   const std::vector<Vector3d>& coordinates, const Expected& expected) {
  const Problem problem(tetra, coordinates);
  std::vector<double> truth;
  double largest = 0, terms = 0;  // largest |f|; largest sum of sizes in A . P + b
  bool exact = true;
  for (const Vector3d& x : problem.points) {
    truth.push_back(map(x));
    largest = std::max(largest, std::abs(truth.back()));
    const long double in_full = map.a.cast<long double>().dot(x.cast<long double>()) + map.b;
    exact = exact && in_full == static_cast<long double>(truth.back());
    terms = std::max(terms, map.a.cwiseAbs().dot(x.cwiseAbs()) + std::abs(map.b));
  }
  Quantity q{std::move(name),
             "1",
             std::move(says),
             {R"(the map itself, $A\cdot P+b$)", truth},
             exact ? 0 : 4 * 0x1p-52 * terms,
             {std::max(1e-12, 0x1p-44 * largest), "a few hundred roundings of $f$"},
             {},
             {}};
  const auto add = [&](std::string model, std::string algorithm, Outcome outcome, const auto& find) {
    q.add({std::move(model), std::move(algorithm), no_resolution(), [=](double) { return find(problem); },
           outcome, outcome == Outcome::ok ? "" : expected.why});
  };
  using F = Factorization;
  const auto normal = [](F how) { return [how](const Problem& at) { return by_normal_equations(at, how); }; };
  const auto direct = [](F how) { return [how](const Problem& at) { return by_edges(at, how); }; };
  add("normal equations", "LU, partial pivoting", expected.normal, normal(F::partial_pivot_lu));
  add("normal equations", "Cholesky", expected.cholesky, normal(F::cholesky));
  add("edges", "LU, partial pivoting", expected.edges, direct(F::partial_pivot_lu));
  add("edges", "LU, full pivoting", expected.edges, direct(F::full_pivot_lu));
  add("edges", "signed volumes", expected.volumes, by_signed_volumes);
  if (expected.edges == Outcome::ok) {
    add("edges", "Householder QR", Outcome::ok, direct(F::householder_qr));
    add("vertices and sum 1", "LU, partial pivoting", Outcome::ok, by_four_equations);
    add("gradient", "LU, partial pivoting", Outcome::ok, by_gradient);
  } else {
    add("base", "areas", Outcome::ok, by_base);
  }
  return q;
}

std::vector<Quantity> quantities(const Parameters& p) {
  const Outcome ok = Outcome::ok, bad = Outcome::inaccurate, raised = Outcome::raised;
  const auto x = points(p);
  std::vector<Quantity> all;
  all.push_back(values_of("value", "$f$ at five points", tetrahedron(p["height"]), x, {}));
  Tetrahedron own;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto vertex = point_of(p, "p" + std::to_string(i));
    own.p[i] = Vector3d(vertex[0], vertex[1], vertex[2]);
  }
  all.push_back(
      values_of("value_in_own", "the same in a tetrahedron $P_0P_1P_2P_3$ that you choose", own, x, {}));
  constexpr double thin = 0x1p-20, thinner = 0x1p-30;
  const auto sliver = [](double height) {
    return filled("the same, the apex $2^{@2}$ above its base", {std::log2(height)});
  };
  all.push_back(values_of("sliver_value", sliver(thin), tetrahedron(thin), x,
                          {bad, bad, bad, ok, "products lose the small terms of the sliver"}));
  all.back().add(
      Breakdown{"The normal equations square the condition number, and $f(P)$ is off by rounding over "
                "height, $@1$, where the edges themselves err by $@1$. There a stable solve leaves a "
                "residual of one rounding, however thin the sliver.",
                "normal equations, LU, partial pivoting",
                0,
                bad,
                "edges, LU, partial pivoting",
                0,
                {error_of(Side::broken), error_of(Side::cured)}});
  all.push_back(values_of("sliver_30", sliver(thinner), tetrahedron(thinner), x,
                          {bad, raised, bad, ok, "products lose the small terms of the sliver"}));
  all.back().add(
      Breakdown{"At $2^{@2}$ the square of the height is below rounding: the matrix that cannot be "
                "singular is singular to Cholesky. The edges' own is not.",
                "normal equations, Cholesky",
                0,
                raised,
                "edges, Householder QR",
                0,
                {std::log2(thinner)}});
  all.push_back(values_of("flat_value", "four vertices in a plane", flat(), x,
                          {raised, raised, Outcome::non_finite, raised, "the edges are dependent"}));
  all.back().add(Breakdown{
      "Without a volume there are no unique coordinates; $f(P)$ is known all the same, from the base alone.",
      "edges, LU, full pivoting", 0, raised, "base, areas", 0});
  return all;
}

// ---- the exercise ----------------------------------------------------------------------------------------

Findings study(const Parameters& p, const Reference&) {
  return {claims(p["seed"]), in_operations(quantities(p))};
}

}  // namespace ex08_05

Exercise exercise_8_5() {
  using namespace ex08_05;
  return {
      "Affine map on a tetrahedron",
      "An affine map $f$ is known at the four vertices $P_i$ of a tetrahedron. Compute $f(P)$ for any point "
      "$P$, by its barycentric coordinates $c_i$. Below $V_i=P_i-P_0$ and $V=P-P_0$.",
      parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
