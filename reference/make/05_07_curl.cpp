#include "reference/make/fields.hpp"

// The product phi f is differentiated as one field; no product rule is used.
namespace oddity::truth {

namespace {

constexpr auto product = [](const auto& waves) {
  return [waves](const auto& x) {
    auto v = waves.f(x);
    const auto phi = waves.phi(x);
    for (auto& component : v) component *= phi;
    return v;
  };
};

Numbers curl_of(const Triple<Triple<Number>>& d) {
  return {d[1][2] - d[2][1], d[2][0] - d[0][2], d[0][1] - d[1][0]};
}

Numbers by_differences(const std::vector<double>& in, int) {
  return curl_of(slopes_by_differences(product, in));
}
Numbers by_cauchy(const std::vector<double>& in, int) { return curl_of(slopes_by_cauchy(product, in)); }

}  // namespace

Truth truth_05_07_curl() {
  return {"curl of the product phi f of the two fields of reference/make/fields.hpp",
          "curl h = (dh2/dx1 - dh1/dx2, dh0/dx2 - dh2/dx0, dh1/dx0 - dh0/dx1), h = phi f",
          {"w", "x0", "x1", "x2"},
          {{"curl0", "1"}, {"curl1", "1"}, {"curl2", "1"}},
          field_rows(),
          differences_route,
          by_differences,
          cauchy_route,
          by_cauchy};
}

}  // namespace oddity::truth
