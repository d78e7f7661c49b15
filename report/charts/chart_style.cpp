#include "report/charts/chart_style.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace oddity {

namespace {

constexpr std::size_t all_colours = 11;

/// Marks that are distinct even when small, by their numbers in gnuplot. Dashes distinguish algorithms that
/// share a mark. A slot is a mark with a kind of dashes.
constexpr std::array marks{7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};
constexpr std::array dashes{1, 2, 4};
constexpr std::size_t all_slots = marks.size() * dashes.size();

struct OwnMark {
  std::string_view algorithm;
  Family family;
  int mark, dashes = 1;

  std::size_t slot() const {
    const auto m = std::ranges::find(marks, mark) - marks.begin();
    const auto d = std::ranges::find(oddity::dashes, dashes) - oddity::dashes.begin();
    return static_cast<std::size_t>(m) + static_cast<std::size_t>(d) * marks.size();
  }
};

constexpr OwnMark own_marks[] = {{"closed form", Family::closed_form, 7},
                                 {"explicit Euler", Family::explicit_steps, 4},
                                 {"Runge-Kutta 4", Family::explicit_steps, 5},
                                 {"modified midpoint", Family::explicit_steps, 4, 2},
                                 {"explicit midpoint", Family::explicit_steps, 4, 4},
                                 {"symplectic Euler", Family::partitioned, 8},
                                 {"semi-implicit Euler", Family::partitioned, 8, 2},
                                 {"velocity Verlet", Family::partitioned, 9},
                                 {"McLachlan 4", Family::partitioned, 9, 2},
                                 {"Cash-Karp 5(4)", Family::step_control, 12},
                                 {"Dormand-Prince 5(4)", Family::step_control, 13},
                                 {"Fehlberg 7(8)", Family::step_control, 15},
                                 {"DOP853", Family::step_control, 13, 2},
                                 {"Verner 9(8)", Family::step_control, 14, 4},
                                 {"GSL rk8pd", Family::step_control, 14},
                                 {"ARKODE Zonneveld 4(3)", Family::step_control, 12, 2},
                                 {"ARKODE Verner 6(5)", Family::step_control, 14, 2},
                                 {"Bulirsch-Stoer", Family::extrapolation, 6},
                                 {"Adams-Bashforth 4", Family::multistep, 10},
                                 {"Adams-Bashforth-Moulton 6", Family::multistep, 11},
                                 {"GSL msadams", Family::multistep, 10, 2},
                                 {"GSL msbdf", Family::multistep, 11, 2},
                                 {"CVODE Adams", Family::multistep, 10, 4},
                                 {"CVODE BDF", Family::multistep, 11, 4},
                                 {"linearly implicit Euler", Family::implicit, 6, 2},
                                 {"Rosenbrock 4", Family::implicit, 15, 2},
                                 {"GSL bsimp", Family::implicit, 6, 4},
                                 {"Taylor series", Family::series, 7, 2},
                                 {"trapezoid", Family::none, 8},
                                 {"Simpson", Family::none, 9},
                                 {"Gauss-Legendre", Family::none, 15},
                                 {"QAGS", Family::none, 13},
                                 {"CQUAD", Family::none, 12},
                                 {"dual numbers", Family::none, 7},
                                 {"central differences 2", Family::none, 4},
                                 {"central differences 4", Family::none, 5}};

const OwnMark* own_mark(std::string_view algorithm) {
  const auto found = std::ranges::find(own_marks, algorithm, &OwnMark::algorithm);
  return found == std::end(own_marks) ? nullptr : found;
}

/// Names that appear together, in the order of first appearance.
class Neighbours {
 public:
  void add(const std::vector<std::string>& together) {
    for (const std::string& name : together) {
      if (std::ranges::find(names_, name) == names_.end()) names_.push_back(name);
      neighbours_[name].insert(together.begin(), together.end());
    }
  }
  /// The slot of each name: its fixed one, otherwise the first of `slots` that no neighbour has, or slot 0 if
  /// all are taken.
  template <class Fixed>
  std::map<std::string, std::size_t> slots(std::size_t slots, const Fixed& fixed) const {
    std::map<std::string, std::size_t> chosen;
    for (const std::string& name : names_)
      if (const auto slot = fixed(name)) chosen[name] = *slot;
    for (const std::string& name : names_) {
      if (chosen.contains(name)) continue;
      std::set<std::size_t> taken;
      for (const std::string& other : neighbours_.at(name))
        if (chosen.contains(other)) taken.insert(chosen.at(other));
      std::size_t slot = 0;
      while (taken.contains(slot)) ++slot;
      chosen[name] = slot % slots;
    }
    return chosen;
  }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::set<std::string>> neighbours_;
};

/// In the order of `Outcome`.
constexpr std::array<std::string_view, 10> outcome_colours{"#009E73", "#F0E442", "#56B4E9", "#D55E00",
                                                           "#000000", "#CCCCCC", "#0072B2", "#4D4D4D",
                                                           "#9900FF", "#000055"};

}  // namespace

Family family_of(std::string_view algorithm) {
  const OwnMark* own = own_mark(algorithm);
  return own ? own->family : Family::none;
}

std::string_view name_of(Family family) {
  constexpr std::array<std::string_view, 9> names{
      "",          "closed form", "explicit steps", "partitioned", "step control", "extrapolation",
      "multistep", "implicit",    "series"};
  return names[static_cast<std::size_t>(family)];
}

Styles::Styles(const Results& results) {
  Neighbours models, algorithms;
  for (const ExerciseResult& e : results.exercises)
    for (const QuantityResult& q : e.quantities) {
      std::map<std::string, std::vector<std::string>> of_model;
      std::vector<std::string> together;
      for (const MethodResult& m : q.methods) {
        together.push_back(m.model);
        of_model[m.model].push_back(m.algorithm);
      }
      models.add(together);
      for (const auto& [model, beside] : of_model) algorithms.add(beside);
    }
  using Slot = std::optional<std::size_t>;
  colours_ = models.slots(all_colours, [](const std::string&) { return Slot(); });
  marks_ = algorithms.slots(all_slots, [](const std::string& name) {
    const OwnMark* own = own_mark(name);
    return own ? Slot(own->slot()) : Slot();
  });
}

std::string_view colour_of(Outcome outcome) { return outcome_colours[static_cast<std::size_t>(outcome)]; }

std::string_view colour_on(Outcome outcome) {
  const bool dark = outcome == Outcome::non_finite || outcome == Outcome::deceived ||
                    outcome == Outcome::raised || outcome == Outcome::chattering ||
                    outcome == Outcome::grazing;
  return dark ? "#FFFFFF" : "#000000";
}

}  // namespace oddity
