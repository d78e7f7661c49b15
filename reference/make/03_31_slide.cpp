#include "reference/make/03_31_box.hpp"

// Position at time t of a box that slides and turns on a rough level plane. After coming to rest it stays.
namespace oddity::truth {

namespace slide_03_31 {

template <class Until>
Numbers place(const std::vector<double>& in, Precision digits, const Until& until) {
  Numbers all = until({in.begin(), in.begin() + 7}, Number(in[7]), digits);
  all.erase(all.begin());
  return all;
}

}  // namespace slide_03_31

Truth truth_03_31_slide() {
  using namespace slide_03_31;
  std::vector<std::vector<double>> rows;
  for (double mu : {0.3, 0.2, 0.5, 0.7, 1.0})
    for (double t : {0.3125, 0.625, 0.9375, 1.25}) rows.push_back({0.3, 0.2, mu, 9.81, 2, 0.5, 10, t});
  return {
      "position and angle of a box that slides and turns on a rough level plane, t after its start",
      "u' = -mu g <n>, (a^2 + b^2)/3 w' = -mu g <rho x n>, n the direction of the velocity at the point rho "
      "of the contact, <> the mean over it",
      {"a", "b", "mu", "g", "u", "v", "w", "t"},
      {{"x", "m"}, {"y", "m"}, {"theta", "rad"}},
      rows,
      "extrapolated midpoint rule, velocities in space, in a time stretched by the speed",
      [](const std::vector<double>& in, Precision digits) {
        return place(in, digits, rough_box::velocity_in_space);
      },
      "extrapolated midpoint rule, the direction of motion in the box's axes and the logarithm of the speed",
      [](const std::vector<double>& in, Precision digits) {
        return place(in, digits, rough_box::velocity_in_the_box);
      }};
}

}  // namespace oddity::truth
