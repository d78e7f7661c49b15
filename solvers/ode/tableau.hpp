#pragma once

#include <array>
#include <boost/numeric/odeint/algebra/algebra_dispatcher.hpp>
#include <boost/numeric/odeint/algebra/operations_dispatcher.hpp>
#include <boost/numeric/odeint/stepper/base/explicit_error_stepper_base.hpp>
#include <boost/numeric/odeint/util/resizer.hpp>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

#include "solvers/ode/controlled.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

/// Embedded explicit Runge-Kutta methods, made of their tableaus for Odeint's step control.
namespace oddity::ode::detail {

/// The weights of a stage, of the step's end or of an error estimate; zeros at the end may be left out.
template <std::size_t stages>
using Weights = std::array<double, stages>;

template <std::size_t stages>
constexpr Weights<stages> difference(const Weights<stages>& a, const Weights<stages>& b) {
  Weights<stages> c{};
  for (std::size_t j = 0; j < stages; ++j) c[j] = a[j] - b[j];
  return c;
}

// Each kind of weights as a type, as a template needs it.
template <class Tableau, std::size_t stage>
struct OfStage {
  static constexpr auto weights = Tableau::a[stage];
};
template <class Tableau>
struct OfEnd {
  static constexpr auto weights = Tableau::b;
};
template <class Tableau, std::size_t nth>
struct OfEstimate {
  static constexpr auto weights = Tableau::estimates[nth];
};

/// Indices of the weights that are not zero.
template <class Of>
constexpr auto used = [] {
  constexpr std::size_t count = [] {
    std::size_t n = 0;
    for (double weight : Of::weights) n += weight != 0;
    return n;
  }();
  std::array<std::size_t, count> indices{};
  for (std::size_t j = 0, n = 0; j < Of::weights.size(); ++j)
    if (Of::weights[j] != 0) indices[n++] = j;
  return indices;
}();

/// The sum of the weights times the rates of unknown i, without the weights that are zero.
template <class Of, class Rates>
auto weighted(const Rates& rates, std::size_t i) {
  return [&]<std::size_t... n>(std::index_sequence<n...>) {
    return (... + (Of::weights[used<Of>[n]] * rates[used<Of>[n]][i]));
  }
  (std::make_index_sequence<used<Of>.size()>());
}

/// An error stepper of Odeint. A tableau has its order and the times c of its stages. It has the weights a of
/// the stages, b of the end, and those of one or two estimates of the error per unit of time. Of two,
/// part(first, second) is the part of the first that counts as the error, from sums of squares over all
/// unknowns.
template <class Tableau, class State>
class EmbeddedRungeKutta
    : public boost::numeric::odeint::explicit_error_stepper_base<
          EmbeddedRungeKutta<Tableau, State>, Tableau::order, Tableau::order, Tableau::order - 1, State,
          double, State, double, typename boost::numeric::odeint::algebra_dispatcher<State>::algebra_type,
          typename boost::numeric::odeint::operations_dispatcher<State>::operations_type,
          boost::numeric::odeint::initially_resizer> {
 public:
  /// A step without an error estimate; leaves out stages that only the estimate needs.
  template <class System>
  void do_step_impl(const System& system, const State& x, const State& first, double t, State& end,
                    double h) {
    constexpr std::size_t needed = used<OfEnd<Tableau>>.back() + 1;
    end_of_step(x, rates<needed>(system, x, first, t, h), h, end);
  }

  template <class System>
  void do_step_impl(const System& system, const State& x, const State& first, double t, State& end, double h,
                    State& error) {
    const Rates k = rates<stages>(system, x, first, t, h);
    for (std::size_t i = 0; i < error.size(); ++i) error[i] = h * weighted<OfEstimate<Tableau, 0>>(k, i);
    if constexpr (std::size(Tableau::estimates) == 2) {
      const double part = part_of_error(x, k, h);
      for (std::size_t i = 0; i < error.size(); ++i) error[i] *= part;
    }
    end_of_step(x, k, h, end);
  }

 private:
  static constexpr std::size_t stages = std::size(Tableau::a);
  using Rates = std::array<State, stages>;

  /// The rates of the first stages; the others' are zero.
  template <std::size_t count, class System>
  static Rates rates(const System& system, const State& x, const State& first, double t, double h) {
    Rates k{first};
    [&]<std::size_t... before>(std::index_sequence<before...>) {
      (evaluate<before + 1>(system, x, t, h, k), ...);
    }
    (std::make_index_sequence<count - 1>());
    return k;
  }

  template <std::size_t stage, class System>
  static void evaluate(const System& system, const State& x, double t, double h, Rates& k) {
    State y{};
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = x[i] + h * weighted<OfStage<Tableau, stage>>(k, i);
    system(y, k[stage], t + Tableau::c[stage] * h);
  }

  /// Unknowns have the scale that Odeint's step control gives them where both tolerances are equal.
  static double part_of_error(const State& x, const Rates& k, double h) {
    double first = 0, second = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double scale = 1 + std::abs(x[i]) + std::abs(h * k[0][i]),
                   one = weighted<OfEstimate<Tableau, 0>>(k, i) / scale,
                   other = weighted<OfEstimate<Tableau, 1>>(k, i) / scale;
      first += one * one;
      second += other * other;
    }
    return Tableau::part(first, second);
  }

  static void end_of_step(const State& x, const Rates& k, double h, State& end) {
    for (std::size_t i = 0; i < x.size(); ++i) end[i] = x[i] + h * weighted<OfEnd<Tableau>>(k, i);
  }
};

/// An algorithm by a tableau, under Odeint's step control.
template <class Of>
struct ByTableau {
  using Tableau = Of;
  static constexpr Kind kind = Kind::controlled;
  static constexpr int order = Of::order;
  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  /// The method without its step control.
  template <class State>
  using Plain = EmbeddedRungeKutta<Of, State>;
  template <class State>
  static auto stepper(double tolerance) {
    return controlled<Plain<State>>(tolerance);
  }
};

}  // namespace oddity::ode::detail
