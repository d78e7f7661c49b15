#include <limits>

#include "reference/make/03_31_box.hpp"

// Time, place and angle at which a box that slides and turns on a rough level plane comes to rest.
namespace oddity::truth {

namespace rest_03_31 {

constexpr double for_ever = std::numeric_limits<double>::infinity();

}  // namespace rest_03_31

Truth truth_03_31_rest() {
  using namespace rest_03_31;
  return {
      "when and where a box comes to rest that slides and turns on a rough level plane",
      "u' = -mu g <n>, (a^2 + b^2)/3 w' = -mu g <rho x n>, n the direction of the velocity at the point rho "
      "of the contact, <> the mean over it",
      {"a", "b", "mu", "g", "u", "v", "w"},
      {{"t", "s"}, {"x", "m"}, {"y", "m"}, {"theta", "rad"}},
      {{0.3, 0.2, 0.3, 9.81, 2, 0.5, 10},
       {0.3, 0.2, 0.3, 9.81, 2, 0.5, 0.5},
       {0.5, 0.05, 0.3, 9.81, 2, 0.5, 10},
       {0.3, 0.2, 0.3, 9.81, 0.2, 0, 20}},
      "extrapolated midpoint rule, velocities in space, in a time stretched by the speed",
      [](const std::vector<double>& in, int digits) {
        return rough_box::velocity_in_space(in, for_ever, digits);
      },
      "extrapolated midpoint rule, the direction of motion in the box's axes and the logarithm of the speed",
      [](const std::vector<double>& in, int digits) {
        return rough_box::velocity_in_the_box(in, for_ever, digits);
      }};
}

}  // namespace oddity::truth
