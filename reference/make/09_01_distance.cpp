#include <array>

#include "reference/truth.hpp"

// The distance from a point to a triangle. The second route minimizes the squared distance over t in closed
// form and over s by bisection of the derivative, without edges and regions.
namespace oddity::truth {

namespace distance_09_01 {

using Point = std::array<Number, 3>;

Number dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point along(const Point& a, const Number& k, const Point& e) {
  return {a[0] + k * e[0], a[1] + k * e[1], a[2] + k * e[2]};
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Number length(const Point& a) { return sqrt(dot(a, a)); }
Number clamped(const Number& x, const Number& high) { return x < 0 ? Number(0) : x > high ? high : x; }

struct Input {
  std::array<Point, 3> v;
  Point p;
  explicit Input(const std::vector<double>& in) {
    for (std::size_t i = 0; i < 12; ++i) (i < 9 ? v[i / 3] : p)[i % 3] = in[i];
  }
};

Number to_segment(const Point& a, const Point& b, const Point& p) {
  const Point e = minus(b, a);
  const Number squared = dot(e, e);
  if (squared == 0) return length(minus(p, a));
  return length(minus(along(a, clamped(dot(minus(p, a), e) / squared, 1), e), p));
}

Numbers by_plane_and_edges(const std::vector<double>& in, int) {
  const Input x(in);
  const Point n = cross(minus(x.v[1], x.v[0]), minus(x.v[2], x.v[0]));
  bool inside = dot(n, n) > 0;
  Number nearest = to_segment(x.v[2], x.v[0], x.p);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = x.v[i], &b = x.v[(i + 1) % 3];
    inside = inside && dot(cross(n, minus(b, a)), minus(x.p, a)) >= 0;
    nearest = fmin(nearest, to_segment(a, b, x.p));
  }
  return {inside ? Number(abs(dot(n, minus(x.p, x.v[0]))) / length(n)) : nearest};
}

Numbers by_bisection(const std::vector<double>& in, int) {
  const Input x(in);
  const Point e1 = minus(x.v[1], x.v[0]), e2 = minus(x.v[2], x.v[0]);
  const Number squared = dot(e2, e2);
  const auto gap = [&](const Number& s, const Number& t) {
    return minus(along(along(x.v[0], s, e1), t, e2), x.p);
  };
  const auto best = [&](const Number& s) {
    return squared == 0 ? Number(0) : clamped(Number(-dot(gap(s, 0), e2) / squared), Number(1 - s));
  };
  Number low = 0, high = 1;
  for (int i = 0; i < 190; ++i) {
    const Number s = (low + high) / 2, t = best(s);
    const Point d = gap(s, t);
    const bool slides = squared > 0 && t == Number(1 - s);  // the upper end moves with s
    const Number slope = slides ? Number(dot(d, e1) - dot(d, e2)) : dot(d, e1);
    (slope < 0 ? low : high) = s;
  }
  return {length(gap(low, best(low)))};
}

}  // namespace distance_09_01

Truth truth_09_01_distance() {
  using namespace distance_09_01;
  using Row = std::vector<double>;
  const double thin = std::ldexp(1.0, -27), close = std::ldexp(1.0, -30);
  const Row fair{1, 2, -1, 4, 3, 0, 0, 4, 1}, line{1, 2, -1, 4, 3, 0, 2.5, 2.5, -0.5},
      needle{1, 2, -1, 4, 3, 0, 2.5 - thin, 2.5 + 2 * thin, -0.5 + thin}, twice{1, 2, -1, 1, 2, -1, 4, 3, 0},
      point{1, 2, -1, 1, 2, -1, 1, 2, -1};
  std::vector<Row> rows;
  const auto add = [&](Row vertices, const Row& p) {
    vertices.insert(vertices.end(), p.begin(), p.end());
    rows.push_back(vertices);
  };
  for (const Row& v : {fair, needle, line, twice, point})
    for (const Row& p :
         {Row{1.25, 2.25, 1.25}, Row{2.5, 4.75, 0.75}, Row{-2.5, 5.25, 2.75}, Row{-1.75, 1.25, 0.25},
          Row{0.25, -0.5, -2.5}, Row{3, 2.5, -2.5}, Row{7.5, 2.5, 0.5}})
      add(v, p);
  add(fair, {1.25, 3.25 - close, 0.25 + close});
  add(needle, {2.25 - thin / 2, 1.5 + thin, 1.25 + thin / 2});
  return {"distance from the point (px, py, pz) to the triangle with vertices 0, 1, 2",
          "min |V0 + s (V1 - V0) + t (V2 - V0) - P| over s, t >= 0, s + t <= 1",
          {"x0", "y0", "z0", "x1", "y1", "z1", "x2", "y2", "z2", "px", "py", "pz"},
          {{"distance", "m"}},
          rows,
          "perpendicular to the plane, or the nearest of the three edges",
          by_plane_and_edges,
          "bisection of the derivative over s of the minimum over t",
          by_bisection,
          "the first route, each comparison decided",
          by_plane_and_edges};
}

}  // namespace oddity::truth
