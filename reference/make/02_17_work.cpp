#include "reference/make/routes.hpp"

// The particle is at (r cos wt, r sin wt, 0). The power is r w (cos wt - sin wt) under (1, 1, 1), and t times
// that under (t, t, 1). With x = w T, the works are r (cos x + sin x - 1) and
// r/w (x (cos x + sin x) + cos x - sin x - 1).
namespace oddity::truth {

namespace work_02_17 {

Numbers by_antiderivative(const std::vector<double>& in, int) {
  const Number r = in[0], w = in[1], x = w * Number(in[2]), c = cos(x), s = sin(x);
  return {r * (c + s - 1), r / w * (x * (c + s) + c - s - 1)};
}

Numbers by_quadrature(const std::vector<double>& in, int digits) {
  const Number r = in[0], w = in[1], end = in[2];
  const auto power = [&](const Number& t) -> Number { return r * w * (cos(w * t) - sin(w * t)); };
  const auto pieces = static_cast<int>(ceil(abs(w * end) / 8));
  Numbers work{0, 0};
  for (int i = 0; i < pieces; ++i) {
    const Number start = end * i / pieces, length = end / pieces;
    const auto shifted = [&](const Number& t) -> Number { return power(start + t); };
    const auto growing = [&](const Number& t) -> Number { return (start + t) * power(start + t); };
    work[0] += integral(shifted, 0, length, digits);
    work[1] += integral(growing, 0, length, digits);
  }
  return work;
}

}  // namespace work_02_17

Truth truth_02_17_work() {
  using namespace work_02_17;
  return {"work done on a particle that circles at the radius r with angular speed omega, in the time T",
          "int_0^T F . v dt for F = (1, 1, 1) and for F = (t, t, 1)",
          {"r", "omega", "T"},
          {{"constant", "J"}, {"growing", "J"}},
          {{1, 1, 10}, {1.5, 2.5, 80}, {0.25, 7, 30}, {1, 1, 1e-5}, {1, 1, 0.78539816339744828}},
          "antiderivatives in sine and cosine",
          by_antiderivative,
          "double-exponential quadrature of the power, piece by piece",
          by_quadrature,
          "the first route",
          by_antiderivative};
}

}  // namespace oddity::truth
