#include "reference/make/routes.hpp"

// Columns: the integral over x^2 <= y <= 1 of x^p y^q is x^p (1 - x^(2q+2)) / (q + 1), a polynomial in x.
// Rows: the integral over max(left, -sqrt y) <= x <= sqrt y of x^p y^q is a function of y with a root in it.
namespace oddity::truth {

namespace lamina_02_13 {

Number power_integral(const Number& a, const Number& b, int n) {
  return (pow(b, n + 1) - pow(a, n + 1)) / (n + 1);
}

/// Components from the moments of x^p y^q.
Numbers by_columns(const std::vector<double>& in, int) {
  const Number left = in[0], z = in[1], rho = in[2];
  const auto moment = [&](int p, int q) -> Number {
    return (power_integral(left, 1, p) - power_integral(left, 1, p + 2 * q + 2)) / (q + 1);
  };
  const Number xx = moment(2, 0), yy = moment(0, 2), zz = z * z * moment(0, 0);
  return {rho * (yy + zz),
          rho * (xx + zz),
          rho * (xx + yy),
          rho * Number(moment(1, 1)),
          rho * z * Number(moment(1, 0)),
          rho * z * Number(moment(0, 1))};
}

/// Each component by its definition: the integral over a row from x1 to x2, then over y.
Numbers by_rows(const std::vector<double>& in, int digits) {
  const Number left = in[0], z = in[1], rho = in[2], corner = left * left;
  const auto over_rows = [&](const auto& row) -> Number {
    const auto cut = [&](const Number& y) -> Number { return row(y, left, sqrt(y)); };
    const auto whole = [&](const Number& y) -> Number { return row(y, Number(-sqrt(y)), sqrt(y)); };
    Number sum = corner < 1 ? integral(cut, corner, 1, digits) : Number(0);
    if (left < 0) sum += integral(whole, 0, corner, digits);
    return rho * sum;
  };
  using N = const Number&;
  const auto squares = [](N x1, N x2) -> Number { return (x2 - x1) * (x1 * x1 + x1 * x2 + x2 * x2) / 3; };
  const auto sides = [](N x1, N x2) -> Number { return (x2 - x1) * (x1 + x2) / 2; };
  return {over_rows([&](N y, N x1, N x2) -> Number { return (x2 - x1) * (y * y + z * z); }),
          over_rows([&](N, N x1, N x2) -> Number { return squares(x1, x2) + (x2 - x1) * z * z; }),
          over_rows([&](N y, N x1, N x2) -> Number { return squares(x1, x2) + (x2 - x1) * y * y; }),
          over_rows([&](N y, N x1, N x2) -> Number { return sides(x1, x2) * y; }),
          over_rows([&](N, N x1, N x2) -> Number { return sides(x1, x2) * z; }),
          over_rows([&](N y, N x1, N x2) -> Number { return (x2 - x1) * y * z; })};
}

}  // namespace lamina_02_13

Truth truth_02_13_lamina() {
  using namespace lamina_02_13;
  return {"inertia of the lamina x^2 <= y <= 1, left <= x <= 1 in the plane at height z, density rho",
          "Ixx = rho int y^2 + z^2, Iyy = rho int x^2 + z^2, Izz = rho int x^2 + y^2, Ixy = rho int x y, ...",
          {"left", "z", "rho"},
          {{"Ixx", "1"}, {"Iyy", "1"}, {"Izz", "1"}, {"Ixy", "1"}, {"Ixz", "1"}, {"Iyz", "1"}},
          {{-1, 0, 1}, {-1, 0.5, 2}, {-0.625, 1.5, 1}, {0.25, -2, 3}, {0.875, 10, 1}},
          "columns: polynomials in x",
          by_columns,
          "rows: double-exponential quadrature over y",
          by_rows,
          "the first route",
          by_columns};
}

}  // namespace oddity::truth
