#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode::detail {

double first_step(std::span<const double> times, double part) {
  const auto [low, high] = std::minmax_element(times.begin(), times.end());
  const double step = std::max((*high - *low) * part, 0x1p-50 * std::max(std::abs(*low), std::abs(*high)));
  return step > 0 ? step : 1;  // no step is made if all times are 0
}

const char* invalid_arguments(std::span<const double> times, double setting) {
  if (!(setting > 0 && std::isfinite(setting))) return "the step or tolerance must be positive and finite";
  if (times.empty() || !std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); }))
    return "there must be times, and they must be finite";
  return nullptr;
}

}  // namespace oddity::ode::detail
