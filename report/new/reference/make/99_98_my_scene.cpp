#include "reference/make/taylor.hpp"
#include "reference/to_write.hpp"

namespace oddity::truth {

namespace my_scene_99_98 {

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number minus_c_over_m = -Number(in[0]) / in[1];
  const auto rhs = [&](const auto& x, const auto&) { return std::vector{x[1], x[0] * minus_c_over_m}; };
  return {solve_taylor(rhs, {Number(in[2]), Number(0)}, 0, Number(in[3]), digits + 4)[0]};
}

Numbers by_another_route(const std::vector<double>& in, Precision) {
  // It shares neither equations nor algorithm with the series.
  throw StillToWrite(in);
}

}  // namespace my_scene_99_98

Truth truth_99_98_my_scene() {
  using namespace my_scene_99_98;
  std::vector<std::vector<double>> rows;
  for (double c : {10, 40, 160, 640})
    for (double t : {2.5, 5.0, 7.5, 10.0}) rows.push_back({c, 1, 0.125, t});
  return {"stretch of a spring, t after its mass was let go",
          "m x'' = -c x",
          {"c", "m", "x0", "t"},
          {{"x", "m"}},
          rows,
          "Taylor series of the equation of motion",
          by_taylor,
          "another route, which shares neither equation nor algorithm with the first",
          by_another_route};
}

}  // namespace oddity::truth
