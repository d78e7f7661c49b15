#include "reference/make/fields.hpp"

// x_i / |x|^3 is differentiated along x_i on the line and on a circle around x_i in the complex plane, where
// it is analytic up to the distance |x|.
namespace oddity::truth {

namespace partials_05_03 {

template <class T>
Triple<T> field(const Triple<T>& x) {
  const T square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], cube = square * sqrt(square);
  return {x[0] / cube, x[1] / cube, x[2] / cube};
}

Triple<Number> point(const std::vector<double>& in) { return {Number(in[0]), Number(in[1]), Number(in[2])}; }
Number length(const Triple<Number>& x) { return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

Numbers by_differences(const std::vector<double>& in, int) {
  const Triple<Number> x = point(in);
  const Number r = length(x);
  Numbers all;
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(r * r * r * slope_by_differences(field<Number>, x, i, Number(r / 16))[i]);
  return all;
}

Numbers by_cauchy(const std::vector<double>& in, int) {
  const Triple<Number> x = point(in);
  const Triple<Complex> z{complex(x[0]), complex(x[1]), complex(x[2])};
  const Number r = length(x);
  Numbers all;
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(r * r * r * real(slope_by_cauchy(field<Complex>, z, i, Number(r / 16))[i]));
  return all;
}

Numbers by_dual_numbers(const std::vector<double>& in, int) {
  const Triple<Number> x = point(in);
  const Number r = length(x);
  Numbers all;
  for (std::size_t i = 0; i < 3; ++i)
    all.push_back(r * r * r * slope_by_dual_numbers(field<Dual<Number>>, x, i)[i]);
  return all;
}

}  // namespace partials_05_03

Truth truth_05_03_partials() {
  using namespace partials_05_03;
  std::vector<std::vector<double>> rows{{0.3, -0.7, 0.9}, {1, 1, 1}, {1, 0, 0}};
  for (int k : {-20, 180}) rows.push_back({std::ldexp(0.3, k), std::ldexp(-0.7, k), std::ldexp(0.9, k)});
  return {"the derivatives by x_i of x_i / |x|^3, times |x|^3",
          "|x|^3 d/dx_i (x_i / |x|^3)",
          {"x0", "x1", "x2"},
          {{"d0", "1"}, {"d1", "1"}, {"d2", "1"}},
          rows,
          "differences, extrapolated to step zero",
          by_differences,
          "Cauchy's integral over a circle of radius |x|/16, by the trapezoid rule",
          by_cauchy,
          "derivatives by dual numbers",
          by_dual_numbers};
}

}  // namespace oddity::truth
