#include "solvers/taylor/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace oddity::taylor {

namespace {

/// Of a point on the series, in even powers and odd ones.
long cost_of_point(const Program& program, int order) {
  return static_cast<long>(program.unknowns()) * (2 * order + 2) + 1;
}
/// Of the coefficients, and of the reach from the last four.
long cost_of_expansion(const Program& program, int order) {
  return program.cost(order) + 5 * Weights::function + 5 * Weights::division +
         static_cast<long>(program.unknowns()) *
             (3 * Weights::addition + 6 * Weights::multiplication + Weights::division);
}

double share_of_radius(double tolerance, int order) {
  return std::pow(std::min(tolerance, 0.1), 1.0 / order);
}

/// To 0.01, and so that a power of two has its own.
double binary_logarithm(double x) {
  int exponent = 0;
  const double m = 2 * std::frexp(x, &exponent);  // from 1 to 2
  return exponent - 1 + (m - 1) * (1 + 0.346 * (2 - m));
}

}  // namespace

int best_order(const Program& program, double tolerance) {
  constexpr int least = 4;
  const auto price = [&](int order) {
    const long work = cost_of_expansion(program, order) + cost_of_point(program, order);
    return static_cast<double>(work + program.overhead(order)) / share_of_radius(tolerance, order);
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

/// From the steepest of the last four coefficients, as one or two may vanish by accident, or all of one
/// parity by symmetry; where all four are zero, from those before.
double Motion::reach() const {
  double steepest = -std::numeric_limits<double>::infinity(), size_of_it = 0;
  int its_order = 1;
  for (int k = order_; k > 2; --k) {
    double size = 0;
    for (std::size_t i = 0; i < scale_.size(); ++i)
      size = std::max(size, scale_[i] * std::abs(series_.coefficient(i, k)));
    const double steep = binary_logarithm(size) / k;
    if (size > 0 && steep > steepest) steepest = steep, size_of_it = size, its_order = k;
    if (k <= order_ - 3 && size_of_it > 0) break;
  }
  return share_ * std::pow(size_of_it, -1.0 / its_order);  // infinite, of a polynomial
}

bool Motion::expand(std::span<const double> x, double t) {
  operations_ += of_expansion_;
  series_.expand(x.data(), t, order_);
  double zero = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    scale_[i] = 1 / (1 + std::abs(x[i]));
    zero += (x[i] + series_.coefficient(i, order_)) * 0;
  }
  reach_ = zero == 0 ? reach() : -1;
  last_time_ = t;
  std::ranges::copy(x, last_.begin());
  return zero == 0;
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
