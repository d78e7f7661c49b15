#include "chapters/provable_claims.hpp"

#include <set>

#include "chapters/09_calculus/01_point_triangle/point_triangle.hpp"
#include "chapters/branches.hpp"
#include "reference/text.hpp"
#include "solvers/dual.hpp"

/// The book's claims about the squared distance, on random triangles and points.
namespace oddity::ex09_01 {

/// The region, from the signs of the coordinates.
template <class T>
int region_of(const T& s, const T& t) {
  if (s + t <= 1) return s < 0 ? (t < 0 ? 4 : 3) : t < 0 ? 5 : 0;
  return s < 0 ? 2 : t < 0 ? 6 : 1;
}

template <class T>
struct SampleOf {
  Triangle<T> w;
  T s, t, above;  ///< P's coordinates: V(s, t) + above * unit normal
  Vec<T> p;

  std::vector<T*> letters() {
    std::vector<T*> all{&s, &t};
    for (Vec<T>* point : {&w.v[0], &w.v[1], &w.v[2], &p})
      for (T& x : *point) all.push_back(&x);
    return all;
  }
  /// Values of s and t at a point other than that below P.
  T other_s() const { return 3 - t; }
  T other_t() const { return s - 1; }
  TypesetIn<T> typeset() const {
    return {{"s", other_s()}, {"t", other_t()}, {"E_1", edge(1)}, {"E_2", edge(2)}, {"D", w.v[0] - p}};
  }
  std::string where() const {
    return "region " + std::to_string(region()) + ", $s,t$ = " + format_significant(s, 6) + ", " +
           format_significant(t, 6);
  }
  Vec<T> edge(std::size_t i) const { return w.v[i] - w.v[0]; }
  Vec<T> normal() const { return cross(edge(1), edge(2)); }
  int region() const { return region_of(s, t); }
};

namespace {

using Sample = SampleOf<double>;
using OfSample = ProvableFormula<SampleOf>;
using Table = ProvableClaims<SampleOf>;

/// Well-shaped triangles of sizes 0.01 to 100: the squared sine between the edges is above a twentieth.
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
OfSample weighted(std::string text, const std::array<std::size_t, 3>& order) {
  return {std::move(text), [=](const auto& x) {
            const auto& v = x.w.v;
            return (1 - x.s - x.t) * v[order[0]] + x.s * v[order[1]] + x.t * v[order[2]];
          }};
}

/// Signed areas of the triangles between a point of the plane and the edges, relative to the triangle's area.
template <class T>
Vec<T> areas(const Triangle<T>& w, const Vec<T>& x) {
  const auto& v = w.v;
  const Vec<T> n = cross(v[1] - v[0], v[2] - v[0]);
  const auto area = [&](std::size_t j, std::size_t k) {
    return dot(n, cross(v[j] - x, v[k] - x)) / dot(n, n);
  };
  return {area(1, 2), area(2, 0), area(0, 1)};
}

template <class N, class S, class T>
auto squared_distance(const SampleOf<N>& x, const S& s, const T& t) {
  const auto along = [&](std::size_t i) {
    return x.w.v[0][i] + s * x.edge(1)[i] + t * x.edge(2)[i] - x.p[i];
  };
  const std::array d{along(0), along(1), along(2)};
  return dot(d, d);
}

/// (a00, a01, a11, b0, b1, c) as half the derivatives of |V(s, t) - P|^2 at s = t = 0.
template <class T>
auto by_differentiation(const SampleOf<T>& x) {
  const T zero(0.0);
  const auto along_s = [&](const auto& s) { return squared_distance(x, s, zero) / 2; };
  const auto along_t = [&](const auto& t) { return squared_distance(x, zero, t) / 2; };
  const auto slope_of_t = [&](const auto& s) {
    return derivative([&](const auto& t) { return squared_distance(x, s, t) / 2; }, 0 * s);
  };
  return values(second_derivative(along_s, zero), derivative(slope_of_t, zero),
                second_derivative(along_t, zero), derivative(along_s, zero), derivative(along_t, zero),
                squared_distance(x, zero, zero));
}

void in_coordinates(Table& table, const std::vector<Sample>& all) {
  const auto claim = table.over(all);
  claim("barycentric", 4043, "the barycentric coordinates of $V(s,t)$ are $1-s-t$, $s$ and $t$",
        {"signed areas over the triangle's",
         [](const auto& x) { return areas(x.w, x.w.at(x.other_s(), x.other_t())); }},
        R"($(1-s-t,\ s,\ t)$)");
  const ProvableFormula<SampleOf> f{
      "$|V(s,t)-P|^2$", [](const auto& x) { return squared_distance(x, x.other_s(), x.other_t()); }};
  claim("squared", 4047, "$f=|sE_1+tE_2+D|^2$", f, R"($(sE_1+tE_2+D)\cdot(sE_1+tE_2+D)$)");
  claim("expansion", 4049,
        R"($f=|E_1|^2s^2+2E_1\cdot E_2\,st+|E_2|^2t^2+2E_1\cdot D\,s+2E_2\cdot D\,t+|D|^2$)", f,
        R"($E_1\cdot E_1\,s^2+2E_1\cdot E_2\,st+E_2\cdot E_2\,t^2+2E_1\cdot D\,s)"
        R"(+2E_2\cdot D\,t+D\cdot D$)");
  claim("coefficients", 4051, "$f=a_{00}s^2+2a_{01}st+a_{11}t^2+2b_0s+2b_1t+c$",
        {"half the derivatives of $|V(s,t)-P|^2$, by dual numbers",
         [](const auto& x) { return by_differentiation(x); }},
        R"($(E_1\cdot E_1,\ E_1\cdot E_2,\ E_2\cdot E_2,\ E_1\cdot D,\ E_2\cdot D,\ D\cdot D)$)",
        "$(a_{00},a_{01},a_{11},b_0,b_1,c)$");
}

const OfSample on_edges{"$V_0+sE_1+tE_2$", [](const auto&x) { return x.w.at(x.s, x.t); }},
    on_vertices = weighted("sum of the vertices, weights $1-s-t$, $s$, $t$", {0, 1, 2});

void expressions(Claims& claims, const std::vector<Sample>& all) {
  const auto points = [&](const Formula<Sample>& by) { return compare("$V(s,t)$", by, on_edges, all); };
  const auto inside = [&](const std::string& sum, double most) {
    return in_all<Sample>(
        R"(in the triangle, by signed areas, just when $s,t\ge0$, )" + sum, all, [=](const Sample& x) {
          const Vec<double> a = areas(x.w, x.w.at(x.s, x.t));
          return (a[0] >= 0 && a[1] >= 0 && a[2] >= 0) == (x.s >= 0 && x.t >= 0 && x.s + x.t <= most);
        });
  };
  claims.add(
      "parametrization", 4041,
      R"(the triangle's points are $V(s,t)=V_0+sE_1+tE_2$ with $s\ge0$, $t\ge0$ and $s+t\le1$)",
      {.printed = {"sums of the vertices with weights $1-s-t$, $s$, $t$, none of them negative",
                   {points(on_vertices), inside(R"($s+t\le1$)", 1)}},
       .near_misses = {{R"(with $s+t\le2$)", {inside(R"($s+t\le2$)", 2)}},
                       {"$E_1$ and $E_2$ exchanged",
                        {points(weighted("sum of the vertices, weights $1-s-t$, $t$, $s$", {0, 2, 1}))}}}});
}

// ---- the minimum ------------------------------------------------------------------------------------------

using Distance = std::function<double(const Triangle<double>&, const Vec<double>&)>;

Check none_closer(const std::vector<Sample>& all, const Distance& distance) {
  Random random(7);
  return in_all<Sample>("none of 20 points of the triangle is closer", all, [&](const Sample& x) {
    const double least = distance(x.w, x.p) * (1 - 1e-12);
    bool closer = false;
    for (int n = 0; n < 20; ++n) {
      double s = random.unit(), t = random.unit();
      if (s + t > 1) s = 1 - s, t = 1 - t;
      closer |= length(x.w.at(s, t) - x.p) < least;
    }
    return !closer;
  });
}

Check same_distance(const std::vector<Sample>& all, std::string by, const Distance& distance) {
  return compare<Sample>("distance", {std::move(by), [=](const Sample& x) { return distance(x.w, x.p); }},
                         {"perpendicular to the plane, or nearest edge",
                          [](const Sample& x) { return plane_distance(x.w, x.p); }},
                         all);
}

void minimum(Claims& claims, const std::vector<Sample>& all) {
  claims.add(
      "least_square", 4043,
      "$s$ and $t$ are those of the least squared distance $f$ (our check: no other point $V(s,t)$ is closer "
      "to $P$)",
      {.printed = {"where $f$ is least over the triangle", {none_closer(all, region_distance<double>)}},
       .near_misses = {{"where it is least over the edges", {none_closer(all, edges_distance<double>)}}}});

  const Formula<Sample> determinant{"$a_{00}a_{11}-a_{01}^2$",
                                    [](const Sample&x) { return Quadratic<double>(x.w, x.p).determinant(); }},
      square_of_normal{R"($|E_1\times E_2|^2$)", [](const Sample&x) { return dot(x.normal(), x.normal()); }};
  const auto of_corners = [](const Triangle<double>& w, const Vec<double>& p) {
    const auto at = by_regions_without_sub_cases(Quadratic<double>(w, p));
    return length(w.at(at.s, at.t) - p);
  };
  std::set<int> regions;
  for (const Sample& x : all) regions.insert(x.region());
  const auto count = static_cast<double>(regions.size());
  claims.add(
      "seven_regions", 4055,
      "$f$ is exactly the function of the book's example 9.8 (our reading, as that is not in the solutions: a "
      "quadratic that is least in one of seven regions)",
      {.printed = {"seven regions, the corner ones with sub-cases",
                   {same_distance(all, "seven regions", region_distance<double>),
                    in_all<Sample>("$P$ is in the region that it was put into", all,
                                   [](const Sample& x) {
                                     return by_regions(Quadratic<double>(x.w, x.p)).region == x.region();
                                   }),
                    {"regions with a sample", {"of the samples", count}, {"seven", 7.0}, exact()},
                    compare("the determinant", determinant, square_of_normal, all)}},
       .near_misses = {{"the corner regions are nearest to the corners",
                        {same_distance(all, "corners for the corner regions", of_corners)}}}});
}

}  // namespace

std::vector<Claim> claims(double seed) {
  const auto all = samples(seed);
  Claims claims("9.1");
  Table table(claims);
  expressions(claims, all);
  in_coordinates(table, all);
  minimum(claims, all);
  return claims.in_order();
}

// ---- proofs -----------------------------------------------------------------------------------------------

namespace {

/// s and t are not negative, and their sum is at most one.
std::string in_domain(const std::string& s, const std::string& t) {
  return "(" + s + " >= 0 /\\ " + t + " >= 0 /\\ " + s + " + " + t + " <= 1)";
}

std::string area_is(const Expression& area, const std::string& weight) {
  return "replace (" + area.coq() + ")\n    with (" + weight + ") in * by (field; exact H); ";
}

/// At the minimum of the square, no sum of the vertices with weights that add up to one is closer.
Lemma nearest(const SampleOf<Shortened>& any, std::vector<std::string> names) {
  const auto letter = Shortened::letter;
  const auto coq = [](const Shortened& x) { return x.expression().coq(); };
  const Vec<Shortened> place = any.w.at(any.s, any.t),
                       other =
                           letter("k0") * any.w.v[0] + letter("k1") * any.w.v[1] + letter("k2") * any.w.v[2];
  names.insert(names.end(), {"k0", "k1", "k2"});
  return {"nearest",
          quantified(names),
          {{in_domain("s", "t")},
           {"(forall u v, " + in_domain("u", "v") + " ->\n    " + coq(squared_distance(any, any.s, any.t)) +
            " <=\n    " + coq(squared_distance(any, letter("u"), letter("v"))) + ")"},
           {"k0 >= 0 /\\ k1 >= 0 /\\ k2 >= 0"},
           {"k0 + k1 + k2 = 1"}},
          {{coq(length(place - any.p)) + " <=\n  " + coq(length(other - any.p))}},
          "apply sqrt_le_1_alt; replace k0 with (1 - k1 - k2) by lra;\n  match goal with |- _ <= ?y => "
          "eapply Rle_trans; [apply (H0 k1 k2); lra | right; ring] end"};
}

/// For any quadratic that has a minimum, as a triangle's has.
Provable seven_regions(const SampleOf<Shortened>& any, std::vector<std::string> names,
                       const std::vector<Proposition>& area) {
  const std::vector<std::string> letters{"a00", "a01", "a11", "b0", "b1", "c"};
  const auto quadratic = [&](const auto& number) {
    std::array<decltype(number("")), 6> k{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    std::ranges::transform(letters, k.begin(), number);
    return Quadratic(k);
  };
  const std::string regions = tree_of([&](Way& way) {
    const auto number = [&](const std::string& name) { return Branching(Expression::letter(name), way); };
    const auto place = by_regions(quadratic(number));
    return "(" + place.s.expression().coq() + ", " + place.t.expression().coq() + ", " +
           std::to_string(place.region) + "%nat)";
  });
  const std::string region = tree_of([](Way& way) {
    const Branching x(Expression::letter("x"), way), y(Expression::letter("y"), way);
    return std::to_string(region_of(x, y)) + "%nat";
  });
  const auto q = quadratic([](const std::string& name) { return Expression::letter(name); });
  const auto f = [&](const char* s, const char* t) {
    return q(Expression::letter(s), Expression::letter(t)).coq();
  };
  const std::vector<Proposition> convex{above(q.a00, 0), above(q.determinant(), 0)};
  const auto at_place = [&](const std::string& is_so) -> Proposition {
    return {"match " + regions + "\n  with (s, t, region) =>\n  " + is_so + " end"};
  };
  const auto [x, y] = q.least_of_all();
  std::vector<Proposition> at_point = convex;
  at_point.push_back(x == q.determinant() * Expression::letter("x"));
  at_point.push_back(y == q.determinant() * Expression::letter("y"));
  names.emplace_back("h");
  const Vec<Shortened> n = any.normal();
  const Quadratic<Shortened> of_point(any.w, any.w.at(any.s, any.t) + Shortened::letter("h") * n);
  const Shortened det = of_point.determinant();
  const auto [S, T] = of_point.least_of_all();
  return {
      "9.1-seven_regions",
      "the regions give the least value of any such quadratic; a triangle's is one of these, and its region "
      "is that of the point",
      {{"least",
        quantified(letters),
        convex,
        {at_place(in_domain("s", "t") + " /\\\n  forall u v, " + in_domain("u", "v") + " ->\n  " +
                  f("s", "t") + " <=\n  " + f("u", "v"))},
        "least_by_regions a00 a01 a11 b0 b1"},
       {"region",
        quantified({"a00", "a01", "a11", "b0", "b1", "c", "x", "y"}),
        at_point,
        {at_place("region = " + region)},
        "rewrite H1, H2; set (D := a00 * a11 - a01 * a01) in *; alike D x y"},
       {"of_triangle",
        quantified(names),
        area,
        {above(of_point.a00.expression(), 0), above(det.expression(), 0),
         det.expression() == dot(n, n).expression(), S.expression() == (det * any.s).expression(),
         T.expression() == (det * any.t).expression()},
        "of_edges x0 y0 z0 x1 y1 z1 x2 y2 z2"}},
      0,
      coq_source({"least"})};
}

}  // namespace

Provables proofs() {
  const std::vector<std::string> names{"s",  "t",  "x0", "y0", "z0", "x1", "y1",
                                       "z1", "x2", "y2", "z2", "px", "py", "pz"};
  auto all = for_all<SampleOf>(names, "field; exact H", "it holds for any triangle and any point");
  const auto& any = all.any;
  const std::vector<Proposition> area = all.given = {not_zero(dot(any.normal(), any.normal()).expression())};
  Claims claims("9.1");
  Table table(claims);
  in_coordinates(table, {});
  Provables proved = table.proofs("9.1", all);
  const Expressions by_areas = detail::recorded_value(areas(any.w, any.w.at(any.s, any.t)));
  proved.push_back(
      {"9.1-parametrization",
       "any such point is the sum of the vertices, and it is in the triangle just when s and t are "
       "not negative and add up to at most 1",
       {{"points", all.letters, {}, equal(on_vertices.recorded(any), on_edges.recorded(any)), "ring"},
        {"domain",
         all.letters,
         area,
         {{"((" + by_areas[0].coq() + " >= 0 /\\ " + by_areas[1].coq() + " >= 0 /\\\n  " + by_areas[2].coq() +
           " >= 0) <-> " + in_domain("s", "t") + ")"}},
         area_is(by_areas[0], "1 - s - t") + area_is(by_areas[1], "s") + area_is(by_areas[2], "t") +
             "intuition lra"}}});
  proved.push_back(seven_regions(any, names, area));
  proved.push_back({"9.1-least_square",
                    "where the square is least, no other point of the triangle is closer",
                    {nearest(any, names)}});
  return proved;
}

}  // namespace oddity::ex09_01
