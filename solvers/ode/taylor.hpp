#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "solvers/ode/any_system.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/taylor/motion.hpp"

namespace oddity::ode {

namespace detail {

/// A motion by its own series, or by the series that the system keeps.
template <class State>
class TaylorSteps {
 public:
  template <class System>
  TaylorSteps(const System& system, long& evaluations, double tolerance) : evaluations_(evaluations) {
    if constexpr (std::is_base_of_v<AnySystem<std::tuple_size_v<State>>, System>)
      motion_ = system.kept_motion();
    if (!motion_) motion_ = &own_.emplace(taylor::Program(record(system)), tolerance);
    before_ = motion_->evaluations();
  }
  TaylorSteps(const TaylorSteps&) = delete;

  const char* operator()(State& x, double& t, double t1) {
    const char* trouble = motion_->advance(x, t, t1);
    evaluations_ = motion_->evaluations() - before_;
    return trouble;
  }

 private:
  template <class System>
  static taylor::Recording record(const System& system) {
    if constexpr (requires { system.recording(); })
      return system.recording();
    else if constexpr (Analytic<System, State>)
      return taylor::record<std::tuple_size_v<State>>(system);
    else
      throw std::logic_error("the system is not generic in its number type, or not analytic");
  }

  std::optional<taylor::Motion> own_;
  taylor::Motion* motion_ = nullptr;
  long before_ = 0;
  long& evaluations_;
};

template <std::size_t n>
class WithSeries final : public AnySystem<n> {
 public:
  using typename AnySystem<n>::State, typename AnySystem<n>::Half, typename AnySystem<n>::Next;

  WithSeries(const AnySystem<n>& system, double tolerance)
      : system_(system), motion_(taylor::Program(system.recording()), tolerance) {}

  void operator()(const State& x, State& dxdt, double t) const override { system_(x, dxdt, t); }
  void acceleration(const Half& q, Half& a) const override { system_.acceleration(q, a); }
  bool differentiable() const override { return system_.differentiable(); }
  long jacobian(const State& x, double* matrix, double* dfdt, double t) const override {
    return system_.jacobian(x, matrix, dfdt, t);
  }
  std::size_t guard_count() const override { return system_.guard_count(); }
  void guards(const State& x, double t, double* values) const override { system_.guards(x, t, values); }
  Next happen(std::size_t i, State& x, double t) const override { return system_.happen(i, x, t); }
  taylor::Motion* kept_motion() const override { return &motion_; }

 private:
  const AnySystem<n>& system_;
  mutable taylor::Motion motion_;
};

}  // namespace detail

/// Taylor series of the motion, with order and step chosen by the tolerance. Records the right-hand side once
/// per integration. Evaluations are the operations made, over those of the right-hand side. An addition or
/// multiplication counts as 1, a division or root as 4, a sine or an exponential as 8.
struct Taylor {
  static constexpr std::string_view name = "Taylor series";
  static constexpr Kind kind = Kind::self_stepping;
  static constexpr Facts facts{.library = Facts::own, .in_page = false};
  static constexpr double first_step = 1;  ///< not used: the series itself gives its step
  /// A system that keeps its series, which then gives the states inside a step.
  template <std::size_t n>
  using WithSeries = detail::WithSeries<n>;
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations, double tolerance, double) {
    return detail::TaylorSteps<State>(system, evaluations, tolerance);
  }
};

}  // namespace oddity::ode
