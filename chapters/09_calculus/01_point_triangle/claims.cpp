#include "chapters/claims.hpp"

#include "chapters/09_calculus/01_point_triangle/point_triangle.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

/// What the book says about the squared distance, on random triangles and points.
namespace oddity::ex09_01 {

namespace {

struct Sample {
  Triangle<double> w;
  double s, t, above;  ///< P's coordinates: V(s, t) + above * unit normal
  Vec<double> p;

  std::vector<double*> letters() {
    std::vector<double*> all{&s, &t};
    for (Vec<double>* point : {&w.v[0], &w.v[1], &w.v[2], &p})
      for (double& x : *point) all.push_back(&x);
    return all;
  }
  std::string where() const {
    return "region " + std::to_string(region()) + ", $s,t$ = " + format_significant(s, 6) + ", " +
           format_significant(t, 6);
  }
  Vec<double> edge(std::size_t i) const { return w.v[i] - w.v[0]; }
  Vec<double> normal() const { return cross(edge(1), edge(2)); }
  /// The region by the coordinates that P was made of.
  int region() const {
    if (s + t <= 1) return s < 0 ? (t < 0 ? 4 : 3) : t < 0 ? 5 : 0;
    return s < 0 ? 2 : t < 0 ? 6 : 1;
  }
};

/// Fair triangles of sizes 0.01 to 100: the sine squared between the edges is above a twentieth.
std::vector<Sample> samples(double seed) {
  Random random(seed);
  std::vector<Sample> all;
  while (all.size() < 700) {
    const double size = std::abs(random.magnitude(0.01, 100));
    const Triangle<double> w{{random.point(size), random.point(size), random.point(size)}};
    const Vec<double> e1 = w.v[1] - w.v[0], e2 = w.v[2] - w.v[0], n = cross(e1, e2);
    if (dot(n, n) < 0.05 * dot(e1, e1) * dot(e2, e2)) continue;
    const double s = random.between(-2, 3), t = random.between(-2, 3), above = random.between(-size, size);
    all.push_back({w, s, t, above, w.at(s, t) + (above / length(n)) * n});
  }
  return all;
}

/// V(s, t) as a sum of vertices with weights in the given order.
Formula<Sample> weighted(std::string text, const std::array<std::size_t, 3>& order) {
  return {std::move(text), [=](const Sample& x) {
            const auto& v = x.w.v;
            return (1 - x.s - x.t) * v[order[0]] + x.s * v[order[1]] + x.t * v[order[2]];
          }};
}

/// The signed areas that a point of the plane makes with the edges, over the triangle's.
Vec<double> areas(const Triangle<double>& w, const Vec<double>& x) {
  const auto& v = w.v;
  const Vec<double> n = cross(v[1] - v[0], v[2] - v[0]);
  const auto area = [&](std::size_t j, std::size_t k) {
    return dot(n, cross(v[j] - x, v[k] - x)) / dot(n, n);
  };
  return {area(1, 2), area(2, 0), area(0, 1)};
}

/// The triangle as the points with s, t >= 0 and s + t at most `most`.
Statement<Sample> domain(std::string text, double most) {
  return {std::move(text), [=](const Sample& x) {
            const Vec<double> a = areas(x.w, x.w.at(x.s, x.t));
            return (a[0] >= 0 && a[1] >= 0 && a[2] >= 0) == (x.s >= 0 && x.t >= 0 && x.s + x.t <= most);
          }};
}

template <class T>
T squared_distance(const Sample& x, const T& s, const T& t) {
  Triangle<T> w;
  Vec<T> p;
  for (std::size_t a = 0; a < 3; ++a) {
    p[a] = T(x.p[a]);
    for (std::size_t i = 0; i < 3; ++i) w.v[i][a] = T(x.w.v[i][a]);
  }
  const Vec<T> d = w.at(s, t) - p;
  return dot(d, d);
}

/// |s E1 + t E2 + D|^2, somewhere else than below P.
Formula<Sample> in_one(std::string text, double sign_of_d) {
  return {std::move(text), [=](const Sample& x) {
            const double s = 3 - x.t, t = x.s - 1;
            const Vec<double> sum = s * x.edge(1) + t * x.edge(2) + sign_of_d * (x.w.v[0] - x.p);
            return dot(sum, sum);
          }};
}

/// The same multiplied out.
Formula<Sample> in_six_terms(std::string text, double cross_term) {
  return {std::move(text), [=](const Sample& x) {
            const Vec<double> e1 = x.edge(1), e2 = x.edge(2), d = x.w.v[0] - x.p;
            const double s = 3 - x.t, t = x.s - 1;
            return dot(e1, e1) * s * s + cross_term * dot(e1, e2) * s * t + dot(e2, e2) * t * t +
                   2 * dot(e1, d) * s + 2 * dot(e2, d) * t + dot(d, d);
          }};
}

/// (a00, a01, a11, b0, b1, c) as half the derivatives of |V(s, t) - P|^2 at s = t = 0.
Value by_differentiation(const Sample& x) {
  using D = Dual<double>;
  using DD = Dual<D>;
  const D zero(0.0), one(1.0), moving(0.0, 1.0);
  const DD still(zero, zero), inner(moving, zero), outer(zero, one), both(moving, one);
  const auto second = [&](const DD& s, const DD& t) { return squared_distance(x, s, t).slope.slope / 2; };
  const auto first = [&](const D& s, const D& t) { return squared_distance(x, s, t).slope / 2; };
  return {second(both, still), second(inner, outer), second(still, both),
          first(moving, zero), first(zero, moving),  squared_distance(x, 0.0, 0.0)};
}

/// The quadratic's coefficients, some of them times a factor.
Formula<Sample> coefficients(std::string text, double a, double b) {
  return {std::move(text), [=](const Sample& x) {
            const Quadratic<double> q(x.w, x.p);
            return Value{q.a00, a * q.a01, q.a11, b * q.b0, b * q.b1, q.c};
          }};
}

void expressions(Claims& claims, const std::vector<Sample>& all) {
  const Formula<Sample> on_edges{"$V_0+sE_1+tE_2$", [](const Sample& x) { return x.w.at(x.s, x.t); }};
  const auto points = [&](const Formula<Sample>& by) { return compare("$V(s,t)$", by, on_edges, all); };
  const auto inside = [&](const Statement<Sample>& by) { return in_all(by.text, all, by.holds); };
  claims
      .add("parametrization", 4041, R"(the triangle is $V_0+sE_1+tE_2$ with $s,t\ge0$ and $s+t\le1$)",
           {.printed = {"sums of the vertices with weights $1-s-t$, $s$, $t$, none of them negative",
                        {points(weighted("sum of the vertices, weights $1-s-t$, $s$, $t$", {0, 1, 2})),
                         inside(domain(R"(in the triangle, by signed areas, just when $s,t\ge0$, $s+t\le1$)",
                                       1))}},
            .near_misses =
                {{R"($s+t\le2$)",
                  {inside(domain(R"(in the triangle, by signed areas, just when $s,t\ge0$, $s+t\le2$)", 2))}},
                 {"$E_1$ and $E_2$ exchanged",
                  {points(weighted("sum of the vertices, weights $1-s-t$, $t$, $s$", {0, 2, 1}))}}}})
      .formula<Sample>("barycentric", 4043, "the barycentric coordinates of $V(s,t)$", all,
                       {.truth = {"signed areas over the triangle's",
                                  [](const Sample& x) { return areas(x.w, x.w.at(x.s, x.t)); }},
                        .printed = {"$1-s-t$, $s$, $t$",
                                    [](const Sample& x) {
                                      return Value{1 - x.s - x.t, x.s, x.t};
                                    }},
                        .near_misses = {{"$s$, $t$, $1-s-t$", [](const Sample& x) {
                                           return Value{x.s, x.t, 1 - x.s - x.t};
                                         }}}});

  const Formula<Sample> squared{"$|V(s,t)-P|^2$",
                                [](const Sample& x) { return squared_distance(x, 3 - x.t, x.s - 1); }};
  const auto expanded = [&](const Formula<Sample>& by) { return compare("$f(s,t)$", by, squared, all); };
  claims
      .add("expansion", 4045, "the squared distance, in one and multiplied out",
           {.printed = {"$|sE_1+tE_2+D|^2$, $D=V_0-P$, and its six terms",
                        {expanded(in_one("$|sE_1+tE_2+D|^2$", 1)),
                         expanded(in_six_terms(R"($|E_1|^2s^2+2E_1\cdot E_2\,st+|E_2|^2t^2+2E_1\cdot D\,s+)"
                                               R"(2E_2\cdot D\,t+|D|^2$)",
                                               2))}},
            .near_misses = {{"$D=P-V_0$", {expanded(in_one("$|sE_1+tE_2-D|^2$", -1))}},
                            {R"($E_1\cdot E_2$ without its 2)",
                             {expanded(in_six_terms(R"($E_1\cdot E_2\,st$ and the other five terms)", 1))}}}})
      .formula<Sample>(
          "coefficients", 4051, "$f=a_{00}s^2+2a_{01}st+a_{11}t^2+2b_0s+2b_1t+c$", all,
          {.quantity = "$(a_{00},a_{01},a_{11},b_0,b_1,c)$",
           .truth = {"half the derivatives of $|V(s,t)-P|^2$, by dual numbers", by_differentiation},
           .printed = coefficients(R"($(|E_1|^2,E_1\cdot E_2,|E_2|^2,E_1\cdot D,E_2\cdot D,|D|^2)$)", 1, 1),
           .near_misses = {coefficients(R"($a_{01}=2E_1\cdot E_2$)", 2, 1),
                           coefficients("$b_0$ and $b_1$ of the other sign", 1, -1)}});
}

// ---- the minimum ------------------------------------------------------------------------------------------

using Distance = std::function<double(const Triangle<double>&, const Vec<double>&)>;

/// A sample with random points of its triangle.
struct Surrounded {
  Sample x;
  std::vector<Vec<double>> points;
  std::string where() const { return x.where(); }
};

std::vector<Surrounded> surrounded(const std::vector<Sample>& all) {
  Random random(7);
  std::vector<Surrounded> more;
  for (const Sample& x : all) {
    more.push_back({x, {}});
    for (int n = 0; n < 20; ++n) {
      double s = random.unit(), t = random.unit();
      if (s + t > 1) s = 1 - s, t = 1 - t;
      more.back().points.push_back(x.w.at(s, t));
    }
  }
  return more;
}

Check none_closer(const std::vector<Sample>& all, const Distance& distance) {
  return in_all<Surrounded>(
      "none of 20 points of the triangle is closer", surrounded(all), [&](const Surrounded& s) {
        const double least = distance(s.x.w, s.x.p) * (1 - 1e-12);
        return std::ranges::none_of(s.points,
                                    [&](const Vec<double>& point) { return length(point - s.x.p) < least; });
      });
}

Check same_distance(const std::vector<Sample>& all, std::string by, const Distance& distance) {
  const auto of = [](const Distance& f) { return [=](const Sample& x) { return f(x.w, x.p); }; };
  return compare<Sample>("distance", {std::move(by), of(distance)},
                         {"perpendicular to the plane, or nearest edge", of(plane_distance<double>)}, all);
}

void minimum(Claims& claims, const std::vector<Sample>& all) {
  const Distance unconstrained = [](const auto& w, const auto& p) {
    const Vec<double> n = cross(w.v[1] - w.v[0], w.v[2] - w.v[0]);
    return std::abs(dot(n, p - w.v[0])) / length(n);
  };
  claims.add("minimum", 4043, R"(the distance is where $f$ is least among $s,t\ge0$, $s+t\le1$)",
             {.printed = {"minimum over the triangle",
                          {same_distance(all, "least squared distance, by regions", region_distance<double>),
                           none_closer(all, region_distance<double>)}},
              .near_misses = {{"minimum over all $s$ and $t$",
                               {same_distance(all, "distance to the plane", unconstrained)}},
                              {"minimum over the edges", {none_closer(all, edges_distance<double>)}}}});

  const auto place = [](Place<double> (*find)(const Quadratic<double>&)) {
    return [=](const Triangle<double>& w, const Vec<double>& p) {
      const auto at = find(Quadratic<double>(w, p));
      return length(w.at(at.s, at.t) - p);
    };
  };
  std::vector<long> put(7, 0);
  for (const Sample& x : all) ++put[static_cast<std::size_t>(x.region())];
  claims.add("seven_regions", 4055, "it is the quadratic that the seven regions around the triangle minimize",
             {.printed = {"seven regions, the corner ones with sub-cases",
                          {same_distance(all, "seven regions", place(by_regions<double>)),
                           in_all<Sample>("$P$ is in the region that it was put into", all,
                                          [](const Sample& x) {
                                            return by_regions(Quadratic<double>(x.w, x.p)).region ==
                                                   x.region();
                                          }),
                           no_violations("regions without a sample", std::ranges::count(put, 0), 7),
                           compare<Sample>("the determinant",
                                           {"$a_{00}a_{11}-a_{01}^2$",
                                            [](const Sample& x) {
                                              const Quadratic<double> q(x.w, x.p);
                                              return q.a00 * q.a11 - q.a01 * q.a01;
                                            }},
                                           {R"($|E_1\times E_2|^2$)",
                                            [](const Sample& x) { return dot(x.normal(), x.normal()); }},
                                           all)}},
              .near_misses = {{"the corner regions are nearest to the corners",
                               {same_distance(all, "corners for the corner regions",
                                              place(by_regions_without_sub_cases<double>))}}}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const auto all = samples(seed);
  Claims claims("9.1");
  expressions(claims, all);
  minimum(claims, all);
  return claims.in_order();
}

}  // namespace oddity::ex09_01
