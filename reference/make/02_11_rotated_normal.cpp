#include "reference/make/routes.hpp"

// The triangle's edges are a = (47436513, 25959777, -12996065)/2^25 and b = a + gap (-0.5, 1, 0.75), the axis
// is w = (1, 2, 2)/3. Rodrigues: R r = c r + s w x r + (1 - c) w (w . r), applied to a x b. Reflections: R is
// the mirror with the normal u after that with the normal cos(theta/2) u - sin(theta/2) w x u, u
// perpendicular to w. It is applied to a and to b before their product.
namespace oddity::truth {

namespace rotated_normal_02_11 {

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Number dot(const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Numbers sum(const Number& s, const Numbers& a, const Number& t, const Numbers& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}
Numbers unit(const Numbers& a) { return sum(1 / sqrt(dot(a, a)), a, 0, a); }

const Numbers& axis() {
  static const Numbers w = unit({1, 2, 2});
  return w;
}
Numbers first_edge() { return sum(Number(1) / 33554432, {47436513, 25959777, -12996065}, 0, {0, 0, 0}); }
Numbers second_edge(const Number& gap) {
  return sum(1, first_edge(), gap, {-Number(1) / 2, 1, Number(3) / 4});
}

Numbers by_rodrigues(const std::vector<double>& in, int) {
  const Number c = cos(Number(in[0])), s = sin(Number(in[0]));
  const Numbers n = cross(first_edge(), second_edge(in[1]));
  return unit(sum(1, sum(c, n, s, cross(axis(), n)), (1 - c) * dot(axis(), n), axis()));
}

Numbers by_reflections(const std::vector<double>& in, int) {
  const Numbers u = unit(cross(axis(), {0, 0, 1})), v = cross(axis(), u);
  const Number half = Number(in[0]) / 2;
  const Numbers n = sum(cos(half), u, -sin(half), v);
  const auto turned = [&](const Numbers& r) {
    const Numbers once = sum(1, r, -2 * dot(n, r), n);
    return sum(1, once, -2 * dot(u, once), u);
  };
  return unit(cross(turned(first_edge()), turned(second_edge(in[1]))));
}

}  // namespace rotated_normal_02_11

Truth truth_02_11_rotated_normal() {
  using namespace rotated_normal_02_11;
  return {"unit normal of a triangle with edges a, b, rotated by theta about w",
          "R (a x b) / |a x b|, a = (47436513, 25959777, -12996065)/2^25, b = a + gap (-1/2, 1, 3/4), w = "
          "(1, 2, 2)/3",
          {"theta", "gap"},
          {{"x", "1"}, {"y", "1"}, {"z", "1"}},
          {{2, 1}, {-6, 0.0078125}, {2, 0x1p-30}},
          "Rodrigues' formula, applied to a x b",
          by_rodrigues,
          "two reflections, applied to a and b",
          by_reflections,
          "the first route",
          by_rodrigues};
}

}  // namespace oddity::truth
