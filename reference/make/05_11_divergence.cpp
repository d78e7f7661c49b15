#include "reference/make/fields.hpp"

// The cross product is differentiated as one field: no product rule is used.
namespace oddity::truth {

Truth truth_05_11_divergence() {
  const auto product = [](const auto& waves, const std::vector<double>&) {
    return [waves](const auto& x) {
      const auto f = waves.f(x), g = waves.g(x);
      auto h = f;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        h[i] = f[j] * g[k] - f[k] * g[j];
      }
      return h;
    };
  };
  const auto divergence = [](const Slopes& d, const auto&, const auto&) {
    return Numbers{d[0][0] + d[1][1] + d[2][2]};
  };
  return field_truth(
      "divergence of the cross product h = f x g of the two fields in reference/make/fields.hpp",
      "div h = dh0/dx0 + dh1/dx1 + dh2/dx2", {"div"}, {}, field_rows(), product, divergence);
}

}  // namespace oddity::truth
