#include "extras/bench/models.hpp"

namespace oddity::raced {

namespace {

template <class Model, class State>
std::function<Run()> any(const Model& model, const State& start, std::string_view algorithm, ode::Kind kind) {
  constexpr std::size_t n = std::tuple_size_v<State>;
  return [=, &integrate = ode::precompiled<n>(algorithm)] {
    const std::array times{0.0, span};
    const ode::Adapted<ode::AnySystem<n>, const Model&> system(model);
    const auto path = integrate(system, start, times, setting(kind), {});
    return Run{{path.value.back().begin(), path.value.back().end()}, path.evaluations};
  };
}

}  // namespace

std::function<Run()> precompiled(const pendulum::OneAngle<double>& model, const std::array<double, 2>& start,
                                 std::string_view algorithm, ode::Kind kind) {
  return any(model, start, algorithm, kind);
}

std::function<Run()> precompiled(const kepler::Cartesian<double>& model, const std::array<double, 4>& start,
                                 std::string_view algorithm, ode::Kind kind) {
  return any(model, start, algorithm, kind);
}

std::function<Run()> precompiled(const SpatialKepler& model, const std::array<double, 6>& start,
                                 std::string_view algorithm, ode::Kind kind) {
  return any(model, start, algorithm, kind);
}

}  // namespace oddity::raced
