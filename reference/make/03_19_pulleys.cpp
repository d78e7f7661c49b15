#include "reference/make/03_19_pulleys.hpp"

#include "reference/make/taylor.hpp"

// M x'' + K (x - e) = 0 about the equilibrium e. A function f of A = M^-1 K, with eigenvalues s1 < s2, is
// f(A) = f(s1) 1 + (f(s2) - f(s1))/(s2 - s1) (A - s1 1). Then
// x = e + cos(sqrt(A) t) (x0 - e) + sin(sqrt(A) t)/sqrt(A) v0.
// The second route integrates Newton's laws with the tensions of the ropes on the far sides of their pulleys.
namespace oddity::truth {

namespace pulleys_03_19 {

constexpr std::size_t L1 = 8, L2 = 9, K1 = 10, K2 = 11, g = 12, y2 = 13, y3 = 14, v2 = 15, v3 = 16, time = 17;

Numbers by_modes(const std::vector<double>& in, int) {
  const auto a = pulleys::matrices(in);
  const Number c1 = in[6], c2 = in[7], t = in[time];
  const Number stretch2 = Number(in[1]) * in[g] / c2,
               stretch1 = (Number(in[0]) + 2 * Number(in[1])) * in[g] / c1;
  const Number e2 = in[L1] - Number(in[K1]) + stretch1, e3 = in[L2] - Number(in[K2]) + stretch2 + 2 * e2;
  const Number det = a.m22 * a.m33 - a.m23 * a.m23;
  const Number A[2][2] = {{(a.m33 * a.k22 - a.m23 * a.k23) / det, (a.m33 * a.k23 - a.m23 * a.k33) / det},
                          {(a.m22 * a.k23 - a.m23 * a.k22) / det, (a.m22 * a.k33 - a.m23 * a.k23) / det}};
  const Numbers s = pulleys::squares(in);
  const auto apply = [&](const Number& f1, const Number& f2, const Number& x, const Number& y) {
    const Number slope = s[0] == s[1] ? Number(0) : Number((f2 - f1) / (s[1] - s[0]));
    return Numbers{f1 * x + slope * ((A[0][0] - s[0]) * x + A[0][1] * y),
                   f1 * y + slope * (A[1][0] * x + (A[1][1] - s[0]) * y)};
  };
  const Number w1 = sqrt(s[0]), w2 = sqrt(s[1]);
  const Numbers p = apply(cos(w1 * t), cos(w2 * t), in[y2] - e2, in[y3] - e3),
                q = apply(sin(w1 * t) / w1, sin(w2 * t) / w2, in[v2], in[v3]);
  return {e2 + p[0] + q[0], e3 + p[1] + q[1]};
}

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number c1 = in[6], c2 = in[7], rest1 = Number(in[K1]) - in[L1], rest2 = Number(in[K2]) - in[L2];
  const Number weight2 = Number(in[0]) * in[g], weight3 = Number(in[1]) * in[g];
  const auto by = pulleys::accelerations(in);
  const auto rhs = [&](const auto& x, const auto&) {
    const auto pull1 = c1 * (x[0] + rest1), pull2 = c2 * (x[1] - Number(2) * x[0] + rest2);
    const auto acceleration = [&](const auto& a) {
      return a[0] * (weight2 + pull2) + a[1] * weight3 - a[2] * pull1 - a[3] * pull2;
    };
    return std::vector{x[2], x[3], acceleration(by[0]), acceleration(by[1])};
  };
  const Numbers end = solve_taylor(rhs, {in[y2], in[y3], in[v2], in[v3]}, 0, Number(in[time]), digits + 2);
  return {end[0], end[1]};
}

}  // namespace pulleys_03_19

Truth truth_03_19_pulleys() {
  using namespace pulleys_03_19;
  std::vector<std::vector<double>> sets{
      {1, 2, 0.5, 0.25, 0.5, 0.5, 40, 30, 1, 1, 1, 1.5, 9.81, 1, 2.5, 0.25, -0.5},
      {1, 2, 0.5, 0.25, 0.5, 0.5, 40, 30, 1, 1, 1, 1.5, 9.81, 2, 5, 0, 0},
      {0.25, 8, 4, 0.125, 0.5, 0.25, 1000, 20, 0.5, 2, 0.25, -1, 9.81, 0.5, 4, 1, 2}};
  for (double c1 : {10.0, 160.0, 1000.0, 10000.0})
    sets.push_back({1, 2, 0.5, 0.25, 0.5, 0.5, c1, 30, 1, 1, 1, 1.5, 9.81, 1, 2.5, 0.25, -0.5});
  std::vector<std::vector<double>> rows;
  for (auto set : sets)
    for (double t : {2, 4, 6, 8}) {
      auto row = set;
      row.push_back(t);
      rows.push_back(row);
    }
  return {"depth of the small pulley and of the mass below the ceiling",
          "M x'' + K (x - e) = 0, in matrices of 03_19_frequencies; at rest c2 (S2 - L2) = m3 g and c1 (S1 - "
          "L1) = (m2 + 2 m3) g, S1 = y2 + K1, S2 = y3 - 2 y2 + K2",
          {"m2", "m3", "I1", "I2", "R1", "R2", "c1", "c2", "L1", "L2", "K1", "K2", "g", "y2", "y3", "v2",
           "v3", "t"},
          {{"y2", "m"}, {"y3", "m"}},
          rows,
          "functions of the matrix M^-1 K in 60 digits",
          by_modes,
          "Taylor series of Newton's laws with the ropes' tensions",
          by_taylor,
          "the first route",
          by_modes};
}

}  // namespace oddity::truth
