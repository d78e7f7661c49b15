#include "reference/make/taylor.hpp"

// m x'' + a x' + c x = 0 in each coordinate. With h = a/(2m) and d = h^2 - c/m:
//   x = exp(-h t) (p C + (v + h p) S),   C = cosh(sqrt(d) t),   S = sinh(sqrt(d) t)/sqrt(d).
// For d < 0 these become cos and sin; for d = 0, 1 and t.
namespace oddity::truth {

namespace ball_03_09 {

Numbers by_closed_form(const std::vector<double>& in, int) {
  const Number m = in[0], c = in[1], a = in[2], t = in[7];
  const Number h = a / (2 * m), d = h * h - c / m, w = sqrt(Number(abs(d)));
  const Number even = d > 0 ? Number(cosh(w * t)) : Number(cos(w * t));
  const Number odd = d == 0 ? t : d > 0 ? Number(sinh(w * t) / w) : Number(sin(w * t) / w);
  const auto at = [&](const Number& p, const Number& v) {
    return Number(exp(-h * t) * (p * even + (v + h * p) * odd));
  };
  return {at(in[3], in[5]), at(in[4], in[6])};
}

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number stiffness = -Number(in[1]) / Number(in[0]), friction = -Number(in[2]) / Number(in[0]);
  const auto rhs = [&](const auto& x, const auto&) {
    return std::vector{x[2], x[3], stiffness * x[0] + friction * x[2], stiffness * x[1] + friction * x[3]};
  };
  const Numbers end = solve_taylor(rhs, {Number(in[3]), Number(in[4]), Number(in[5]), Number(in[6])}, 0,
                                   Number(in[7]), digits);
  return {end[0], end[1]};
}

}  // namespace ball_03_09

Truth truth_03_09_ball() {
  using namespace ball_03_09;
  std::vector<std::vector<double>> rows;
  for (double a : {0.4, 4.0, 4 * (1 + 1e-13), 40.0, 80.0, 200.0, 1000.0})
    for (double t : {1.25, 2.5, 3.75, 5.0}) rows.push_back({1, 4, a, 1, 0.5, 0, 1.5, t});
  return {"position in the plane of a ball on a spring with viscous friction",
          "m x'' + a x' + c x = 0, x(0) = p, x'(0) = v",
          {"m", "c", "a", "p1", "p2", "v1", "v2", "t"},
          {{"x1", "m"}, {"x2", "m"}},
          rows,
          "the closed form in 60 digits",
          by_closed_form,
          "Taylor series of the equation of motion",
          by_taylor,
          "the first route",
          by_closed_form};
}

}  // namespace oddity::truth
