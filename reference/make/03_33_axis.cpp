#include "reference/make/03_33_top.hpp"

// The axis of the heavy symmetric top with its tip fixed.
namespace oddity::truth {

namespace axis_03_33 {

std::vector<double> at_rest(std::vector<double> in) {
  in.insert(in.end() - 1, 2, 0.0);
  return in;
}
Numbers by_momentum(const std::vector<double>& in, Precision digits) {
  return axis_by_momentum(at_rest(in), digits);
}

}  // namespace axis_03_33

Truth truth_03_33_axis() {
  using namespace axis_03_33;
  std::vector<std::vector<double>> rows;
  std::vector<std::vector<double>> starts{
      {1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, 30},  // default: precesses and nutates
      {1, 0.25, 0.125, 0.0625, 9.81, 0, 0, 0, 0, 0.5, 16},             // upright, struck, too slow to sleep
      {1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 6.4, -0.5, 18},  // passes close to the vertical
      {1, 0.25, 0.125, 0.0625, 9.81, 0, 2, 0, 1, 1, 5}};               // hangs and loops
  for (double spin : {100.0, 60.0, 20.0, 10.0, 5.0})
    starts.push_back({1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, spin});
  for (const auto& start : starts)
    for (double t : {1.0, 2.0, 3.0, 4.0}) {
      rows.push_back(start);
      rows.back().push_back(t);
    }
  return {
      "unit vector along the axis of a heavy symmetric top with fixed tip, the time t after its start; "
      "Euler angles in the order z (theta), x (phi), z (psi), moments about the tip",
      "L' = l d x (-m g k), d' = L x d / mu1",
      {"m", "l", "mu1", "mu3", "g", "theta", "phi", "psi", "dtheta", "dphi", "dpsi", "t"},
      {{"x", "1"}, {"y", "1"}, {"z", "1"}},
      rows,
      "Taylor series of the axis and the angular momentum",
      by_momentum,
      "extrapolated midpoint rule on the quaternion and Euler's equations in body coordinates",
      [](const std::vector<double>& in, Precision digits) { return axis_by_quaternion(at_rest(in), digits); },
      "the first route, the remainders bounded",
      by_momentum};
}

}  // namespace oddity::truth
