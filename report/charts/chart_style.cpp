#include "report/charts/chart_style.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace oddity {

namespace {

struct Kin {
  std::string_view algorithm;
  Family family;
};

constexpr Kin families[] = {{"closed form", Family::closed_form},
                            {"explicit Euler", Family::explicit_steps},
                            {"Runge-Kutta 4", Family::explicit_steps},
                            {"modified midpoint", Family::explicit_steps},
                            {"explicit midpoint", Family::explicit_steps},
                            {"symplectic Euler", Family::partitioned},
                            {"velocity Verlet", Family::partitioned},
                            {"McLachlan 4", Family::partitioned},
                            {"Cash-Karp 5(4)", Family::step_control},
                            {"Dormand-Prince 5(4)", Family::step_control},
                            {"Fehlberg 7(8)", Family::step_control},
                            {"GSL rk8pd", Family::step_control},
                            {"ARKODE Zonneveld 4(3)", Family::step_control},
                            {"ARKODE Verner 6(5)", Family::step_control},
                            {"Bulirsch-Stoer", Family::extrapolation},
                            {"Adams-Bashforth 4", Family::multistep},
                            {"Adams-Bashforth-Moulton 6", Family::multistep},
                            {"GSL msadams", Family::multistep},
                            {"GSL msbdf", Family::multistep},
                            {"CVODE Adams", Family::multistep},
                            {"CVODE BDF", Family::multistep},
                            {"linearly implicit Euler", Family::implicit},
                            {"Rosenbrock 4", Family::implicit},
                            {"GSL bsimp", Family::implicit}};

/// In the order of the enumeration.
constexpr std::array<std::string_view, 10> outcome_colours{"#009E73", "#F0E442", "#56B4E9", "#D55E00",
                                                           "#000000", "#CCCCCC", "#0072B2", "#4D4D4D",
                                                           "#9900FF", "#000055"};

}  // namespace

Family family_of(std::string_view algorithm) {
  const auto found = std::ranges::find(families, algorithm, &Kin::algorithm);
  return found == std::end(families) ? Family::none : found->family;
}

std::string_view colour_of(Outcome outcome) { return outcome_colours[static_cast<std::size_t>(outcome)]; }

std::string_view colour_on(Outcome outcome) {
  const bool dark = outcome == Outcome::non_finite || outcome == Outcome::deceived ||
                    outcome == Outcome::raised || outcome == Outcome::chattering ||
                    outcome == Outcome::grazing;
  return dark ? "#FFFFFF" : "#000000";
}

}  // namespace oddity
