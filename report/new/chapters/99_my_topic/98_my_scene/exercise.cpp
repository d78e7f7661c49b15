// Exercise 99.98: here stands in one sentence what is asked, and the sources with page. What follows is a
// mass on a spring, to be replaced.

#include "chapters/energies.hpp"
#include "chapters/scene.hpp"

namespace oddity {

namespace ex99_98 {

Quantity swing(const Parameters&, const Horizon&, const Reference&);  // methods.cpp
std::vector<Claim> claims(const Parameters&, const Reference&);       // claims.cpp

constexpr Parameter parameters[] = {{"c", 40, "N/m", "spring constant", 1, 1e4},
                                    {"m", 1, "kg", "mass", 0.1, 100},
                                    {"x0", 0.125, "m", "stretch when it is let go", 0.01, 1}};

/// Of the place that is seen, and its rate.
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
  return {"My scene", "still to be written: what is to be found", parameters, scene(), study};
}

}  // namespace oddity
