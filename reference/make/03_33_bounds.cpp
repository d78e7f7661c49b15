#include "reference/make/routes.hpp"

// The heights of a nutating top's axis: the roots in [-1, 1] of (e - 2 alpha u)(1 - u^2) - (b - a u)^2.
namespace oddity::truth {

namespace bounds_03_33 {

struct Cubic {
  Number alpha, a, b, e, u0;

  explicit Cubic(const std::vector<double>& in) {
    const Number m = in[0], l = in[1], mu1 = in[2], mu3 = in[3], g = in[4], phi = in[5], dtheta = in[6],
                 dphi = in[7], dpsi = in[8];
    u0 = cos(phi);
    alpha = m * g * l / mu1;
    a = mu3 * (dpsi + dtheta * u0) / mu1;
    b = a * u0 + dtheta * (1 - u0 * u0);
    e = dphi * dphi + dtheta * dtheta * (1 - u0 * u0) + 2 * alpha * u0;
  }
  Number operator()(const Number& u) const {
    return (e - 2 * alpha * u) * (1 - u * u) - (b - a * u) * (b - a * u);
  }
};

/// Viete's angles for the cubic with three real roots.
Numbers by_angles(const std::vector<double>& in, int) {
  const Cubic f(in);
  const Number lead = 2 * f.alpha, p2 = -(f.e + f.a * f.a) / lead, p1 = (2 * f.a * f.b - lead) / lead,
               p0 = (f.e - f.b * f.b) / lead;
  const Number third = p2 / 3, q = third * third - p1 / 3,
               r = third * third * third - third * p1 / 2 + p0 / 2;
  const Number angle = acos(Number(r / (q * sqrt(q)))), size = -2 * sqrt(q);
  return {size * cos(Number(angle / 3)) - third, size * cos(Number((angle - 2 * pi()) / 3)) - third};
}

Numbers by_bisection(const std::vector<double>& in, int digits) {
  const Cubic f(in);
  const auto root = [&](Number outside) {
    Number inside = f.u0;
    while (abs(Number(inside - outside)) > pow(Number(10), -digits - 6)) {
      const Number middle = (inside + outside) / 2;
      (f(middle) > 0 ? inside : outside) = middle;
    }
    return Number((inside + outside) / 2);
  };
  return {root(-1), root(1)};
}

}  // namespace bounds_03_33

Truth truth_03_33_bounds() {
  using namespace bounds_03_33;
  return {"least and greatest height cos(phi) of the axis of a heavy symmetric top with fixed tip",
          "(e - 2 alpha u)(1 - u^2) - (b - a u)^2 = 0, alpha = m g l/mu1, a = mu3 c/mu1, b = gamma/mu1",
          {"m", "l", "mu1", "mu3", "g", "phi", "dtheta", "dphi", "dpsi"},
          {{"lowest", "1"}, {"highest", "1"}},
          {{1, 0.25, 0.125, 0.0625, 9.81, 0.5, 0.5, 0.25, 30},
           {1, 0.25, 0.125, 0.0625, 9.81, 0.5, 6.4, -0.5, 18},
           {1, 0.25, 0.125, 0.0625, 9.81, 2, 1, 1, 5}},
          "Viete's trigonometric solution",
          by_angles,
          "bisection between the start and the poles",
          by_bisection,
          "the first route",
          by_angles};
}

}  // namespace oddity::truth
