#include "reference/make/03_17_foucault.hpp"

namespace oddity::truth {

namespace bob_03_17 {

Numbers plane(Numbers s) { return {s[0], s[1]}; }
Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  return plane(foucault::by_taylor(in, digits));
}

}  // namespace bob_03_17

Truth truth_03_17_bob() {
  using namespace bob_03_17;
  std::vector<std::vector<double>> sets{{0.75, 1, 0.0625, 9.81, 0.5, 0.25, 1, 0},
                                        {0.8526, 67, 7.292115e-5, 9.81, 0.5, 0.0447, 0, 0},
                                        {-0.25, 1, 1, 9.81, 2, 1.5, 0.5, 0},
                                        {0.75, 1, 0.0625, 9.81, 0.5, 0, 0, 0.75},
                                        {0.75, 1.25, 0.0625, 9.81, 0.5, 0.25, 1, 0}};
  for (double theta_dot : {3.0, 0.25, 0.125, 0.0625})
    sets.push_back({0.75, 1, 0.0625, 9.81, 0.5, 0.25, theta_dot, 0});
  std::vector<std::vector<double>> rows;
  for (auto set : sets)
    for (double t : {4, 8, 12, 16}) {
      auto row = set;
      row.push_back(t);
      rows.push_back(row);
    }
  return {"horizontal position, to the west and to the north, of a Foucault pendulum's bob",
          foucault::formula,
          foucault::inputs,
          {{"x", "m"}, {"y", "m"}},
          rows,
          foucault::first_route,
          by_taylor,
          foucault::second_route,
          [](const std::vector<double>& in, Precision digits) {
            return plane(foucault::by_extrapolation(in, digits));
          },
          "the first route, the remainders bounded",
          by_taylor};
}

}  // namespace oddity::truth
