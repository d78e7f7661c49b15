#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate_inlined.hpp"
#include "solvers/ode/velocities.hpp"

namespace oddity::ode {

/// Order 1: the velocities first, v += h v'(q, v, t), then the positions with the new ones, q += h q'(q, v, t
/// + h). Game engines do so for forces that depend on velocities too. One evaluation per step if the
/// positions' rates are velocities, else two. If the forces depend on positions alone it is symplectic Euler.
/// For q'' = -2 r q' - r^2 q it is stable to h r = 2 (sqrt(2) - 1), for q'' = -r^2 q to h r = 2.
struct SemiImplicitEuler {
  static constexpr std::string_view name = "semi-implicit Euler";
  static constexpr Kind kind = Kind::velocities_first;
  static constexpr int order = 1;
  static constexpr Facts facts{.library = Facts::own,
                               .in_float = true,
                               .evaluations = 1,
                               .real_limit = 0.828427,
                               .imaginary_limit = 2,
                               .theory = "trace of the step's matrix is -1 - its determinant"};
  template <class State, class System>
  class Step {
   public:
    using Number = typename State::value_type;

    Step(const System& system, long& evaluations)
        : system_(&system),
          evaluations_(&evaluations),
          velocities_(velocities_of<State>(system)),
          are_all_rates_(velocities_.are_all_rates()) {}

    void operator()(State& x, Number t, Number h) const {
      State rate;
      evaluate(x, rate, t);
      for (std::size_t i = 0; i < x.size(); ++i)
        if (velocities_.is[i]) x[i] += h * rate[i];
      if (are_all_rates_) {
        for (std::size_t i = 0; i < x.size(); ++i)
          if (!velocities_.is[i]) x[i] += h * x[velocities_.of[i]];
        return;
      }
      evaluate(x, rate, t + h);
      for (std::size_t i = 0; i < x.size(); ++i)
        if (!velocities_.is[i]) x[i] += h * rate[i];
    }

   private:
    void evaluate(const State& x, State& rate, Number t) const {
      ++*evaluations_;
      (*system_)(x, rate, t);
    }

    const System* system_;
    long* evaluations_;
    Velocities<std::tuple_size_v<State>> velocities_;
    bool are_all_rates_;
  };

  template <class State, class System>
  static auto stepper(const System& system, long& evaluations) {
    return Step<State, System>(system, evaluations);
  }
};

}  // namespace oddity::ode
