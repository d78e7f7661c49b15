#include "reference/make/curve_on_sphere.hpp"

namespace oddity::truth {

namespace orientation_02_07 {

Numbers flat(const Matrix& R) {
  Numbers all;
  for (const Vector& row : R) all.insert(all.end(), row.begin(), row.end());
  return all;
}
Numbers by_angles(const std::vector<double>& in, int) {
  return flat(curve_on_sphere::frame_by_angles(Number(in[0])));
}
Numbers by_positions(const std::vector<double>& in, int digits) {
  return flat(curve_on_sphere::frame_by_positions(Number(in[0]), digits));
}

}  // namespace orientation_02_07

Truth truth_02_07_orientation() {
  using namespace orientation_02_07;
  std::vector<std::vector<double>> rows;
  for (double t : {0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0})
    rows.push_back({t});
  std::vector<Component> components;
  for (const char* row : {"x", "y", "z"})
    for (const char* column : {"r_", "u_", "rxu_"}) components.push_back({std::string(column) + row, "1"});
  return {"orientation [r u r x u] at t on a curve of the unit sphere, row by row, u the direction of motion",
          "r = ((1 - t^2) cos(pi t), (1 - t^2) sin(pi t), t^2)/sqrt((1 - t^2)^2 + t^4), u = r'/|r'|",
          {"t"},
          components,
          rows,
          "latitude and longitude of r and their rates",
          by_angles,
          "central differences of the position, extrapolated",
          by_positions,
          "the first route",
          by_angles};
}

}  // namespace oddity::truth
