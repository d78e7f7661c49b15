#include "reference/make/fields.hpp"

// The product is differentiated as one field: no product rule is used.
namespace oddity::truth {

Truth truth_05_07_curl() {
  const auto product = [](const auto& waves, const std::vector<double>&) {
    return [waves](const auto& x) {
      auto v = waves.f(x);
      const auto phi = waves.phi(x);
      for (auto& component : v) component *= phi;
      return v;
    };
  };
  const auto curl = [](const Slopes& d, const auto&, const auto&) {
    return Numbers{d[1][2] - d[2][1], d[2][0] - d[0][2], d[0][1] - d[1][0]};
  };
  return field_truth("curl of the product h = phi f of the two fields in reference/make/fields.hpp",
                     "curl h = (dh2/dx1 - dh1/dx2, dh0/dx2 - dh2/dx0, dh1/dx0 - dh0/dx1)",
                     {"curl0", "curl1", "curl2"}, {}, field_rows(), product, curl);
}

}  // namespace oddity::truth
