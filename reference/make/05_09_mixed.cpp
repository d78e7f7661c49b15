#include "reference/make/fields.hpp"

// Each mixed derivative of phi in both orders: the inner derivative is taken as a separate field.
namespace oddity::truth {

namespace mixed_05_09 {

/// The components: the first and the second variable of differentiation.
constexpr std::array<std::array<std::size_t, 2>, 6> orders{{{1, 2}, {2, 1}, {2, 0}, {0, 2}, {0, 1}, {1, 0}}};

Numbers by_differences(const std::vector<double>& in, int) {
  const Waves<Number> waves{Number(in[0])};
  const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
  const Number radius = radius_for(waves.w);
  const auto phi = [&](const Triple<Number>& y) { return Triple<Number>{waves.phi(y), 0, 0}; };
  Numbers all;
  for (const auto& order : orders) {
    const auto inner = [&](const Triple<Number>& y) {
      return slope_by_differences(phi, y, order[0], radius);
    };
    all.push_back(slope_by_differences(inner, x, order[1], radius)[0]);
  }
  return all;
}

Numbers by_cauchy(const std::vector<double>& in, int) {
  constexpr int points = 44;
  const Waves<Complex> waves{Complex(in[0])};
  const Triple<Complex> x{Complex(in[1]), Complex(in[2]), Complex(in[3])};
  const Number radius = radius_for(Number(in[0]));
  const auto phi = [&](const Triple<Complex>& y) {
    return Triple<Complex>{waves.phi(y), Complex(0), Complex(0)};
  };
  Numbers all;
  for (const auto& order : orders) {
    const auto inner = [&](const Triple<Complex>& y) {
      return slope_by_cauchy(phi, y, order[0], radius, points);
    };
    all.push_back(real(slope_by_cauchy(inner, x, order[1], radius, points)[0]));
  }
  return all;
}

Numbers by_dual_numbers(const std::vector<double>& in, int) {
  using Second = Dual<Dual<Number>>;
  const Waves<Second> waves{{{Number(in[0]), 0}, {0, 0}}};
  const Triple<Number> x{Number(in[1]), Number(in[2]), Number(in[3])};
  Numbers all;
  for (const auto& order : orders) {
    const auto inner = [&](const Triple<Dual<Number>>& y) {
      const auto phi = [&](const Triple<Second>& z) {
        const Second value = waves.phi(z);
        return Triple<Second>{value, value, value};
      };
      return slope_by_dual_numbers(phi, y, order[0]);
    };
    all.push_back(slope_by_dual_numbers(inner, x, order[1])[0]);
  }
  return all;
}

}  // namespace mixed_05_09

Truth truth_05_09_mixed() {
  using namespace mixed_05_09;
  return {"mixed second derivatives of the field phi in reference/make/fields.hpp, in both orders",
          "phi_ij = d/dx_j (d phi / dx_i)",
          {"w", "x0", "x1", "x2"},
          {{"phi_12", "1/m^2"},
           {"phi_21", "1/m^2"},
           {"phi_20", "1/m^2"},
           {"phi_02", "1/m^2"},
           {"phi_01", "1/m^2"},
           {"phi_10", "1/m^2"}},
          field_rows(),
          "differences of differences, each extrapolated to step zero",
          by_differences,
          "Cauchy's integral of Cauchy's integral over circles, by the trapezoid rule",
          by_cauchy,
          "derivatives by dual numbers of dual numbers",
          by_dual_numbers};
}

}  // namespace oddity::truth
