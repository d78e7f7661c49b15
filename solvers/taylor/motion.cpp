#include "solvers/taylor/motion.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace oddity::taylor {

namespace {

/// Cost of a point on the series, in even and odd powers.
long cost_of_point(const Program& program, int order) {
  return static_cast<long>(program.unknowns()) * (2 * order + 2) + 1;
}
/// Cost of the coefficients, and of the reach from the last four.
long cost_of_expansion(const Program& program, int order) {
  return program.cost(order) + 5 * Weights::function + 5 * Weights::division +
         static_cast<long>(program.unknowns()) *
             (3 * Weights::addition + 6 * Weights::multiplication + Weights::division);
}

constexpr int digits = 52, bias = 1023;

/// log2 of a normal number within 1e-5; exact if it is an integer.
double binary_logarithm(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto fraction = bits & ((std::uint64_t(1) << digits) - 1);
  const double f = std::bit_cast<double>(fraction | std::uint64_t(bias) << digits) - 1,
               z = f * f;  // 0 <= f < 1
  const double even = 1.4426814680651574 + z * (0.468658879143979 + z * 0.14447109569932254);
  const double odd = -0.7203587726758489 - z * (0.30163800973561455 + z * 0.033822045969140305);
  return static_cast<double>(static_cast<int>(bits >> digits) - bias) + f * (even + f * odd);
}
/// 2^x within 4e-6, if the result is a normal number.
double power_of_two(double x) {
  constexpr double shift = 0x3p51;  // beyond it, all doubles are integers
  const double n = (x + shift) - shift, f = x - n, z = f * f;
  const auto scale = static_cast<std::uint64_t>(static_cast<int>(n) + bias) << digits;
  const double even = 1 + z * (0.24022349038020308 + z * 0.00966636851538722);
  const double odd = 0.69312104520342711 + z * 0.05592197584225615;
  return std::bit_cast<double>(scale) * (even + f * odd);
}

/// The tolerance, limited to values that suit a series and have a logarithm.
double within_reason(double tolerance) { return std::clamp(tolerance, 1e-300, 0.1); }

double share_of_radius(double tolerance, int order) {
  return std::pow(within_reason(tolerance), 1.0 / order);
}

}  // namespace

int best_order(const Program& program, double tolerance) {
  constexpr int least = 4;
  const double digits_asked = -binary_logarithm(within_reason(tolerance));
  const auto price = [&](int order) {
    const long work = cost_of_expansion(program, order) + cost_of_point(program, order);
    return static_cast<double>(work + program.overhead(order)) * power_of_two(digits_asked / order);
  };
  int best = least;
  double lowest = price(least);
  for (int order = least + 1; order <= most_orders; ++order)
    if (const double now = price(order); now < lowest) best = order, lowest = now;
  return best;
}

Motion::Motion(Program program, double tolerance)
    : series_(std::move(program)),
      order_(best_order(series_.program(), tolerance)),
      share_(share_of_radius(tolerance, order_)),
      last_(series_.program().unknowns()),
      compared_(last_),
      scale_(last_),
      of_expansion_(cost_of_expansion(series_.program(), order_)),
      of_point_(cost_of_point(series_.program(), order_)) {}

long Motion::evaluations() const {
  const long unit = series_.program().cost_by_hand();
  return (operations_ + unit - 1) / unit;
}

void Motion::see(double t, std::span<double> x) {
  operations_ += of_point_;
  series_.at(t - series_.time(), x.data());
}

bool Motion::covers(std::span<const double> x, double t) {
  if (!(std::abs(t - series_.time()) <= reach_)) return false;
  if (t == last_time_ && std::ranges::equal(x, last_)) return true;
  see(t, compared_);
  return std::ranges::equal(x, compared_);
}

/// Uses the steepest of the last four coefficients, as one or two may vanish by accident, or all of one
/// parity by symmetry. If all four are zero, uses earlier ones.
double Motion::reach() const {
  constexpr int last = 4;
  constexpr double none = -std::numeric_limits<double>::infinity();
  double steepest = none;
  for (int k = order_; k > 2 && (k > order_ - last || steepest == none); --k)
    if (const double size = series_.largest(k, scale_.data()); size > 0)
      steepest = std::max(steepest, binary_logarithm(size) / k);
  return share_ * (steepest == none ? -none : power_of_two(-steepest));  // infinite for a polynomial
}

bool Motion::expand(std::span<const double> x, double t) {
  operations_ += of_expansion_;
  series_.expand(x.data(), t, order_);
  for (std::size_t i = 0; i < x.size(); ++i) scale_[i] = 1 / (1 + std::abs(x[i]));
  const bool is_finite = series_.is_finite();
  reach_ = is_finite ? reach() : -1;
  last_time_ = t;
  std::ranges::copy(x, last_.begin());
  return is_finite;
}

const char* Motion::advance(std::span<double> x, double& t, double t1) {
  const double direction = t1 > t ? 1 : -1;
  const auto end = [&] { return series_.time() + direction * reach_; };
  const auto is_beyond = [&](double time) { return (time - t) * direction > 0; };
  if (!covers(x, t) || !is_beyond(end()))
    if (!expand(x, t)) return "the series is not finite";
  if (!is_beyond(end())) return "the step became too small";
  t = (t1 - end()) * direction > 0 ? end() : t1;
  see(t, x);
  last_time_ = t;
  std::ranges::copy(x, last_.begin());
  return nullptr;
}

}  // namespace oddity::taylor
