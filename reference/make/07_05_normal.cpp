#include "reference/truth.hpp"

namespace oddity::truth {

namespace normal_07_05 {

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Numbers point(const std::vector<double>& in, std::size_t i) {
  return {in[3 * i], in[3 * i + 1], in[3 * i + 2]};
}

Numbers by_edges(const std::vector<double>& in, int) {
  Numbers u = point(in, 1), v = point(in, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] -= u[i];
    u[i] -= in[i];
  }
  return cross(u, v);
}

Numbers by_vertices(const std::vector<double>& in, int) {
  Numbers sum{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const Numbers term = cross(point(in, i), point(in, (i + 1) % 3));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += term[k];
  }
  return sum;
}

/// A triangle of height about h over a base of about 1, at the distance d.
std::vector<double> flat(double d, double h) {
  return {
      d, d / 3, -d / 7, d + 1.1, d / 3 + 0.7, -d / 7 - 0.3, d + 0.66, d / 3 + 0.42 + h, -d / 7 - 0.18 + h};
}

/// A triangle with two sides of about 1, the third of about s.
std::vector<double> needle(double s) {
  return {0, 0, 0, 1.08231, 0.73914, -0.31277, 1.08231 + s, 0.73914 - 2 * s, -0.31277 + s / 3};
}

}  // namespace normal_07_05

Truth truth_07_05_normal() {
  using namespace normal_07_05;
  return {"normal of the triangle PQR, as long as twice its area; flat and needle-like triangles",
          "(Q-P) x (R-Q)",
          {"p1", "p2", "p3", "q1", "q2", "q3", "r1", "r2", "r3"},
          {{"n1", "1"}, {"n2", "1"}, {"n3", "1"}},
          {flat(1e8, 1e-3), flat(1, 1e-6), flat(1e4, 1e-5), flat(1e10, 0.1), needle(1e-10), needle(1e-3),
           needle(1e-14)},
          "cross product of two edges",
          by_edges,
          "P x Q + Q x R + R x P",
          by_vertices,
          "the first route",
          by_edges};
}

}  // namespace oddity::truth
