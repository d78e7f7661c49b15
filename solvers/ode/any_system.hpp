#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <stdexcept>

#include "solvers/ode/jacobian.hpp"
#include "solvers/ode/velocities.hpp"
#include "solvers/taylor/tape.hpp"

namespace oddity::taylor {
class Motion;
}

namespace oddity::ode {

/// A system of n unknowns behind virtual calls, for which an algorithm is compiled once and for all. `oddity
/// bench` measures the cost. T is float or double.
template <std::size_t n, class T = double>
class AnySystem {
 public:
  using State = std::array<T, n>;
  using Half = std::array<T, n / 2>;

  virtual ~AnySystem() = default;
  virtual void operator()(const State& x, State& dxdt, T t) const = 0;
  /// Throws std::logic_error for a system that is not partitioned.
  virtual void acceleration(const Half& q, Half& a) const = 0;
  /// Which unknowns are velocities; unknown by default.
  virtual Velocities<n> velocities() const { return {}; }
  virtual bool differentiable() const = 0;
  /// See ode::jacobian. Throws std::logic_error for a system that is not differentiable, or not in double.
  virtual long jacobian(const State& x, double* matrix, double* dfdt, double t) const = 0;
  /// Whether the system can be recorded for Taylor series.
  virtual bool analytic() const { return false; }
  /// Throws std::logic_error for a system that is not analytic, or not in double.
  virtual taylor::Recording recording() const {
    throw std::logic_error("the system is not generic in its number type, or not analytic");
  }
  /// The Taylor series kept by a search for events; null: no search is under way.
  virtual taylor::Motion* kept_motion() const { return nullptr; }

  // Events (events.hpp); optional.
  virtual std::size_t guard_count() const { return 0; }
  virtual void guards(const State&, double, double*) const {}
  /// Changes x by the event of guard i.
  enum class Next { go_on, end, pass };
  virtual Next happen(std::size_t, State&, double) const { return Next::pass; }
};

/// Has events: guards(x, t) -> array of numbers, and at_event(i, x, t) -> {after, ends, passes}.
template <class System, class State>
concept Eventful = requires(const System& system, const State& x) {
  system.guards(x, typename State::value_type{});
  system.at_event(std::size_t{}, x, typename State::value_type{}).after;
};

/// (q, v) with q' = v, and forces that depend on q alone.
template <class System, class State>
concept Partitioned = (std::tuple_size_v<State> % 2 == 0) &&
                      requires(const System& system,
                               std::array<typename State::value_type, std::tuple_size_v<State> / 2>& half) {
  system.acceleration(half, half);
};

/// Has a right-hand side that is generic in its number type and analytic, and so can be recorded.
#ifdef __wasm__  // The WebAssembly module omits Taylor series, for its size.
template <class System, class State>
concept Analytic = false;
#else
template <class System, class State>
concept Analytic = std::same_as<typename State::value_type, double> &&
    requires(const System& system, const std::array<taylor::Recorded, std::tuple_size_v<State>>& x,
             std::array<taylor::Recorded, std::tuple_size_v<State>>& dxdt, const taylor::Recorded& t) {
  system(x, dxdt, t);
} && !requires {
  System::not_analytic;
};
#endif

/// Wraps a system as a `Base`, which is an AnySystem; `Kept` is the system's type or a reference to it.
template <class Base, class Kept>
class Adapted : public Base {
 public:
  using typename Base::Half, typename Base::Next, typename Base::State;
  using System = std::remove_cvref_t<Kept>;
  using T = typename State::value_type;

  explicit Adapted(const System& system) : system_(system) {}
  const System& system() const { return system_; }

  void operator()(const State& x, State& dxdt, T t) const final { system_(x, dxdt, t); }
  void acceleration(const Half& q, Half& a) const final {
    if constexpr (Partitioned<System, State>)
      system_.acceleration(q, a);
    else
      throw std::logic_error("the system has no forces of positions alone");
  }
  Velocities<std::tuple_size_v<State>> velocities() const final { return velocities_of<State>(system_); }
  bool differentiable() const final { return is_differentiable; }
  long jacobian(const State& x, double* matrix, double* dfdt, double t) const final {
    if constexpr (is_differentiable)
      return ode::jacobian(system_, x, matrix, dfdt, t);
    else
      throw std::logic_error("the system is not generic in its number type");
  }
  bool analytic() const final { return Analytic<System, State>; }
  taylor::Recording recording() const final {
    if constexpr (Analytic<System, State>)
      return taylor::record<std::tuple_size_v<State>>(system_);
    else
      return Base::recording();
  }
  std::size_t guard_count() const final {
    if constexpr (Eventful<System, State>)
      return std::tuple_size_v<decltype(system_.guards(State(), T{}))>;
    else
      return 0;
  }
  void guards([[maybe_unused]] const State& x, [[maybe_unused]] double t,
              [[maybe_unused]] double* values) const final {
    if constexpr (Eventful<System, State>) {
      const auto now = system_.guards(x, static_cast<T>(t));
      std::copy(now.begin(), now.end(), values);
    }
  }
  Next happen([[maybe_unused]] std::size_t i, [[maybe_unused]] State& x,
              [[maybe_unused]] double t) const final {
    if constexpr (Eventful<System, State>) {
      const auto happening = system_.at_event(i, x, static_cast<T>(t));
      x = happening.after;
      return happening.ends ? Next::end : happening.passes ? Next::pass : Next::go_on;
    } else {
      return Next::pass;
    }
  }

 private:
  static constexpr bool is_differentiable = std::same_as<T, double> && Differentiable<System, State>;

  Kept system_;
};

}  // namespace oddity::ode
