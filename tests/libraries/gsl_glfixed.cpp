#include <gsl/gsl_integration.h>
#include <gsl/gsl_version.h>

#include <algorithm>
#include <cmath>

#include "report/verify/catch.hpp"
#include "tests/libraries/shown.hpp"

namespace {

/// Errors of the weights for this many points: that of their sum, 2, and that of the nodes as roots of
/// Legendre's polynomial.
struct Miss {
  bool tabulated;
  double weights, nodes;
};

Miss miss(std::size_t n) {
  gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(n);
  long double sum = 0, most = 0;
  for (std::size_t i = 0; i < (n + 1) / 2; ++i) {
    const long double x = table->x[i];
    sum += (n % 2 == 1 && i == 0 ? 1 : 2) * static_cast<long double>(table->w[i]);
    long double before = 1, p = x;
    for (std::size_t k = 2; k <= n; ++k) {
      const auto m = static_cast<long double>(k);
      const long double next = ((2 * m - 1) * x * p - (m - 1) * before) / m;
      before = p, p = next;
    }
    const long double slope = static_cast<long double>(n) * (before - x * p) / (1 - x * x);
    most = std::max(most, std::abs(p / slope));
  }
  const Miss found{table->precomputed != 0, static_cast<double>(std::abs(sum - 2)),
                   static_cast<double>(most)};
  gsl_integration_glfixed_table_free(table);
  return found;
}

}  // namespace

TEST_CASE("GSL computes weights of Gauss and Legendre to ten digits", "[libraries]") {
  const Shown shown{"gsl_glfixed", gsl_version};
  const Miss fifty = miss(50), tabulated = miss(64);
  shown.check("those of 50 points miss their sum by more than 1e-11, while the nodes have all digits",
              !fifty.tabulated && fifty.weights > 1e-11 && fifty.nodes < 2e-16, fifty.weights);
  shown.check("Those of 64 points, from a table, are right", tabulated.tabulated && tabulated.weights < 1e-15,
              tabulated.weights);
}
