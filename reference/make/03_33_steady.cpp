#include "reference/make/routes.hpp"

// The two rates of steady precession at the tilt phi and the spin c: mu1 W^2 cos(phi) - mu3 c W + m g l = 0.
namespace oddity::truth {

namespace steady_03_33 {

Numbers by_formula(const std::vector<double>& in, int) {
  const Number m = in[0], l = in[1], mu1 = in[2], mu3 = in[3], g = in[4], c = in[6];
  const Number across = mu1 * cos(Number(in[5])), weight = m * g * l, momentum = mu3 * c;
  const Number far = (momentum + sqrt(momentum * momentum - 4 * across * weight)) / 2;
  return {weight / far, far / across};
}

/// Newton's method on the torque equation d/dt(L) = W k x L = r x (-m g k), from beyond either root.
Numbers by_newton(const std::vector<double>& in, int) {
  const Number m = in[0], l = in[1], mu1 = in[2], mu3 = in[3], g = in[4], c = in[6];
  const Number s = sin(Number(in[5])), u = cos(Number(in[5]));
  const auto root = [&](Number rate) {
    for (int i = 0; i < 400; ++i) {
      const Number horizontal = mu3 * c * s - mu1 * rate * s * u;
      const Number miss = rate * horizontal - m * g * l * s;
      rate -= miss / (horizontal - mu1 * rate * s * u);
    }
    return rate;
  };
  return {root(0), root(Number(mu3 * c / (mu1 * u)))};
}

}  // namespace steady_03_33

Truth truth_03_33_steady() {
  using namespace steady_03_33;
  return {"slow and fast rate of steady precession of a heavy symmetric top of tilt phi and spin c",
          "mu1 W^2 cos(phi) - mu3 c W + m g l = 0",
          {"m", "l", "mu1", "mu3", "g", "phi", "c"},
          {{"slow", "rad/s"}, {"fast", "rad/s"}},
          {{1, 0.25, 0.125, 0.0625, 9.81, 0.5, 30},
           {1, 0.25, 0.125, 0.0625, 9.81, 0.5, 1048576},
           {1, 0.25, 0.125, 0.0625, 9.81, 0.5, 17.5},
           {1, 0.25, 0.125, 0.0625, 9.81, 2, 30}},
          "the quadratic's formula",
          by_formula,
          "Newton's method on the balance of torques",
          by_newton,
          "the first route",
          by_formula};
}

}  // namespace oddity::truth
