#include <utility>

#include "reference/truth.hpp"

namespace oddity::truth {

namespace coefficients_07_07 {

Numbers vector(const std::vector<double>& in, std::size_t i) {
  return {in[3 * i], in[3 * i + 1], in[3 * i + 2]};
}

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Number dot(const Numbers& a, const Numbers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The coefficients of p over three vectors by triple products.
Numbers over(const Numbers& a, const Numbers& b, const Numbers& c, const Numbers& p) {
  const Number volume = dot(a, cross(b, c));
  return {dot(p, cross(b, c)) / volume, dot(p, cross(c, a)) / volume, dot(p, cross(a, b)) / volume};
}

/// The coefficients by elimination with row exchanges.
Numbers solved(const Numbers& a, const Numbers& b, const Numbers& c, const Numbers& p) {
  std::vector<Numbers> m;
  for (std::size_t i = 0; i < 3; ++i) m.push_back({a[i], b[i], c[i], p[i]});
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 3; ++i)
      if (abs(m[i][k]) > abs(m[pivot][k])) pivot = i;
    std::swap(m[k], m[pivot]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == k) continue;
      const Number ratio = m[i][k] / m[k][k];
      for (std::size_t j = k; j < 4; ++j) m[i][j] -= ratio * m[k][j];
    }
  }
  return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

Numbers both(const std::vector<double>& in, const auto& coefficients) {
  const Numbers u = vector(in, 0), v = vector(in, 1), w = vector(in, 2), p = vector(in, 3);
  Numbers all = coefficients(u, v, w, p);
  for (const Number& x : coefficients(cross(u, v), cross(v, w), cross(w, u), p)) all.push_back(x);
  return all;
}

Numbers by_triple_products(const std::vector<double>& in, int) { return both(in, over); }

std::vector<double> nearly_dependent(double gap) {
  return {0.83,
          -0.41,
          0.57,
          0.29,
          0.91,
          -0.33,
          0.6 * 0.83 + 0.3 * 0.29 + gap,
          0.6 * -0.41 + 0.3 * 0.91 - gap,
          0.6 * 0.57 + 0.3 * -0.33 + 2 * gap,
          0.71,
          0.37,
          1.13};
}

}  // namespace coefficients_07_07

Truth truth_07_07_coefficients() {
  using namespace coefficients_07_07;
  std::vector<std::vector<double>> rows;
  for (double gap : {1.0, 1e-3, 1e-6, 1e-10, 1e-13}) rows.push_back(nearly_dependent(gap));
  return {"coefficients of p = x u + y v + z w, and of p = x' u x v + y' v x w + z' w x u",
          "solutions of two systems of three equations",
          {"u1", "u2", "u3", "v1", "v2", "v3", "w1", "w2", "w3", "p1", "p2", "p3"},
          {{"x", "1"}, {"y", "1"}, {"z", "1"}, {"x'", "1"}, {"y'", "1"}, {"z'", "1"}},
          rows,
          "triple products",
          by_triple_products,
          "elimination with exchange of rows",
          [](const std::vector<double>& in, int) { return both(in, solved); },
          "the first route",
          by_triple_products};
}

}  // namespace oddity::truth
