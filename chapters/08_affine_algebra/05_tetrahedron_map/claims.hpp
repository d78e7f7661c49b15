#pragma once

#include "chapters/08_affine_algebra/05_tetrahedron_map/tetrahedron.hpp"
#include "chapters/exercise.hpp"
#include "chapters/random.hpp"
#include "reference/text.hpp"
#include "solvers/linear.hpp"

/// The lines of the book's derivation on random tetrahedra, coefficients by volumes.
namespace oddity::tetrahedra {

struct Sample {
  Tetrahedron t;
  Vector3d p;
  Affine f;
  double condition;

  Vector3d c() const { return by_volumes(t, p); }
  double c0() const {
    return triple<double>(t.p[1] - p, t.p[2] - p, t.p[3] - p) / triple(t.edge(1), t.edge(2), t.edge(3));
  }
  /// Of what the volumes' cancellations can do to a sum of terms of size x.
  double scale(double x) const { return condition * x; }
};

inline Vector3d vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

/// Random tetrahedra of edges' condition below `most`, the apex let down to `height`, P inside and outside.
inline std::vector<Sample> samples(double seed, double height, double most) {
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

/// left(sample) against right(sample), vectors whose terms are of size terms(sample).
template <class Left, class Right, class Terms>
inline Check compare(const std::vector<Sample>& all, std::string what, const std::string& by_left,
                     const std::string& by_right, const Left& left, const Right& right, const Terms& terms) {
  Worst worst(std::move(what) + ", " + by_left + " against " + by_right, by_left, by_right);
  for (const Sample& s : all)
    worst.see(Value(left(s)), Value(right(s)), s.scale(terms(s)), "condition " + rounded(s.condition, 3));
  return worst.check();
}

inline double extent(const Sample& s) {
  double size = s.p.cwiseAbs().maxCoeff();
  for (const Vector3d& vertex : s.t.p) size = std::max(size, vertex.cwiseAbs().maxCoeff());
  return size * (1 + std::abs(s.c0()) + s.c().cwiseAbs().sum());
}

/// (sum c_i P_i, weight of c0 + the other three): four volumes, each with its own face.
inline Claim barycentric(const std::vector<Sample>& all) {
  const auto check = [&](double sign) {
    return compare(
        all, "sum c_i P_i and sum c_i", "four ratios of volumes", "P and 1",
        [&](const Sample& s) {
          Eigen::Vector4d sum;
          sum << sign * s.c0() * s.t.p[0], sign * s.c0();
          for (std::size_t i = 1; i < 4; ++i) {
            Eigen::Vector4d term;
            term << s.t.p[i], 1;
            sum += s.c()[static_cast<long>(i) - 1] * term;
          }
          return sum;
        },
        [](const Sample& s) {
          Eigen::Vector4d one;
          one << s.p, 1;
          return one;
        },
        [](const Sample& s) { return 1 + extent(s); });
  };
  return {"8.5-barycentric",
          4003,
          "P is a sum of the vertices with coefficients that add up to 1",
          {"P = sum c_i P_i, sum c_i = 1", {check(1)}},
          {},
          {},
          {{"c0 of the other sign", {check(-1)}}}};
}

inline Claim affine(const std::vector<Sample>& all) {
  const auto check = [&](double with_c0, double bend) {
    const auto f = [bend](const Sample& s, const Vector3d& x) { return s.f(x) + bend * x.dot(x); };
    return compare(
        all, "f(P)", "the map", "c0 f0 + c1 f1 + c2 f2 + c3 f3", [&](const Sample& s) { return f(s, s.p); },
        [&](const Sample& s) {
          double sum = with_c0 * s.c0() * f(s, s.t.p[0]);
          for (std::size_t i = 1; i < 4; ++i) sum += s.c()[static_cast<long>(i) - 1] * f(s, s.t.p[i]);
          return sum;
        },
        [](const Sample& s) { return 10 * extent(s) + 3 * (1 + s.c().cwiseAbs().sum()); });
  };
  return {"8.5-affine",
          4007,
          "the four values determine f everywhere: f(P) = sum c_i f_i",
          {"f(P) = sum c_i f_i", {check(1, 0)}},
          {},
          {},
          {{"without c0 f0", {check(0, 0)}}, {"for f with a quadratic term", {check(1, 1)}}}};
}

inline Claim first_coefficient(const std::vector<Sample>& all) {
  const auto check = [&](double shift) {
    return compare(
        all, "c0 - 1", "the volume over the face opposite to P0", "-c1 - c2 - c3",
        [&](const Sample& s) { return s.c0() + shift; }, [](const Sample& s) { return -s.c().sum(); },
        [](const Sample& s) { return 1 + s.c().cwiseAbs().sum(); });
  };
  return {"8.5-first_coefficient", 4011, "c0 - 1 = -c1 - c2 - c3", {"as printed", {check(-1)}}, {}, {},
          {{"c0 + 1", {check(1)}}}};
}

inline Claim edge_sum(const std::vector<Sample>& all) {
  const auto check = [&](bool of_edges) {
    return compare(
        all, "V = P - P0", "difference", of_edges ? "c1 V1 + c2 V2 + c3 V3" : "c1 P1 + c2 P2 + c3 P3",
        [](const Sample& s) { return Vector3d(s.p - s.t.p[0]); },
        [&](const Sample& s) {
          Vector3d sum = Vector3d::Zero();
          for (std::size_t i = 1; i < 4; ++i)
            sum += s.c()[static_cast<long>(i) - 1] * (of_edges ? s.t.edge(i) : s.t.p[i]);
          return sum;
        },
        extent);
  };
  return {"8.5-edge_sum",
          4013,
          "V = c1 V1 + c2 V2 + c3 V3",
          {"with the edges", {check(true)}},
          {},
          {},
          {{"with the vertices", {check(false)}}}};
}

/// Entry by entry as displayed, applied to the volumes' coefficients.
inline Claim normal_equations(const std::vector<Sample>& all) {
  const auto check = [&](bool from_origin, double off_diagonal) {
    return compare(
        all, "matrix times (c1, c2, c3)", "sum over j of (V_i . V_j) c_j",
        from_origin ? "V_i . P" : "V_i . V",
        [&](const Sample& s) {
          Vector3d rows = Vector3d::Zero();
          for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
              rows[static_cast<long>(i)] += (i == j ? 1 : off_diagonal) *
                                            s.t.edge(i + 1).dot(s.t.edge(j + 1)) *
                                            s.c()[static_cast<long>(j)];
          return rows;
        },
        [&](const Sample& s) {
          return Vector3d(s.t.edges().transpose() * (from_origin ? s.p : Vector3d(s.p - s.t.p[0])));
        },
        [](const Sample& s) { return 3 * s.t.edges().cwiseAbs().maxCoeff() * extent(s); });
  };
  return {"8.5-normal_equations",
          4015,
          "the 3x3 system of dot products determines c1, c2, c3",
          {"as displayed", {check(false, 1)}},
          {},
          {},
          {{"V_i . P on the right", {check(true, 1)}}, {"off-diagonal signs flipped", {check(false, -1)}}}};
}

/// In integers: det [V_i . V_j] is the square of det [V1 V2 V3], and not 0 unless that is.
inline Claim invertible(double seed) {
  using Row = std::array<long long, 3>;
  const auto det = [](const std::array<Row, 3>& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  Random random(seed);
  long not_square = 0, not_volume = 0, singular = 0, singular_flat = 0;
  const long count = 500;
  for (long n = 0; n < count; ++n) {
    std::array<Row, 3> v, flattened, gram, gram_flat;
    do
      for (Row& row : v)
        for (long long& x : row) x = random.below(201) - 100;
    while (det(v) == 0);
    flattened = v;
    for (std::size_t a = 0; a < 3; ++a) flattened[2][a] = 2 * v[0][a] - v[1][a];
    const auto products = [](const std::array<Row, 3>& e, std::array<Row, 3>& g) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          g[i][j] = e[i][0] * e[j][0] + e[i][1] * e[j][1] + e[i][2] * e[j][2];
    };
    products(v, gram);
    products(flattened, gram_flat);
    not_square += det(gram) != det(v) * det(v);
    not_volume += det(gram) != std::abs(det(v));
    singular += det(gram) <= 0;
    singular_flat += det(gram_flat) <= 0;
  }
  return {"8.5-invertible",
          4035,
          "the matrix is invertible, the edges of a tetrahedron being independent",
          {"det = (6 volumes)^2 > 0",
           {never("tetrahedra with det [V_i . V_j] not (det [V1 V2 V3])^2, in integers", not_square, count),
            never("tetrahedra with det [V_i . V_j] <= 0", singular, count)}},
          {},
          {},
          {{"det = 6 volumes",
            {never("tetrahedra with det [V_i . V_j] not |det [V1 V2 V3]|", not_volume, count)}},
           {"for four vertices in a plane too",
            {never("tetrahedra with det [V_i . V_j] <= 0", singular_flat, count)}}}};
}

/// The printed system by elimination, allowed the roundings that `power` of the condition number makes of
/// one.
inline Check elimination(const std::vector<Sample>& all, double power) {
  Worst worst("c1, c2, c3, by elimination against ratios of volumes", "elimination of the normal equations",
              "ratios of volumes");
  for (const Sample& s : all) {
    const Matrix3d v = s.t.edges();
    const auto c =
        solve(Factorization::partial_pivot_lu, v.transpose() * v, v.transpose() * (s.p - s.t.p[0]));
    const double size = 1 + s.c().cwiseAbs().maxCoeff();
    worst.see(c.value, s.c(), rounding(size * std::pow(s.condition, power)), size,
              "condition " + rounded(s.condition, 3));
  }
  return worst.check();
}

inline Claim gauss(double seed) {
  return {"8.5-gauss",
          4035,
          "standard Gaussian elimination solves the system",
          {"to roundings times the condition number squared, condition below 50",
           {elimination(samples(seed, 1, 50), 2)}},
          {},
          {},
          {{"slivers, to roundings times the condition number", {elimination(samples(seed, 1e-5, 1e8), 1)}}}};
}

inline std::vector<Claim> claims(double seed) {
  const auto all = samples(seed, 1, 50);
  return {barycentric(all), affine(all), first_coefficient(all), edge_sum(all), normal_equations(all),
          invertible(seed), gauss(seed)};
}

}  // namespace oddity::tetrahedra
