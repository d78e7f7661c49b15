#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

// On x3 = -x1^2/a1^2 - x2^2/a2^2. With b = 2/a^2 the gradient is -(b1 x1, b2 x2).
//   accelerations  x'' = (g - b1 x1'^2 - b2 x2'^2) / (1 + |grad|^2) (b1 x1, b2 x2)
//   momenta        p = x' + (grad . x') grad,  p' = (grad . x') d(grad)/dt - g grad
namespace oddity::truth {

namespace hill_03_11 {

Numbers on_the_hill(const std::vector<double>& in, const Numbers& x) {
  const Number a1 = in[0], a2 = in[1];
  return {x[0], x[1], -(x[0] * x[0] / (a1 * a1)) - x[1] * x[1] / (a2 * a2)};
}

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number b1 = 2 / (Number(in[0]) * in[0]), b2 = 2 / (Number(in[1]) * in[1]), g = in[2], one = 1;
  const auto rhs = [&](const auto& x, const auto&) {
    const auto n1 = b1 * x[0], n2 = b2 * x[1];
    const auto push = (g - b1 * (x[2] * x[2]) - b2 * (x[3] * x[3])) / (one + n1 * n1 + n2 * n2);
    return std::vector{x[2], x[3], push * n1, push * n2};
  };
  return on_the_hill(in, solve_taylor(rhs, {Number(in[3]), Number(in[4]), Number(in[5]), Number(in[6])}, 0,
                                      Number(in[7]), digits + 4));
}

Numbers by_momenta(const std::vector<double>& in, Precision digits) {
  const Number b1 = 2 / (Number(in[0]) * in[0]), b2 = 2 / (Number(in[1]) * in[1]), g = in[2];
  const auto rhs = [&](const Numbers& x, const Number&) {
    const Number n1 = -b1 * x[0], n2 = -b2 * x[1];
    const Number rise = (n1 * x[2] + n2 * x[3]) / (1 + n1 * n1 + n2 * n2);
    const Number v1 = x[2] - rise * n1, v2 = x[3] - rise * n2;
    return Numbers{v1, v2, -rise * b1 * v1 - g * n1, -rise * b2 * v2 - g * n2};
  };
  const Number p1 = in[3], p2 = in[4], v1 = in[5], v2 = in[6];
  const Number rise = -b1 * p1 * v1 - b2 * p2 * v2;
  const Numbers start{p1, p2, v1 - rise * b1 * p1, v2 - rise * b2 * p2};
  return on_the_hill(in, solve_extrapolation(rhs, start, 0, Number(in[7]), digits + 4));
}

}  // namespace hill_03_11

Truth truth_03_11_hill() {
  using namespace hill_03_11;
  std::vector<std::vector<double>> starts{
      {1, 2, 10, 0, 0, 2, 2}, {1, 2, 10, 0, 0, 1.5, 1.5}, {1, 2, 10, 0, 0, 3, 3}, {1, 2, 10, 0, 0.25, 2, 2}};
  for (double v : {1.98, 1.8, 1.0, 0.4}) starts.push_back({1, 2, 10, 0, 0, v, v});
  std::vector<std::vector<double>> rows;
  for (const auto& row : starts)
    for (double t : {0.5, 1.0, 1.5, 2.0}) {
      rows.push_back(row);
      rows.back().push_back(t);
    }
  return {"position t after the start at (p1, p2) with (v1, v2) of a point held on the hill",
          "x3 = -x1^2/a1^2 - x2^2/a2^2, gravity along -x3, no friction",
          {"a1", "a2", "g", "p1", "p2", "v1", "v2", "t"},
          {{"x1", "m"}, {"x2", "m"}, {"x3", "m"}},
          rows,
          "Taylor series of the accelerations",
          by_taylor,
          "extrapolated midpoint rule on Hamilton's equations",
          by_momenta,
          "the first route, the remainders bounded",
          by_taylor};
}

}  // namespace oddity::truth
