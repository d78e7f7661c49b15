#include "reference/make/routes.hpp"

// Coordinates with respect to axes turned counterclockwise by pi/4, with the same origin.
namespace oddity::truth {

namespace coordinates_08_01 {

Numbers by_projection(const std::vector<double>& in, int) {
  const Number x = in[0], y = in[1], root = sqrt(Number(2));
  return {(x + y) / root, (y - x) / root};
}

/// By the polar angle, less pi/4.
Numbers by_angle(const std::vector<double>& in, int) {
  const Number x = in[0], y = in[1], radius = sqrt(x * x + y * y), angle = atan2(y, x) - pi() / 4;
  return {radius * cos(angle), radius * sin(angle)};
}

}  // namespace coordinates_08_01

Truth truth_08_01_coordinates() {
  using namespace coordinates_08_01;
  return {"coordinates of the point (a1, a2) on axes turned counterclockwise by pi/4",
          "b = R^T a, R the counterclockwise rotation by pi/4",
          {"a1", "a2"},
          {{"b1", "m"}, {"b2", "m"}},
          {{2, 0.5}, {-3, 1}, {1, 1.0 / 1024}},
          "projections on the turned axes",
          by_projection,
          "polar coordinates",
          by_angle,
          "the first route",
          by_projection};
}

}  // namespace oddity::truth
