#pragma once

#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/partitioned.hpp"

namespace oddity::ode {

/// Order 2, one evaluation of the forces per step (and one to start). Symplectic and reversible; stable on
/// the imaginary axis to h |lambda| = 2.
struct VelocityVerlet {
  static constexpr std::string_view name = "velocity Verlet";
  static constexpr Kind kind = Kind::partitioned;
  static constexpr int order = 2;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 1,
                               .imaginary_limit = 2,
                               .theory = Facts::trace};
  /// Odeint's step, with the acceleration kept here: Odeint's own is behind a pointer, five cycles from step
  /// to step.
  template <class State, class System>
  class Step {
   public:
    using Half = typename detail::Halves<State>::Half;
    using Number = typename Half::value_type;

    Step(const System& system, long& evaluations) : system_(&system), evaluations_(&evaluations) {}

    void operator()(State& x, Number t, Number h) {
      const auto force = [this](const Half& q, const Half&, Half& a, Number) {
        ++*evaluations_;
        system_->acceleration(q, a);
      };
      detail::Halves<State> halves(x);
      if (!begun_) force(halves.q, halves.v, acceleration_, t);
      begun_ = true;
      Half next;
      boost::numeric::odeint::velocity_verlet<Half, Half, Number>().do_step(
          force, halves.q, halves.v, acceleration_, halves.q, halves.v, next, t, h);
      acceleration_ = next;
      halves.put(x);
    }

   private:
    const System* system_;
    long* evaluations_;
    Half acceleration_{};
    bool begun_ = false;
  };

  template <class State, class System>
  static auto stepper(const System& system, long& evaluations) {
    return Step<State, System>(system, evaluations);
  }
};

}  // namespace oddity::ode
