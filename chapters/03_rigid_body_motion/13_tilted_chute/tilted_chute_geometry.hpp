#pragma once

// The claims of exercise 3.13 about the cylinder, its axis and its height, and their random samples.

#include "chapters/03_rigid_body_motion/13_tilted_chute/tilted_chute.hpp"
#include "chapters/03_rigid_body_motion/shared/lagrangian.hpp"
#include "reference/text.hpp"

namespace oddity::tilted_chute {

using Point = std::array<double, 3>;

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point sum(const Point& a, const Point& b, double factor = 1) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point unit(const Point& a) { return sum({}, a, 1 / std::sqrt(dot(a, a))); }

/// Y^T (I + sign D D^T) Y with the matrix written out.
inline double quadratic(const Point& y, const Point& d, double sign = -1) {
  double total = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) total += y[i] * ((i == j ? 1 : 0) + sign * d[i] * d[j]) * y[j];
  return total;
}

/// A point X of a cylinder about P + t D: along the axis, then R away from it. U, V, D are orthonormal.
struct OnCylinder {
  double R, t;
  Point P, D, U, V, X, Y;

  explicit OnCylinder(Random& random)
      : R(random.between(0.2, 3)),
        t(random.magnitude(0.1, 3)),
        P(random.point(3)),
        D(random.direction()),
        U(unit(cross(D, random.direction()))),
        V(cross(D, U)),
        X(sum(sum(P, D, t), unit(cross(D, random.direction())), R)),
        Y(sum(X, P, -1)) {}
  std::vector<double*> letters() {
    std::vector<double*> all{&R, &t};
    for (Point* point : {&P, &D, &U, &V, &X, &Y})
      for (double& x : *point) all.push_back(&x);
    return all;
  }
  std::string where() const { return "R = " + rounded(R, 4) + ", t = " + rounded(t, 4); }
  double y1() const { return dot(U, Y); }
  double y2() const { return dot(V, Y); }
  double y3() const { return dot(D, Y); }
};

/// A chute, a place and a velocity in the plane, a friction, an angle and a way along the axis.
struct OnChute {
  Chute<double> chute;
  double g, x1, x2, x3, v1, v2, k, phi, way;

  explicit OnChute(Random& random)
      : chute{random.between(0.5, 3), random.between(2, 10), 0},
        g(random.between(0.5, 20)),
        x1(random.magnitude(0.05, 3)),
        x2(chute.R * random.magnitude(0.05, 0.9)),
        x3(random.magnitude(0.05, 3)),
        v1(random.magnitude(0.05, 3)),
        v2(random.magnitude(0.05, 3)),
        k(random.between(0.1, 2)),
        phi(random.magnitude(0.05, 1.4)),
        way(random.magnitude(0.05, 3)) {
    chute.H = chute.L * std::sin(random.between(0.1, 1.4));
  }
  double cosine() const { return std::sqrt(chute.L * chute.L - chute.H * chute.H) / chute.L; }
  double theta() const { return std::asin(chute.H / chute.L); }
  std::array<double*, 12> letters() {
    return {&chute.R, &chute.L, &chute.H, &g, &x1, &x2, &x3, &v1, &v2, &k, &phi, &way};
  }
  std::string where() const {
    return "theta = " + rounded(theta(), 4) + ", R = " + rounded(chute.R, 4) + ", x2 = " + rounded(x2, 4) +
           ", v = (" + rounded(v1, 4) + ", " + rounded(v2, 4) + ")";
  }
  /// (x1'', x2'') from the Lagrangian of the height, with friction and a side wind over the mass.
  Value accelerations(double friction = 0, double wind = 0) const {
    using D = Dual<double>;
    const double n1 = chute.height(D(x1, 1), D(x2)).slope, n2 = chute.height(D(x1), D(x2, 1)).slope;
    const double rise = chute.height(D(x1, v1), D(x2, v2)).slope;
    const Pair force{-friction * (v1 + n1 * rise), wind - friction * (v2 + n2 * rise)};
    return lagrange_accelerations(height_field::Lagrangian<Chute<double>>{chute, g}, {x1, x2}, {v1, v2},
                                  force);
  }
  /// The same without forces from the Lagrangian in the way along the axis and the angle about it.
  Value accelerations_about_axis() const {
    const double angle = std::asin(x2 / chute.R), turning = v2 / (chute.R * std::cos(angle));
    const double along = (x1 - chute.R * (1 - std::cos(angle)) * chute.s()) / chute.c();
    const double speed = (v1 - chute.R * std::sin(angle) * turning * chute.s()) / chute.c();
    const Pair a = lagrange_accelerations(AlongAndAbout{chute, g}, {along, angle}, {speed, turning});
    const auto x = [&](std::size_t i) {
      return [&, i](const auto& t) {
        return chute.position(along + speed * t + 0.5 * a[0] * t * t,
                              angle + turning * t + 0.5 * a[1] * t * t)[i];
      };
    };
    return {second_derivative(x(0), 0.0), second_derivative(x(1), 0.0)};
  }

  double d1() const { return -cosine(); }
  double d3() const { return chute.H / chute.L; }
  double p3() const { return chute.R / cosine(); }
  /// Any point against the cylinder.
  double excess() const { return quadratic({x1, x2, x3 - p3()}, {d1(), 0, d3()}) - chute.R * chute.R; }
  /// A point of the chute's half of the cylinder, or, turned by pi, of the other.
  Point on_it(bool other_half = false) const {
    return chute.position(way, other_half ? phi + std::numbers::pi : phi);
  }
  double bracket(const Point& x) const { return d1() * (x[2] - p3()) - d3() * x[0]; }
  double depth_at(const Point& x) const { return std::sqrt(chute.R * chute.R - x[1] * x[1]); }
};

// ---- the cylinder -----------------------------------------------------------------------------------------

inline std::vector<Claim> cylinder(double seed) {
  using S = const OnCylinder&;
  using V = Version<OnCylinder>;
  std::vector<Claim> all;
  const auto says = [&](const std::string& id, int line, const std::string& what, const V& printed,
                        const V& truth, const std::vector<V>& near) {
    all.push_back(formula_claim<OnCylinder>("3.13-" + id, line, what, seed, printed, truth, near));
    all.back().says = what;
  };
  const V square{"R^2, the point having been put R from the axis", [](S s) { return values(s.R * s.R); }};
  says("cylinder", 1587, "(X - P)^T (I - D D^T) (X - P) = R^2 on the cylinder",
       {"(X - P)^T (I - D D^T) (X - P)", [](S s) { return values(quadratic(s.Y, s.D)); }}, square,
       {{"I + D D^T", [](S s) { return values(quadratic(s.Y, s.D, 1)); }},
        {"X for X - P", [](S s) { return values(quadratic(s.X, s.D)); }}});
  says("coordinates", 1595, "X = P + y1 U + y2 V + y3 D with the products of X - P",
       {"P + y1 U + y2 V + y3 D",
        [](S s) { return Value(sum(sum(sum(s.P, s.U, s.y1()), s.V, s.y2()), s.D, s.y3())); }},
       {"X", [](S s) { return Value(s.X); }},
       {{"y3 with the product of X",
         [](S s) { return Value(sum(sum(sum(s.P, s.U, s.y1()), s.V, s.y2()), s.D, dot(s.D, s.X))); }}});
  says("distance", 1597, "y1^2 + y2^2 = R^2",
       {"y1^2 + y2^2", [](S s) { return values(s.y1() * s.y1() + s.y2() * s.y2()); }}, square,
       {{"y1^2 + y3^2", [](S s) { return values(s.y1() * s.y1() + s.y3() * s.y3()); }}});
  says("perpendicular", 1599, "y1 U + y2 V = (X - P) - (D.(X - P)) D",
       {"(X - P) - (D.(X - P)) D", [](S s) { return Value(sum(s.Y, s.D, -s.y3())); }},
       {"y1 U + y2 V", [](S s) { return Value(sum(sum({}, s.U, s.y1()), s.V, s.y2())); }},
       {{"plus", [](S s) { return Value(sum(s.Y, s.D, s.y3())); }}});
  says("squared_left", 1601, "|y1 U + y2 V|^2 = y1^2 + y2^2",
       {"y1^2 + y2^2", [](S s) { return values(s.y1() * s.y1() + s.y2() * s.y2()); }},
       {"|y1 U + y2 V|^2",
        [](S s) {
          const Point w = sum(sum({}, s.U, s.y1()), s.V, s.y2());
          return values(dot(w, w));
        }},
       {{"(y1 + y2)^2", [](S s) { return values(std::pow(s.y1() + s.y2(), 2)); }}});
  const auto row = [&](const std::string& id, int line, const V& printed, const V& near) {
    says(id, line, printed.text + " = R^2", printed, square, {near});
  };
  row("squared_right", 1603,
      {"|(X - P) - (D.(X - P)) D|^2",
       [](S s) {
         const Point w = sum(s.Y, s.D, -s.y3());
         return values(dot(w, w));
       }},
      {"|X - P|^2", [](S s) { return values(dot(s.Y, s.Y)); }});
  const auto opened = [](double minus, double plus) {
    return [=](S s) {
      return values(dot(s.Y, s.Y) - minus * s.y3() * s.y3() + plus * s.y3() * s.y3() * dot(s.D, s.D));
    };
  };
  row("opened", 1605, {"(X-P).(X-P) - 2 (D.(X-P))^2 + (D.(X-P))^2 (D.D)", opened(2, 1)},
      {"1 for 2", opened(1, 1)});
  row("gathered", 1607, {"(X-P).(X-P) - (D.(X-P))^2", opened(1, 0)}, {"2 (D.(X-P))^2", opened(2, 0)});
  row("rows_and_columns", 1609,
      {"(X-P)^T (X-P) - ((X-P)^T D) (D^T (X-P))",
       [](S s) { return values(dot(s.Y, s.Y) - dot(s.Y, s.D) * dot(s.D, s.Y)); }},
      {"plus", [](S s) { return values(dot(s.Y, s.Y) + dot(s.Y, s.D) * dot(s.D, s.Y)); }});
  const auto matrices = [](double dyad) {
    return [=](S s) {
      double identity = 0, outer = 0;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          identity += s.Y[i] * (i == j ? 1 : 0) * s.Y[j];
          outer += s.Y[i] * (s.D[i] * s.D[j]) * s.Y[j];
        }
      return values(identity - dyad * outer);
    };
  };
  row("matrices", 1611, {"(X-P)^T I (X-P) - (X-P)^T (D D^T) (X-P)", matrices(1)},
      {"without the second term", matrices(0)});
  row("one_matrix", 1613, {"(X-P)^T (I - D D^T) (X-P)", [](S s) { return values(quadratic(s.Y, s.D)); }},
      {"(X-P)^T (D D^T - I) (X-P)", [](S s) { return values(-quadratic(s.Y, s.D)); }});
  return all;
}

// ---- the axis ---------------------------------------------------------------------------------------------

inline std::vector<Claim> axis(double seed) {
  using S = const OnChute&;
  using V = Version<OnChute>;
  std::vector<Claim> all;
  const auto says = [&](const std::string& id, int line, const std::string& what, const V& printed,
                        const V& truth, const std::vector<V>& near) {
    all.push_back(formula_claim<OnChute>("3.13-" + id, line, what, seed, printed, truth, near));
    all.back().says = what;
  };
  says("triangle", 1617, "where x3 rises by H, x1 falls by L cos(theta), over the length L",
       {"|(-L cos(theta), H)| and H",
        [](S s) { return values(std::hypot(s.chute.L * std::cos(s.theta()), s.chute.H), s.chute.H); }},
       {"L and L sin(theta)", [](S s) { return values(s.chute.L, s.chute.L * std::sin(s.theta())); }},
       {{"L sin(theta) for L cos(theta)",
         [](S s) { return values(std::hypot(s.chute.L * std::sin(s.theta()), s.chute.H), s.chute.H); }}});
  says("adjacent", 1619, "the adjacent side is sqrt(L^2 - H^2)",
       {"sqrt(L^2 - H^2)",
        [](S s) { return values(std::sqrt(s.chute.L * s.chute.L - s.chute.H * s.chute.H)); }},
       {"L cos(theta)", [](S s) { return values(s.chute.L * std::cos(s.theta())); }},
       {{"sqrt(L^2 + H^2)", [](S s) { return values(std::hypot(s.chute.L, s.chute.H)); }}});
  says("cosine", 1621, "cos(theta) = sqrt(L^2 - H^2)/L",
       {"sqrt(L^2 - H^2)/L", [](S s) { return values(s.cosine()); }},
       {"cos(asin(H/L))", [](S s) { return values(std::cos(s.theta())); }},
       {{"L/sqrt(L^2 - H^2)", [](S s) { return values(1 / s.cosine()); }}});
  says("sine", 1621, "sin(theta) = H/L", {"H/L", [](S s) { return values(s.chute.H / s.chute.L); }},
       {"sine of the angle between the chute and the plane",
        [](S s) {
          const double run = std::sqrt((s.chute.L - s.chute.H) * (s.chute.L + s.chute.H));
          return values(std::sin(std::atan2(s.chute.H, run)));
        }},
       {{"L/H", [](S s) { return values(s.chute.L / s.chute.H); }}});
  says("direction", 1623, "D = (-cos(theta), 0, sin(theta)) is the unit vector up the axis",
       {"(-cos(theta), 0, sin(theta))",
        [](S s) { return values(-std::cos(s.theta()), 0, std::sin(s.theta())); }},
       {"(-sqrt(L^2 - H^2), 0, H), normalized",
        [](S s) {
          return Value(unit({-std::sqrt((s.chute.L - s.chute.H) * (s.chute.L + s.chute.H)), 0, s.chute.H}));
        }},
       {{"(cos(theta), 0, sin(theta))",
         [](S s) { return values(std::cos(s.theta()), 0, std::sin(s.theta())); }}});
  const auto distance = [](const auto& height) {
    return [=](S s) {
      const Point w = cross({0, 0, height(s)}, {-std::cos(s.theta()), 0, std::sin(s.theta())});
      return values(std::sqrt(dot(w, w)));
    };
  };
  says("axis_point", 1631, "the axis passes R/cos(theta) above the origin, which is R from it",
       {"|(0, 0, R/cos(theta)) x D|", distance([](S s) { return s.p3(); })},
       {"R", [](S s) { return values(s.chute.R); }},
       {{"height R cos(theta)", distance([](S s) { return s.chute.R * s.cosine(); })},
        {"height R", distance([](S s) { return s.chute.R; })}});
  return all;
}

// ---- the cylinder solved for x3 ---------------------------------------------------------------------------

inline std::vector<Claim> solved(double seed) {
  using S = const OnChute&;
  using V = Version<OnChute>;
  std::vector<Claim> all;
  const auto says = [&](const std::string& id, int line, const std::string& what, const V& printed,
                        const V& truth, const std::vector<V>& near) {
    all.push_back(formula_claim<OnChute>("3.13-" + id, line, what, seed, printed, truth, near));
    all.back().says = what;
  };
  const V form{"(X - P)^T (I - D D^T) (X - P) - R^2", [](S s) { return values(s.excess()); }};
  const auto last_is_misprint = [&](const V& meant, const std::string& why) {
    all.back().meant = {meant.text, {compare("the equation's right-hand side", meant, form, seed)}};
    all.back().why = why;
  };
  const auto expanded = [](double sign, double R2) {
    return [=](S s) {
      const double z = s.x3 - s.p3(), along = s.d1() * s.x1 + sign * s.d3() * z;
      return values(s.x1 * s.x1 + s.x2 * s.x2 + z * z - along * along - R2 * s.chute.R * s.chute.R);
    };
  };
  says("expansion_1", 1637,
       "the cylinder's equation is 0 = x1^2 + x2^2 + (x3 - p3)^2 - (d1 x1 + d3 (x3 - p3))^2",
       {"x1^2 + x2^2 + (x3 - p3)^2 - (d1 x1 + d3 (x3 - p3))^2", expanded(1, 0)}, form,
       {{"d1 x1 - d3 (x3 - p3)", expanded(-1, 1)}});
  last_is_misprint(
      {"the same, less R^2", expanded(1, 1)},
      "The term $-R^2$, there in the lines before and after, is left out: so read it is the axis alone "
      "that satisfies the equation.");
  const auto by_powers = [](const auto& first) {
    return [=](S s) {
      const double z = s.x3 - s.p3(), d1 = s.d1(), d3 = s.d3();
      return values(first(d3) * z * z - 2 * d1 * d3 * s.x1 * z + (1 - d1 * d1) * s.x1 * s.x1 + s.x2 * s.x2 -
                    s.chute.R * s.chute.R);
    };
  };
  says("expansion_2", 1639,
       "by powers of x3 - p3 it is 0 = (1 - d3)^2 (x3 - p3)^2 - 2 d1 d3 x1 (x3 - p3) + (1 - d1^2) x1^2 + "
       "x2^2 - R^2",
       {"(1 - d3)^2 (x3 - p3)^2 - ...", by_powers([](double d) { return (1 - d) * (1 - d); })}, form,
       {{"(1 + d3^2)", by_powers([](double d) { return 1 + d * d; })}});
  last_is_misprint(
      {"(1 - d3^2) (x3 - p3)^2 - ...", by_powers([](double d) { return 1 - d * d; })},
      "The square belongs to $d_3$: $(1-d_3^2)$, which the next line writes as $d_1^2$. With the "
      "default chute, $d_3=3/5$, that is 0.64, and what is printed 0.16.");
  const auto by_parts = [](double middle) {
    return [=](S s) {
      const double z = s.x3 - s.p3(), d1 = s.d1(), d3 = s.d3();
      return values(d1 * d1 * z * z - middle * d1 * d3 * s.x1 * z + d3 * d3 * s.x1 * s.x1 + s.x2 * s.x2 -
                    s.chute.R * s.chute.R);
    };
  };
  says("expansion_3", 1641,
       "with d1^2 + d3^2 = 1 it is 0 = d1^2 (x3 - p3)^2 - 2 d1 d3 x1 (x3 - p3) + d3^2 x1^2 + x2^2 - R^2",
       {"d1^2 (x3 - p3)^2 - 2 d1 d3 x1 (x3 - p3) + d3^2 x1^2 + x2^2 - R^2", by_parts(2)}, form,
       {{"plus in the middle", by_parts(-2)}});
  const auto completed = [](double sign) {
    return [=](S s) {
      const double b = s.d1() * (s.x3 - s.p3()) - sign * s.d3() * s.x1;
      return values(b * b + s.x2 * s.x2 - s.chute.R * s.chute.R);
    };
  };
  says("expansion_4", 1643, "and with a square 0 = (d1 (x3 - p3) - d3 x1)^2 + x2^2 - R^2",
       {"(d1 (x3 - p3) - d3 x1)^2 + x2^2 - R^2", completed(1)}, form, {{"plus d3 x1", completed(-1)}});

  says("two_roots", 1647, "on the cylinder d1 (x3 - p3) - d3 x1 = +-sqrt(R^2 - x2^2)",
       {"+ and -sqrt(R^2 - x2^2)",
        [](S s) { return values(s.depth_at(s.on_it()), -s.depth_at(s.on_it(true))); }},
       {"d1 (x3 - p3) - d3 x1 on the lower half and on the upper",
        [](S s) { return values(s.bracket(s.on_it()), s.bracket(s.on_it(true))); }},
       {{"the same sign on both",
         [](S s) { return values(s.depth_at(s.on_it()), s.depth_at(s.on_it(true))); }}});
  const auto origin = [](double height) {
    return [=](S s) { return values(quadratic({0, 0, -height * s.p3()}, {s.d1(), 0, s.d3()})); };
  };
  const V square{"R^2", [](S s) { return values(s.chute.R * s.chute.R); }};
  says("origin", 1649, "the origin is on the cylinder", {"its equation at (0, 0, 0)", origin(1)}, square,
       {{"with the axis half as high", origin(0.5)}});
  says(
      "at_origin", 1651, "at the origin cos(theta) (R/cos(theta)) = -d1 p3 = +-R",
      {"the two products",
       [](S s) { return values(std::cos(s.theta()) * (s.chute.R / std::cos(s.theta())), -s.d1() * s.p3()); }},
      {"d1 (x3 - p3) - d3 x1 at (0, 0, 0), and R",
       [](S s) {
         return values(s.bracket({0, 0, 0}), s.chute.R);
       }},
      {{"d1 p3", [](S s) { return values(s.chute.R, s.d1() * s.p3()); }}});
  const auto root_at = [](double sign, const Point& x) {
    return [=](S s) { return values(sign * s.depth_at(x)); };
  };
  says("plus", 1653, "the origin needs the plus sign", {"+sqrt(R^2 - 0)", root_at(1, {})},
       {"d1 (x3 - p3) - d3 x1 at (0, 0, 0)",
        [](S s) {
          return values(s.bracket({0, 0, 0}));
        }},
       {{"-sqrt(R^2 - 0)", root_at(-1, {})}});
  says("chute", 1655, "d1 (x3 - p3) - d3 x1 = sqrt(R^2 - x2^2) on the chute",
       {"+sqrt(R^2 - x2^2)", [](S s) { return values(s.depth_at(s.on_it())); }},
       {"d1 (x3 - p3) - d3 x1 on the lower half", [](S s) { return values(s.bracket(s.on_it())); }},
       {{"-sqrt(R^2 - x2^2)", [](S s) { return values(-s.depth_at(s.on_it())); }}});
  const V x3{"x3 of a point turned about the axis", [](S s) { return values(s.on_it()[2]); }};
  const auto from_axis = [](double sign) {
    return [=](S s) {
      const Point x = s.on_it();
      return values(s.p3() + (sign * s.d3() * x[0] + s.depth_at(x)) / s.d1());
    };
  };
  says("solved", 1659, "x3 = p3 + (d3 x1 + sqrt(R^2 - x2^2))/d1",
       {"p3 + (d3 x1 + sqrt(R^2 - x2^2))/d1", from_axis(1)}, x3, {{"-d3 x1", from_axis(-1)}});
  const auto height = [](double fall, double depth) {
    return [=](S s) {
      const Point x = s.on_it();
      const auto& [R, L, H] = s.chute;
      return values((L * R - fall * H * x[0] - depth * L * s.depth_at(x)) / (L * s.cosine()));
    };
  };
  says("height", 1663, "the height of the chute is (L R - H x1 - L sqrt(R^2 - x2^2))/(L cos(theta))",
       {"(L R - H x1 - L sqrt(R^2 - x2^2))/(L cos(theta))", height(1, 1)}, x3,
       {{"+ H x1", height(-1, 1)}, {"+ L sqrt(R^2 - x2^2)", height(1, -1)}});
  return all;
}

}  // namespace oddity::tilted_chute
