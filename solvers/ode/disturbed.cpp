#include "solvers/ode/disturbed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double first_distance = 1e-6;  ///< of the two motions, in units of their size

template <std::size_t n>
double distance(const std::array<double, n>& a, const std::array<double, n>& b,
                const std::array<double, n>& unit) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += (a[i] - b[i]) / unit[i] * ((a[i] - b[i]) / unit[i]);
  return std::sqrt(sum);
}

/// The step next to this one that divides the span.
double dividing(double span, double step) { return span / std::ceil(span / step * (1 - 1e-12)); }

/// A part of the disturbance in every component.
template <std::size_t n>
std::array<double, n> disturbed(std::array<double, n> x, const std::array<double, n>& unit) {
  std::array<double, n> d{};
  for (std::size_t i = 0; i < n; ++i) d[i] = unit[i] * std::cos(static_cast<double>(i * i + 1));
  const double part = first_distance / distance(d, {}, unit);
  for (std::size_t i = 0; i < n; ++i) x[i] += part * d[i];
  return x;
}

}  // namespace

template <std::size_t n>
Disturbed<n>::Disturbed(const AnySystem<n>& system, const State& start, double span, const Criteria& criteria)
    : system_(system), criteria_(criteria), start_(start) {
  constexpr std::size_t pieces = 1000;
  constexpr double tolerance = 1e-10;
  for (std::size_t i = 0; i <= pieces; ++i) times_.push_back(span * static_cast<double>(i) / pieces);
  long steps = 0;  // a model that chatters about rest would take millions
  const auto enough = [&](double, const State&, double, const State& x) {
    for (std::size_t k = 0; k < n; ++k) sizes_[k] = std::max(sizes_[k], std::abs(x[k]));
    return ++steps > 100'000;
  };
  const auto truth =
      integrate_precompiled<DormandPrince54, n>(system, start, times_, tolerance, Watch<n>(enough));
  const double least = std::ranges::max(sizes_) / 100;
  for (double& size : sizes_) size = std::max(size, least);
  times_.resize(
      std::min(times_.size(), truth.reached() && steps <= 100'000 ? times_.size() : truth.value.size() - 1));
  beside_ = disturbed(start, sizes_);
  const auto next = integrate_precompiled<DormandPrince54, n>(system, beside_, times_, tolerance, {});
  double most = 0;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (i < next.value.size())
      most = std::max(most, std::log(distance(truth.value[i], next.value[i], sizes_) / first_distance));
    parted_.push_back(most);
  }
}

template <std::size_t n>
double Disturbed<n>::lost(std::string_view algorithm, double step) const {
  const double h = dividing(span(), step);
  const std::array ends{0.0, span()};
  std::vector<State> motion;
  double left = infinity;
  const auto keep = [&](double, const State&, double t, const State& x) {
    motion.push_back(x);
    for (std::size_t k = 0; k < n; ++k)
      if (!(std::abs(x[k]) <= criteria_.largest_size * sizes_[k])) left = t;
    return std::isfinite(left);
  };
  precompiled<n>(algorithm)(system_, start_, ends, h, Watch<n>(keep));
  std::size_t i = 0;
  double parted = infinity;
  const auto compare = [&](double, const State&, double t, const State& x) {
    if (i == motion.size()) return true;
    const auto piece = static_cast<std::size_t>(t / span() * static_cast<double>(parted_.size() - 1));
    const double allowed =
        criteria_.as_fast * parted_[std::min(piece + 1, parted_.size() - 1)] + std::log(criteria_.granted);
    if (!(std::log(distance(x, motion[i++], sizes_) / first_distance) <= allowed)) parted = t;
    return std::isfinite(parted);
  };
  precompiled<n>(algorithm)(system_, beside_, ends, h, Watch<n>(compare));
  return std::min(left, parted);
}

template <std::size_t n>
auto Disturbed<n>::motion(std::string_view algorithm, double step, double until) const -> std::vector<State> {
  std::vector<State> motion{start_};
  const auto keep = [&](double, const State&, double t, const State& x) {
    if (t <= until) motion.push_back(x);
    return t >= until;
  };
  precompiled<n>(algorithm)(system_, start_, std::array{0.0, span()}, dividing(span(), step), Watch<n>(keep));
  return motion;
}

#define ODDITY_DISTURBED(n, type) template class type<n>;
ODDITY_FOR_UNKNOWNS(ODDITY_DISTURBED, Disturbed)

}  // namespace oddity::ode
