#include "chapters/kicked_state.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "solvers/linear.hpp"
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

using Seen = std::function<Eigen::VectorXd(const Eigen::VectorXd& state)>;
using Rhs = std::function<void(const double* x, double* dxdt, double t)>;

/// Derivatives of the observables, constraints and rates with respect to the state.
Eigen::MatrixXd change_of_seen(const Seen& seen, const Eigen::VectorXd& x) {
  constexpr double part = 1e-4;
  Eigen::MatrixXd change(seen(x).size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double h = part * std::max(1.0, std::abs(x[i]));
    Eigen::VectorXd up = x, down = x;
    up[i] += h;
    down[i] -= h;
    change.col(i) = (seen(up) - seen(down)) / (up[i] - down[i]);
  }
  return change;
}

constexpr double negligible = 1e-6;  // singular value, relative to the largest

/// Whether every change of the state is seen, or never will be. A change that is not seen now is never seen
/// if the change of its rates is not seen either.
bool is_determined(const Seen& seen, const Rhs& rhs, const Eigen::VectorXd& x, double t) {
  constexpr double rounding = 1e-5;  // relative error of derivatives by differences
  const Eigen::Index size = x.size();
  const Eigen::MatrixXd change = change_of_seen(seen, x);
  if (rank(change, negligible) == size) return true;
  std::vector<double> jacobian =
      ode::jacobian_at(rhs, std::span(x.data(), static_cast<std::size_t>(size)), t);  // row by row
  const Eigen::MatrixXd of_rates =
      change * Eigen::Map<Eigen::MatrixXd>(jacobian.data(), size, size).transpose();
  const Eigen::MatrixXd unseen =
      Eigen::MatrixXd::Identity(size, size) - pseudo_inverse(change, negligible) * change;
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
Eigen::VectorXd approached(const Seen& seen, Eigen::VectorXd x, const Eigen::VectorXd& wanted, double close) {
  Eigen::VectorXd nearest = x;
  double least = std::numeric_limits<double>::infinity();
  for (int tries = 0; tries < 20; ++tries) {
    const Eigen::VectorXd off = wanted - seen(x);
    const double most = off.cwiseAbs().maxCoeff();
    if (!off.allFinite() || (least <= close && !(most < least))) break;
    if (most < least) nearest = x, least = most;
    if (most == 0) break;
    x += pseudo_inverse(change_of_seen(seen, x), negligible) * off;
  }
  return nearest;
}

struct Found {
  Eigen::VectorXd state;
  std::string_view why_none = {};
};

Found kicked(const Seen& seen, const Rhs& rhs, const Eigen::VectorXd& before, double t,
             std::span<const Kick> at_once) {
  const Eigen::VectorXd wanted = wanted_after(seen(before), at_once);
  if (!wanted.allFinite()) return {before, not_seen_so};
  if (!is_determined(seen, rhs, before, t)) return {before, is_undetermined};
  const double close = 1e-10 * (1 + wanted.cwiseAbs().maxCoeff());
  Found after{approached(seen, before, wanted, close)};
  const Eigen::VectorXd off = wanted - seen(after.state);
  if (!(off.cwiseAbs().maxCoeff() <= close)) after.why_none = not_seen_so;
  return after;
}

}  // namespace

template <std::size_t n>
KickedState<n> kicked(const ModelInterfaceOf<n>& model, const std::array<double, n>& before, double t,
                      std::span<const Kick> at_once) {
  const auto state_of = [](const double* x) {
    std::array<double, n> state{};
    std::copy_n(x, n, state.begin());
    return state;
  };
  const Seen seen = [&](const Eigen::VectorXd& x) { return seen_of(model, state_of(x.data()), t); };
  const Rhs rhs = [&](const double* x, double* dxdt, double time) {
    std::array<double, n> rate{};
    model(state_of(x), rate, time);
    std::ranges::copy(rate, dxdt);
  };
  const Eigen::Map<const Eigen::VectorXd> numbers(before.data(), static_cast<Eigen::Index>(n));
  const Found after = kicked(seen, rhs, numbers, t, at_once);
  return {state_of(after.state.data()), after.why_none};
}

#define ODDITY_KICKED(n, name)                                                                      \
  template KickedState<n> name<n>(const ModelInterfaceOf<n>&, const std::array<double, n>&, double, \
                                  std::span<const Kick>);
ODDITY_FOR_UNKNOWNS(ODDITY_KICKED, kicked)

}  // namespace oddity
