#pragma once

#include <type_traits>
#include <utility>

#include "extras/lanes/integrate.hpp"
#include "report/plain/runge_kutta_4.hpp"
#include "report/plain/symplectic_euler.hpp"
#include "report/plain/velocity_verlet.hpp"

/// A scene's models compiled for an instruction set. All symbols of this header have the set in their names,
/// so that the linker cannot take them for another file's (extras/lanes/lanes_apart.sh).
namespace oddity::lanes {

template <class T>
using Single = Lanes<T, One, 1>;

template <template <class> class Given, class Number, std::size_t i>
using Model = std::tuple_element_t<i, decltype(models(std::declval<Given<Number>>()))>;

template <template <class> class Given>
constexpr std::size_t model_count = std::tuple_size_v<decltype(models(std::declval<Given<double>>()))>;

template <class Model>
concept Integrated = requires {
  typename Model::State;
};
template <class Model>
concept WithForces =
    requires(const Model& model,
             std::array<typename Model::State::value_type, std::tuple_size_v<typename Model::State> / 2> q) {
  model.acceleration(q, q);
};

/// The model that integrates in place of this one, if it declares one with the same right-hand side: it is
/// compiled only once.
template <class Model>
struct MovedAs {
  using type = Model;
};
template <class Model>
requires requires { typename Model::MovesAs; }
struct MovedAs<Model> {
  using type = typename Model::MovesAs;
  static_assert(std::is_base_of_v<type, Model> && sizeof(type) == sizeof(Model) &&
                std::is_standard_layout_v<Model>);
};

/// A model that declares that two registers per number would not fit the machine's.
template <class Model>
concept FillsRegisters = Model::fills_registers;

template <template <class> class Given>
constexpr std::size_t parameter_count = sizeof(Given<double>) / sizeof(double);

/// The exercise's first parameters, of which value(i) is the i-th.
template <template <class> class Given, class Number, class Value>
Given<Number> given(const Value& value) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) { return Given<Number>{value(i)...}; }
  (std::make_index_sequence<parameter_count<Given>>());
}

/// A model's bodies side by side.
template <class Alone, class Together>
struct InGroups {
  using StateAlone = typename Alone::State;
  using State = typename Together::State;
  using In = Grouped<Alone, Together>;
  static_assert(alignof(Together) <= alignment && alignof(State) <= alignment);

  static void in(const Bodies& all, std::byte* models, std::byte* states) {
    In::put_all(reinterpret_cast<const Alone*>(all.models), reinterpret_cast<const StateAlone*>(all.states),
                all.count, reinterpret_cast<Room<Together>*>(models), reinterpret_cast<State*>(states));
  }
  static void out(const std::byte* states, const Bodies& all) {
    In::take_all(reinterpret_cast<const State*>(states), reinterpret_cast<StateAlone*>(all.states),
                 all.count);
  }
  static constexpr Grouping grouping() {
    return {Pair<Alone, Together>::width, sizeof(Room<Together>), sizeof(State), in, out};
  }
  template <template <class> class Stepper>
  static void by(const Groups& all, double t0, double h, long steps) {
    fixed_steps<Stepper<Together>, Together>(reinterpret_cast<const Room<Together>*>(all.models),
                                             reinterpret_cast<State*>(all.states), all.count, t0, h, steps);
  }
  static bool own_steps(const Groups& all, double t0, double t1, double tolerance, double first_step,
                        Ended* each) {
    using T = typename State::value_type::value_type;
    OwnSteps<Together> steps(static_cast<T>(t0), static_cast<T>(t1), static_cast<T>(tolerance),
                             static_cast<T>(first_step));
    return steps.run(reinterpret_cast<const Room<Together>*>(all.models),
                     reinterpret_cast<State*>(all.states), all.count, each);
  }
};

template <class Set, template <class> class Given, class T, std::size_t i>
struct Kernels {
  template <class Number>
  using Moving = typename MovedAs<Model<Given, Number, i>>::type;
  using Alone = Moving<Single<T>>;

  /// With this many registers per number. Few unknowns leave the machine waiting; many would not stay in its
  /// registers.
  template <int registers>
  using Together = InGroups<Alone, Moving<Lanes<T, Set, Set::bytes == 0 ? 1 : registers>>>;

  static void at(const double* parameters, std::size_t bodies, double t, double* observed) {
    using Number = Lanes<T, Set, 1>;
    for (std::size_t first = 0; first < bodies; first += Number::size()) {
      const auto of = given<Given, Number>([&](std::size_t k) {
        Number x;
        for (std::size_t lane = 0; lane < Number::size(); ++lane) {
          const std::size_t body = first + lane < bodies ? first + lane : bodies - 1;
          x.set(lane, static_cast<T>(parameters[body * parameter_count<Given> + k]));
        }
        return x;
      });
      const auto all = models(of);
      const auto seen = std::get<i>(all).at(Number(static_cast<T>(t)));
      for (std::size_t lane = 0; lane < Number::size() && first + lane < bodies; ++lane)
        for (std::size_t k = 0; k < seen.size(); ++k)
          observed[(first + lane) * seen.size() + k] = static_cast<double>(seen[k][lane]);
    }
  }

  static constexpr Compiled compiled() {
    Compiled all{.width = Lanes<T, Set, 1>::size()};
    if constexpr (Integrated<Alone>) {
      constexpr std::size_t unknowns = std::tuple_size_v<typename Alone::State>;
      constexpr bool many = unknowns > 10;  // to stay in registers with two each
      // Forces have hardly a term to wait for, and with 16 registers two per number leave too few.
      constexpr bool light = WithForces<Alone> && unknowns > 4;
      using OfFixed = Together<unknowns <= 2 ? 4 : many || (light && Set::bytes <= 32) ? 1 : 2>;
      using OfOwn = Together<many || light || FillsRegisters<Alone> ? 1 : 2>;
      all.for_fixed_steps = OfFixed::grouping();
      all.for_own_steps = OfOwn::grouping();
      all.own_steps = OfOwn::own_steps;
      all.fixed[static_cast<int>(Fixed::runge_kutta_4)] = OfFixed::template by<plain::RungeKutta4>;
      if constexpr (WithForces<Alone>) {
        all.fixed[static_cast<int>(Fixed::velocity_verlet)] = OfFixed::template by<plain::VelocityVerlet>;
        all.fixed[static_cast<int>(Fixed::symplectic_euler)] = OfFixed::template by<plain::SymplecticEuler>;
      }
    } else {
      all.at = at;
    }
    return all;
  }
};

/// The models in double, and then in float.
template <class Set, template <class> class Given>
constexpr auto compiled_models = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array{Kernels<Set, Given, double, i>::compiled()...,
                    Kernels<Set, Given, float, i>::compiled()...};
}
(std::make_index_sequence<model_count<Given>>());

}  // namespace oddity::lanes
