#pragma once

#include "extras/lanes/kernels.hpp"
#include "extras/lanes/scenes.hpp"

/// Models of single numbers that give the initial states of bodies; compiled for every machine.
namespace oddity::lanes {

template <class Model>
concept WithEvents = requires(const Model& model, typename Model::State x) {
  model.guards(x, typename Model::State::value_type(0));
};
template <class Model>
concept WithOwnEnd = requires(const Model& model) {
  model.end();
};

template <template <class> class Given, class T, std::size_t i>
struct Begun {
  using Alone = Model<Given, Single<T>, i>;

  static void begin(const double* parameters, std::byte* model, std::byte* state) {
    const auto all = models(
        given<Given, Single<T>>([&](std::size_t k) { return Single<T>(static_cast<T>(parameters[k])); }));
    const Alone& one = std::get<i>(all);
    const auto x = one.start();
    std::memcpy(model, &one, sizeof one);
    std::memcpy(state, &x, sizeof x);
  }
  static void observe(const std::byte* model, const std::byte* state, double t, double* observed) {
    Room<Alone> room;
    typename Alone::State x;
    std::memcpy(&room.model, model, sizeof room.model);
    std::memcpy(&x, state, sizeof x);
    for (const auto& seen : room.model.observe(x, Single<T>(static_cast<T>(t))))
      *observed++ = static_cast<double>(seen[0]);
  }

  static constexpr Beginning beginning() {
    if constexpr (!Integrated<Alone>) {
      return {.observables = std::tuple_size_v<decltype(std::declval<Alone>().at(Single<T>()))>};
    } else {
      using State = typename Alone::State;
      return {std::tuple_size_v<State>,
              sizeof(Alone),
              sizeof(State),
              std::tuple_size_v<decltype(std::declval<Alone>().observe(State(), Single<T>()))>,
              WithEvents<Alone>,
              WithOwnEnd<Alone>,
              begin,
              observe};
    }
  }
};

template <template <class> class Given>
constexpr auto beginnings = []<std::size_t... i>(std::index_sequence<i...>) {
  return std::array{Begun<Given, double, i>::beginning()..., Begun<Given, float, i>::beginning()...};
}
(std::make_index_sequence<model_count<Given>>());

}  // namespace oddity::lanes
