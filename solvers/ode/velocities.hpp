#pragma once

#include <array>
#include <cstddef>
#include <tuple>

namespace oddity::ode {

/// Which of a system's n unknowns are velocities.
template <std::size_t n>
struct Velocities {
  std::array<bool, n> is{};         ///< unknown i is a velocity
  std::array<std::size_t, n> of{};  ///< the velocity that is the rate of unknown i; n: none
  bool known = false;               ///< the system has velocities, or declares that it has none

  /// Every unknown that is not a velocity has one as its rate.
  bool are_all_rates() const {
    for (std::size_t i = 0; i < n; ++i)
      if (!is[i] && of[i] == n) return false;
    return true;
  }
};

namespace detail {

/// Returns one of two states that have no component in common.
template <class State>
State some_state(std::size_t which) {
  State x{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double turns = 0.618 * static_cast<double>(i + 1) + 0.317 * static_cast<double>(which);
    x[i] =
        static_cast<typename State::value_type>(0.2 + turns - static_cast<double>(static_cast<int>(turns)));
  }
  return x;
}

/// Finds velocities by the rates: an unknown is one if the rate of another is equal to it at two states.
template <class State, class System>
auto velocities_seen(const System& system) {
  constexpr std::size_t n = std::tuple_size_v<State>;
  using T = typename State::value_type;
  const std::array states{some_state<State>(0), some_state<State>(1)};
  std::array<State, 2> rates{};
  for (std::size_t k = 0; k < 2; ++k)
    system(states[k], rates[k], static_cast<T>(0.3 + static_cast<double>(k)));
  Velocities<n> found;
  found.of.fill(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j && rates[0][i] == states[0][j] && rates[1][i] == states[1][j])
        found.of[i] = j, found.is[j] = found.known = true;
  return found;
}

}  // namespace detail

/// The velocities that the system declares in `static constexpr std::array<std::size_t, m> velocities`, with
/// m = 0 if they are known functions of time; else those that its rates show.
template <class State, class System>
auto velocities_of(const System& system) {
  constexpr std::size_t n = std::tuple_size_v<State>;
  if constexpr (requires { system.velocities(); }) {
    return system.velocities();
  } else if constexpr (requires { System::velocities.size(); }) {
    Velocities<n> declared;
    declared.of.fill(n);
    declared.known = true;
    for (std::size_t i : System::velocities) declared.is[i] = true;
    return declared;
  } else {
    return detail::velocities_seen<State>(system);
  }
}

/// Whether the rate of some unknown depends on time alone.
template <class State, class System>
bool has_rates_of_time(const System& system) {
  using T = typename State::value_type;
  State rate{}, of_other{}, later{};
  system(detail::some_state<State>(0), rate, T(0.3));
  system(detail::some_state<State>(1), of_other, T(0.3));
  system(detail::some_state<State>(0), later, T(0.9));
  for (std::size_t i = 0; i < rate.size(); ++i)
    if (rate[i] == of_other[i] && rate[i] != later[i]) return true;
  return false;
}

}  // namespace oddity::ode
