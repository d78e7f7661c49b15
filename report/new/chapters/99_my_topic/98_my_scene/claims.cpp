// The claims of exercise 99.98.

#include "chapters/claims.hpp"

#include "chapters/to_write.hpp"
#include "reference/reference.hpp"

namespace oddity {

namespace ex99_98 {

std::vector<Claim> claims(const Parameters& p, const Reference& truth) {
  const double w = std::sqrt(p["c"] / p["m"]);
  const auto back_after = [&](const std::string& text, double T) {
    const Route made = to_write().from(truth, T);
    return Reading{text, {{"$x(T)$", made, {"$x(0)$", p["x0"]}, rounding(p["x0"])}}};
  };
  return Claims("99.98")
      .add("period", 1, "the mass is back after one period",
           {.printed = back_after(R"($T=2\pi\sqrt{m/c}$)", 2 * std::numbers::pi / w),
            .near_misses = {back_after(R"($T=\pi\sqrt{m/c}$)", std::numbers::pi / w)}})
      .in_order();
}

}  // namespace ex99_98

}  // namespace oddity
