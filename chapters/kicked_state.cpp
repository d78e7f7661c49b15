#include "chapters/kicked_state.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solvers/ode/stability.hpp"

namespace oddity {

namespace {

/// The observables and the constraints, and then the rates of all of them.
template <std::size_t n>
Eigen::VectorXd seen_of(const ModelInterfaceOf<n>& model, const std::array<double, n>& x, double t) {
  std::array<double, n> rate{};
  model(x, rate, t);
  const auto at = [&](double h) {
    std::array<double, n> moved = x;
    for (std::size_t i = 0; i < n; ++i) moved[i] += h * rate[i];
    std::vector<double> observed = model.constraints_at(moved, t + h);
    const auto held = static_cast<std::ptrdiff_t>(observed.size());
    model.observe(moved, t + h, observed);
    std::ranges::rotate(observed, observed.begin() + held);
    return observed;
  };
  std::vector<double> seen;
  add_placed(at(0), rates(at, step_of_rates), seen);
  return Eigen::Map<Eigen::VectorXd>(seen.data(), static_cast<Eigen::Index>(seen.size()));
}

/// How these change with the state.
template <std::size_t n>
Eigen::MatrixXd change_of_seen(const ModelInterfaceOf<n>& model, const std::array<double, n>& x, double t) {
  constexpr double part = 1e-4;
  Eigen::MatrixXd change(seen_of(model, x, t).size(), static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double h = part * std::max(1.0, std::abs(x[i]));
    auto up = x, down = x;
    up[i] += h;
    down[i] -= h;
    change.col(static_cast<Eigen::Index>(i)) =
        (seen_of(model, up, t) - seen_of(model, down, t)) / (up[i] - down[i]);
  }
  return change;
}

auto decomposed(const Eigen::MatrixXd& change) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-6);
  decomposition.compute(change);
  return decomposition;
}

/// Whether every change of the state is seen, or never will be. A change that is not seen now is never seen
/// if the change of its rates is not seen either.
template <std::size_t n>
bool is_determined(const ModelInterfaceOf<n>& model, const std::array<double, n>& x, double t) {
  constexpr double rounding = 1e-5;  // relative error of derivatives by differences
  constexpr auto size = static_cast<Eigen::Index>(n);
  const Eigen::MatrixXd change = change_of_seen(model, x, t);
  const auto decomposition = decomposed(change);
  if (decomposition.rank() == size) return true;
  const auto rhs = [&](const double* at, double* dxdt, double time) {
    std::array<double, n> state{}, rate{};
    std::copy_n(at, n, state.begin());
    model(state, rate, time);
    std::ranges::copy(rate, dxdt);
  };
  const std::vector<double> jacobian = ode::jacobian_at(rhs, x, t);
  const Eigen::MatrixXd of_rates =
      change * Eigen::Map<const Eigen::Matrix<double, size, size, Eigen::RowMajor>>(jacobian.data());
  const Eigen::MatrixXd unseen =
      Eigen::MatrixXd::Identity(size, size) - decomposition.pseudoInverse() * change;
  return (of_rates * unseen).cwiseAbs().maxCoeff() <= rounding * of_rates.cwiseAbs().maxCoeff();
}

/// As they are to be after the kicks.
Eigen::VectorXd wanted_after(Eigen::VectorXd seen, std::span<const Kick> at_once) {
  const std::size_t parts = static_cast<std::size_t>(seen.size()) / 2;
  for (const Kick& kick : at_once) {
    double& of = seen[static_cast<Eigen::Index>(kick.observable + (kick.of_rate ? parts : 0))];
    of = kick.change == Kick::Change::adds     ? of + kick.value
         : kick.change == Kick::Change::scales ? of * kick.value
                                               : kick.value;
  }
  return seen;
}

/// The nearest state that Newton's method finds, by least changes.
template <std::size_t n>
std::array<double, n> approached(const ModelInterfaceOf<n>& model, std::array<double, n> x, double t,
                                 const Eigen::VectorXd& wanted, double close) {
  std::array<double, n> nearest = x;
  double least = std::numeric_limits<double>::infinity();
  for (int tries = 0; tries < 20; ++tries) {
    const Eigen::VectorXd off = wanted - seen_of(model, x, t);
    const double most = off.cwiseAbs().maxCoeff();
    if (!off.allFinite() || (least <= close && !(most < least))) break;
    if (most < least) nearest = x, least = most;
    if (most == 0) break;
    const Eigen::VectorXd by = decomposed(change_of_seen(model, x, t)).solve(off);
    for (std::size_t i = 0; i < n; ++i) x[i] += by[static_cast<Eigen::Index>(i)];
  }
  return nearest;
}

}  // namespace

template <std::size_t n>
KickedState<n> kicked(const ModelInterfaceOf<n>& model, const std::array<double, n>& before, double t,
                      std::span<const Kick> at_once) {
  const Eigen::VectorXd wanted = wanted_after(seen_of(model, before, t), at_once);
  if (!wanted.allFinite()) return {before, not_seen_so};
  if (!is_determined(model, before, t)) return {before, is_undetermined};
  const double close = 1e-10 * (1 + wanted.cwiseAbs().maxCoeff());
  KickedState<n> after{approached(model, before, t, wanted, close)};
  const Eigen::VectorXd off = wanted - seen_of(model, after.state, t);
  if (!(off.cwiseAbs().maxCoeff() <= close)) after.why_none = not_seen_so;
  return after;
}

#define ODDITY_KICKED(n, name)                                                                      \
  template KickedState<n> name<n>(const ModelInterfaceOf<n>&, const std::array<double, n>&, double, \
                                  std::span<const Kick>);
ODDITY_FOR_UNKNOWNS(ODDITY_KICKED, kicked)

}  // namespace oddity
