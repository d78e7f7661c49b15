#include "reference/make/03_33_top.hpp"

// The axis of the heavy symmetric top whose tip is at (A sin(lambda t), 0, 0).
namespace oddity::truth {

Truth truth_03_35_axis() {
  std::vector<std::vector<double>> rows;
  const std::vector<double> tilted{1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, 30};
  const std::vector<double> upright{1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.015625, 0.75, 0, 0, 30};
  const auto add = [&](std::vector<double> row, double A, double lambda, double t) {
    row.insert(row.end(), {A, lambda, t});
    rows.push_back(row);
  };
  for (double t : {1.0, 2.0, 3.0, 4.0}) {
    add(tilted, 0.0625, 3, t);
    add(tilted, 0.0078125, 14.171875, t);  // near the nutation's frequency
    add(tilted, 0.25, 8, t);               // shaken harder than gravity pulls
    add(upright, 0.00390625, 3, t);
    for (double lambda : {0.5, 1.5, 6.0, 10.0, 14.0})
      if (lambda != 6 || t != 4) add(tilted, 0.0625, lambda, t);
  }
  add(tilted, 0, 3, 4);
  add(tilted, 0.0078125, 3, 4);
  add(tilted, 0.0625, 6, 4);
  add(tilted, 0.0625, 14.171875, 4);
  return {
      "unit vector along the axis of a heavy symmetric top whose tip is at (A sin(lambda t), 0, 0), the "
      "time t after its start; Euler angles in the order z (theta), x (phi), z (psi), moments about the "
      "tip",
      "L' = l d x (-m g k - m p''), d' = L x d / mu1, p the tip, L the angular momentum about it",
      {"m", "l", "mu1", "mu3", "g", "theta", "phi", "psi", "dtheta", "dphi", "dpsi", "A", "lambda", "t"},
      {{"x", "1"}, {"y", "1"}, {"z", "1"}},
      rows,
      "Taylor series of the axis and the angular momentum",
      axis_by_momentum,
      "extrapolated midpoint rule on the quaternion and Euler's equations in body coordinates",
      axis_by_quaternion,
      "the first route, the remainders bounded",
      axis_by_momentum};
}

}  // namespace oddity::truth
