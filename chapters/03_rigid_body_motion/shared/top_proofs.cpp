#include "chapters/03_rigid_body_motion/shared/top_proofs.hpp"

namespace oddity::top {

namespace {

std::string by_field(const std::vector<std::string>& angles) {
  std::string known;
  for (const std::string& angle : angles) known += " (circle (" + angle + "))";
  return "field [" + known.substr(1) + "]; positive";
}

}  // namespace

std::string by_points(const std::vector<std::string>& angles) { return "by_points H; " + by_field(angles); }

namespace {

/// Sums up the assumptions, then proves the goal as a linear combination of them.
std::array<std::string, 2> steps(const std::vector<std::string>& angles,
                                 const std::vector<std::string>& factors, std::size_t first) {
  std::string summed, matched, ends, sum, used;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string number = std::to_string(i), name = "H" + std::to_string(first + i - 1);
    summed += "sum_up_in " + name + " H; ";
    matched += "match type of " + name + " with ?e" + number + " = 0 => ";
    ends += " end";
    sum += (i == 0 ? "(" : " + (") + factors[i] + ") * e" + number;
    used += (i == 0 ? "" : ", ") + name;
  }
  return {summed, "apply Rminus_diag_uniq;\n    " + matched + "transitivity (" + sum + ");\n    [" +
                      by_field(angles) + " | rewrite " + used + "; ring]" + ends};
}

}  // namespace

std::string by_equations(const std::vector<std::string>& angles, const std::vector<std::string>& factors,
                         std::size_t first) {
  const auto [summed, shown] = steps(angles, factors, first);
  return "by_points H; " + summed + shown;
}

std::string by_equations_if_need_be(const std::vector<std::string>& angles,
                                    const std::vector<std::string>& factors, std::size_t first) {
  const auto [summed, shown] = steps(angles, factors, first);
  return "by_points H; " + summed + "\n  first [solve [" + by_field(angles) + "] | " + shown + "]";
}

}  // namespace oddity::top
