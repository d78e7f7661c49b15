// Exercise 9.1: the distance from a point P to a triangle, as the minimum of a quadratic on s, t >= 0, s + t
// <= 1:
//   f(s, t) = |s E1 + t E2 + D|^2 = a00 s^2 + 2 a01 s t + a11 t^2 + 2 b0 s + 2 b1 t + c.
//   E1 = V1 - V0, E2 = V2 - V0, D = V0 - P.
// Independent routes: for the coefficients, derivatives of |V(s, t) - P|^2 by dual numbers; for the minimum,
// the perpendicular and the edges. For the tables, a bisection that uses no regions.

#include "chapters/09_calculus/01_point_triangle/point_triangle.hpp"
#include "chapters/inputs.hpp"
#include "reference/reference.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex09_01 {

using Point = Vec<double>;

constexpr auto parameters =
    together(numbers<3>({"px", "py", "pz"}, {1.25, 2.25, 1.25}, "m", "the point", 1e6),
             numbers<3>({"v0x", "v0y", "v0z"}, {1, 2, -1}, "m", "the triangle's vertex $V_0$", 1e6),
             numbers<3>({"v1x", "v1y", "v1z"}, {4, 3, 0}, "m", "the vertex $V_1$", 1e6),
             numbers<3>({"v2x", "v2y", "v2z"}, {0, 4, 1}, "m", "the vertex $V_2$", 1e6),
             std::array{Parameter{"seed", 1, "", "seed of the random triangles", 0, 1e9, whole_number}});

// ---- distances --------------------------------------------------------------------------------------------

/// A triangle and query points, scaled by 2^exponent; distances are returned unscaled.
struct Case {
  Triangle<double> w;
  std::vector<Point> points;
  int exponent = 0;
};

constexpr double thin = 0x1p-27, close_by = 0x1p-30;
constexpr Point v0{1, 2, -1}, v1{4, 3, 0};
const Triangle<double> fair{{v0, v1, {0, 4, 1}}}, line{{v0, v1, {2.5, 2.5, -0.5}}},
    needle{{v0, v1, {2.5 - thin, 2.5 + 2 * thin, -0.5 + thin}}}, twice{{v0, v0, v1}};

/// One point in each region of the well-shaped triangle.
const std::vector<Point> around{{1.25, 2.25, 1.25},  {2.5, 4.75, 0.75},  {-2.5, 5.25, 2.75},
                                {-1.75, 1.25, 0.25}, {0.25, -0.5, -2.5}, {3, 2.5, -2.5},
                                {7.5, 2.5, 0.5}};

template <class T>
Vec<T> as(const Point& p, int exponent) {
  Vec<T> q;
  for (std::size_t a = 0; a < 3; ++a) q[a] = std::ldexp(p[a], exponent);
  return q;
}

template <class T, class F>
std::vector<double> distances(const Case& at, const F& f, int setting) {
  const Triangle<T> w{
      {as<T>(at.w.v[0], at.exponent), as<T>(at.w.v[1], at.exponent), as<T>(at.w.v[2], at.exponent)}};
  std::vector<double> all;
  for (const Point& p : at.points)
    all.push_back(std::ldexp(static_cast<double>(f(w, as<T>(p, at.exponent), setting)), -at.exponent));
  return all;
}

Quantity distance_quantity(std::string name, std::string says, const Case& at, const Reference& truth) {
  Known known;
  for (const Point& p : at.points) {
    std::vector<double> inputs;
    for (const Point& vertex : at.w.v) inputs.insert(inputs.end(), vertex.begin(), vertex.end());
    inputs.insert(inputs.end(), p.begin(), p.end());
    const Known one = truth("09_01_distance", inputs);
    known.value.push_back(one.value[0]);
    known.error = std::max(known.error, one.error);
    if (known.source.empty() || one.source.starts_with("computed")) known.source = one.source;
  }
  return quantity(std::move(name), at.exponent == 0 ? "m" : "2^" + std::to_string(at.exponent) + " m",
                  std::move(says), known, {1e-12, "a few thousand roundings of the triangle's size"});
}

/// Adds a method to a quantity. `f(triangle, point, setting)` is generic in the number type; its
/// multiplications, divisions and roots are counted beforehand.
template <class F>
void add_counted(Quantity& q, const Case& at, Method method, const F& f) {
  std::vector<std::pair<double, long>> work;
  for (double setting : method.resolution.settings) {
    const auto run = [&] { return distances<Counted<double>>(at, f, static_cast<int>(setting)); };
    work.emplace_back(setting, operations_of(run).all_but_additions());
  }
  method.run = [=](double setting) {
    const auto same = [&](const auto& row) { return row.first == setting; };
    return Answer{distances<double>(at, f, static_cast<int>(setting)),
                  std::ranges::find_if(work, same)->second};
  };
  q.add(std::move(method));
}

const auto quadratic_regions = [](const auto& w, const auto& p, int) { return quadratic_distance(w, p); };
const auto regions = [](const auto& w, const auto& p, int) { return region_distance(w, p); };
const auto voronoi = [](const auto& w, const auto& p, int) { return voronoi_distance(w, p); };
const auto plane = [](const auto& w, const auto& p, int) { return plane_distance(w, p); };
const auto edges = [](const auto& w, const auto& p, int) { return edges_distance(w, p); };
const auto orthogonal = [](const auto& w, const auto& p, int) { return orthogonal_distance(w, p); };
const auto scaled = [](const auto& w, const auto& p, int) { return scaled_distance(w, p); };
const auto golden = [](const auto& w, const auto& p, int n) { return golden_distance(w, p, n); };
const auto sampled = [](const auto& w, const auto& p, int n) { return sampled_distance(w, p, n); };
const auto gradient = [](const auto& w, const auto& p, int n) { return gradient_distance(w, p, n); };

/// A method that is expected to fail here.
struct Failure {
  std::string model, algorithm;
  Outcome outcome;
  std::string why;
};

Quantity measured(std::string name, std::string says, const Case& at, const Reference& truth,
                  const std::vector<Failure>& failures) {
  Quantity q = distance_quantity(std::move(name), std::move(says), at, truth);
  const auto add = [&](std::string model, std::string algorithm, const Resolution& resolution,
                       const auto& f) {
    Failure expected{model, algorithm, Outcome::ok, ""};
    for (const Failure& failure : failures)
      if (failure.model == model && failure.algorithm == algorithm) expected = failure;
    add_counted(q, at, {model, algorithm, resolution, {}, expected.outcome, expected.why}, f);
  };
  add("quadratic's value", "seven regions", no_resolution(), quadratic_regions);
  add("closest point", "seven regions", no_resolution(), regions);
  add("closest point", "Voronoi regions", no_resolution(), voronoi);
  add("closest point", "plane or edges", no_resolution(), plane);
  add("closest point", "Gram-Schmidt or edges", no_resolution(), orthogonal);
  add("scaled", "Gram-Schmidt or edges", no_resolution(), scaled);
  add("closest point", "golden section twice", doubling("steps", 8, 4), golden);
  add("closest point", "projected gradient", doubling("steps", 8, 7), gradient);
  return q;
}

const std::string no_det = "$a_{00}a_{11}-a_{01}^2$ is 0, or nothing but rounding",
                  products = "products of four lengths leave the range of doubles",
                  squares = "squares leave the range of doubles",
                  slow = "its steps grow as the shape's condition number";

Quantity in_fair(const Parameters& p, const Reference& truth) {
  const Triangle<double> asked{{point_of(p, "v0"), point_of(p, "v1"), point_of(p, "v2")}};
  const bool is_fair = asked.v == fair.v;
  std::vector<Point> points{point_of(p, "p")};
  if (is_fair) points.insert(points.end(), around.begin(), around.end());
  const Case at{asked, points};
  Quantity q =
      measured("distance", is_fair ? "from $P$ and from one point in each of the seven regions" : "from $P$",
               at, truth, {});
  add_counted(q, at,
              {"closest point", "edges", no_resolution(), {}, Outcome::inaccurate, "the face is left out"},
              edges);
  add_counted(q, at,
              {"closest point",
               "grid of samples",
               doubling("points an edge", 4, 5),
               {},
               Outcome::inaccurate,
               "its error shrinks with the mesh, its cost grows with the mesh squared"},
              sampled);
  return q;
}

std::vector<Quantity> quantities(const Parameters& p, const Reference& truth) {
  const Outcome bad = Outcome::inaccurate, none = Outcome::non_finite;
  const std::string value = "quadratic's value", point = "closest point", seven = "seven regions",
                    voronoi_regions = "Voronoi regions", either = "plane or edges",
                    stable = "Gram-Schmidt or edges", twofold = "golden section twice",
                    descent = "projected gradient";
  std::vector<Point> with_face = around;
  with_face.push_back({2.25 - thin / 2, 1.5 + thin, 1.25 + thin / 2});
  std::vector<Quantity> all{in_fair(p, truth)};
  const auto breaks = [&](std::string says, const std::string& method, double setting, Outcome outcome,
                          const std::string& cure, std::vector<Told> numbers = {}) {
    all.back().add(Breakdown{std::move(says), method, setting, outcome, cure, 0, std::move(numbers)});
  };
  constexpr int tiny = -500, huge = 500, huger = 600;
  const auto size = [](int exponent) { return std::ldexp(1.0, exponent); };
  const auto of_size = [&](int exponent) { return filled("a triangle of size $@1$", {size(exponent)}); };
  all.push_back(measured("close_distance",
                         filled("from $@2$ above the triangle", {std::sqrt(2.0) * close_by}),
                         {fair, {{1.25, 3.25 - close_by, 0.25 + close_by}}}, truth,
                         {{value, seven, bad, "the six terms cancel"}}));
  breaks(
      "The quadratic's six terms of size 1 cancel to a squared distance of $@1$, and @1 digits of the "
      "distance are right. The point $V(s,t)$ is right, and its distance from $P$ has every digit.",
      value + ", " + seven, 0, bad, point + ", " + seven,
      {all.back().reference.value[0] * all.back().reference.value[0], digits_of(Side::broken)});
  all.push_back(measured(
      "needle_distance", filled("a triangle $@2$ thin", {std::sqrt(6.0) * thin}), {needle, with_face}, truth,
      {{value, seven, none, no_det}, {point, seven, none, no_det}, {point, descent, bad, slow}}));
  breaks(
      "The determinant of a needle is lost in rounding, and the point with it. Voronoi regions end at an "
      "edge, which is as near.",
      point + ", " + seven, 0, none, point + ", " + voronoi_regions);
  breaks("Descent along the gradient hardly moves across a needle.", point + ", " + descent, 512, bad,
         point + ", " + stable);
  all.push_back(measured("collinear_distance", "three vertices on a line", {line, around}, truth,
                         {{value, seven, none, no_det}, {point, seven, none, no_det}}));
  breaks(
      "On three vertices of one line the determinant is 0 and the quotients are $0/0$. The edges are all "
      "there is.",
      point + ", " + seven, 0, none, point + ", " + either);
  all.push_back(measured("repeated_distance", "two vertices the same", {twice, around}, truth,
                         {{value, seven, none, no_det},
                          {point, seven, none, no_det},
                          {point, voronoi_regions, none, "an edge of length 0 is divided by"}}));
  breaks("Voronoi regions divide by the length of an edge that has none. A segment of length 0 is its end.",
         point + ", " + voronoi_regions, 0, none, point + ", " + either);
  all.push_back(measured("tiny_distance", of_size(tiny), {fair, around, tiny}, truth,
                         {{value, seven, none, products},
                          {point, seven, none, products},
                          {point, voronoi_regions, bad, products},
                          {point, either, bad, products}}));
  breaks(
      "At size $@1$ the products of four lengths are 0, and the Voronoi regions name a wrong edge without "
      "a sign of it. Orthogonal edges need squares only.",
      point + ", " + voronoi_regions, 0, bad, point + ", " + stable, {size(tiny)});
  all.push_back(measured("huge_distance", of_size(huge), {fair, around, huge}, truth,
                         {{value, seven, bad, products},
                          {point, seven, bad, products},
                          {point, voronoi_regions, none, products},
                          {point, either, bad, products}}));
  breaks(
      "At size $@1$ the determinant is infinite, every comparison with it is answered, and the seven "
      "regions give a finite, wrong distance. In units of the triangle's size nothing overflows.",
      point + ", " + seven, 0, bad, "scaled, " + stable, {size(huge)});
  all.push_back(measured("huger_distance", of_size(huger), {fair, around, huger}, truth,
                         {{value, seven, none, squares},
                          {point, seven, none, squares},
                          {point, voronoi_regions, none, squares},
                          {point, either, none, squares},
                          {point, stable, none, squares},
                          {point, twofold, none, squares},
                          {point, descent, none, squares}}));
  breaks("At size $@1$ even squares overflow, and only scaling is left.", point + ", " + stable, 0, none,
         "scaled, " + stable, {size(huger)});
  return all;
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p["seed"]), in_operations(quantities(p, truth))};
}

}  // namespace ex09_01

Exercise exercise_9_1() {
  using namespace ex09_01;
  return {
      "Distance from a point to a triangle",
      "Find the distance from a point $P$ to a triangle $V_0V_1V_2$: parametrize the triangle by $s,t\\ge0$, "
      "$s+t\\le1$ and minimize the squared distance $f(s,t)$. Below "
      "$E_1=V_1-V_0$, $E_2=V_2-V_0$ and $D=V_0-P$. (That the book's Example 9.8 treats this function is its "
      "word: checked is that the seven regions minimize it.)",
      parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
