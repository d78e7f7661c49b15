// Exercise 99.98: replace this by the question in one sentence, and the sources with page. The mass on a
// spring is an example, to be replaced.

#include "chapters/energies.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex99_98 {

Quantity swing(const Parameters&, const Horizon&, const Reference&);  // methods.cpp
std::vector<Claim> claims(const Parameters&, const Reference&);       // claims.cpp

constexpr Parameter parameters[] = {{"c", 40, "N/m", "spring constant", 1, 1e4},
                                    {"m", 1, "kg", "mass", 0.1, 100},
                                    {"x0", 0.125, "m", "stretch when it is let go", 0.01, 1}};

/// Energy of the observed place x[0] and its rate x[1].
Energy energy(const Parameters& p, std::span<const double> x) {
  return energy_seen(p["m"] * x[1] * x[1] / 2, p["c"] * x[0] * x[0] / 2);
}

Scene scene() {
  return {.motion = swing,
          .horizon = 10,
          .game_tolerance = centimeter,
          .sweep_parameter = "c",
          .sweep_values = {10, 40, 160, 640},
          .perturbed_parameters = {"x0"},
          .axes = {{"x"}, "s", {{"m", {0}}}},
          .listing = {{"chapters/99_my_topic/98_my_scene/models.hpp"},
                      {{"mass on a spring", "ex99_98::MassOnSpring<double>{{c, m, x0}}"}}},
          .laws = {energy}};
}

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(p, truth), {motion(scene(), p, truth)}};
}

}  // namespace ex99_98

Exercise exercise_99_98() {
  using namespace ex99_98;
  return {"My scene", "still to be written: the quantity to find", parameters, scene(), study};
}

}  // namespace oddity
