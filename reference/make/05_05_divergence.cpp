#include "reference/make/fields.hpp"

// M f is differentiated as one field.
namespace oddity::truth {

Truth truth_05_05_divergence() {
  const auto product = [](const auto& waves, const std::vector<double>& in) {
    return [waves, in](const auto& x) {
      const auto f = waves.f(x);
      auto h = f;
      for (std::size_t i = 0; i < 3; ++i)
        h[i] = Number(in[4 + 3 * i]) * f[0] + Number(in[5 + 3 * i]) * f[1] + Number(in[6 + 3 * i]) * f[2];
      return h;
    };
  };
  const auto divergence = [](const Slopes& d, const auto&, const auto&) {
    return Numbers{d[0][0] + d[1][1] + d[2][2]};
  };
  std::vector<std::vector<double>> rows;
  for (std::vector<double> row : field_rows()) {
    row.insert(row.end(), {2, -1, 0.5, 0.25, 3, -2, 1.5, 0.75, -1});
    rows.push_back(row);
  }
  return field_truth("divergence of h = M f, f being the field in reference/make/fields.hpp",
                     "div h = dh0/dx0 + dh1/dx1 + dh2/dx2", {"div"},
                     {"m00", "m01", "m02", "m10", "m11", "m12", "m20", "m21", "m22"}, rows, product,
                     divergence);
}

}  // namespace oddity::truth
