#include "report/study/perturb_results.hpp"

namespace oddity {

namespace {

/// The index of the component that is perturbed: the largest.
std::size_t largest(const Value& value) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < value.size(); ++i)
    if (std::abs(value[i]) > std::abs(value[at])) at = i;
  return at;
}

bool noticed(Check check, double shift) {
  const std::size_t at = largest(check.left.value);
  check.left.value[at] = check.right.value[at] + shift;
  return !check.holds();
}

}  // namespace

std::vector<std::string> unnoticed_perturbations(const JudgedClaim& judged) {
  std::vector<std::string> unnoticed;
  const auto inspect = [&](const Reading& reading) {
    for (const Check& check : reading.checks) {
      if (!check.holds()) continue;
      const double value = check.right.value[largest(check.left.value)];
      const double scale =
          check.scale > 0 ? check.scale : std::max(size_of(check.left.value), size_of(check.right.value));
      constexpr double rounding = 0x1p-45;  // a zero up to roundings of its terms: its sign cannot change
      const double size = std::abs(value) <= rounding * scale ? scale : std::abs(value);
      const double ten = check.tolerance.allowed > 0 ? 10 * check.tolerance.allowed : scale * 0x1p-50;
      if (!noticed(check, -2 * size))
        unnoticed.push_back(judged.claim.id + ", " + check.quantity + ": the sign");
      if (!noticed(check, size))
        unnoticed.push_back(judged.claim.id + ", " + check.quantity + ": a factor of two");
      if (!noticed(check, ten))
        unnoticed.push_back(judged.claim.id + ", " + check.quantity + ": ten tolerances");
    }
  };
  for (const Reading* reading : {&judged.claim.printed, &judged.claim.meant, &judged.claim.corrected})
    inspect(*reading);
  return unnoticed;
}

}  // namespace oddity
