#include "reference/make/fields.hpp"

// The dot product is differentiated as one field: no product rule is used.
namespace oddity::truth {

Truth truth_05_13_gradient() {
  const auto product = [](const auto& waves, const std::vector<double>&) {
    return [waves](const auto& x) {
      const auto f = waves.f(x), g = waves.g(x);
      auto h = f;
      h.fill(f[0] * g[0] + f[1] * g[1] + f[2] * g[2]);
      return h;
    };
  };
  const auto gradient = [](const Slopes& d, const auto&, const auto&) {
    return Numbers{d[0][0], d[1][0], d[2][0]};
  };
  return field_truth("gradient of the dot product h = f.g of the two fields in reference/make/fields.hpp",
                     "grad h = (dh/dx0, dh/dx1, dh/dx2)", {"grad0", "grad1", "grad2"}, {}, field_rows(),
                     product, gradient);
}

}  // namespace oddity::truth
