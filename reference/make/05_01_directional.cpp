#include "reference/make/fields.hpp"

namespace oddity::truth {

Truth truth_05_01_directional() {
  const auto position = [](const auto&, const std::vector<double>&) {
    return [](const auto& x) { return x; };
  };
  const auto along_f = [](const Slopes& d, const auto& waves, const auto& x) {
    const Triple<Number> f = waves.f(x);
    Numbers sum(3);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum[i] += f[j] * d[j][i];
    return sum;
  };
  return field_truth("(f.grad) x, f being the field in reference/make/fields.hpp",
                     "f0 dx/dx0 + f1 dx/dx1 + f2 dx/dx2", {"v0", "v1", "v2"}, {}, field_rows(), position,
                     along_f);
}

}  // namespace oddity::truth
