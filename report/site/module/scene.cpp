#include "report/site/module/scene.hpp"

#include <algorithm>

#include "chapters/drift.hpp"
#include "solvers/ode/all.hpp"

namespace oddity::module {

namespace {

Motion refused(const char* why) {
  Motion motion;
  motion.ending = Ending::raised;
  motion.message = why;
  return motion;
}

struct Known {
  bool found = false, partitioned = false, velocities_first = false, in_float = false;
};

Known known(std::string_view algorithm) {
  Known known;
  ode::for_each_algorithm([&]<class Algorithm>() {
    if (Algorithm::name == algorithm)
      known = {true, Algorithm::kind == ode::Kind::partitioned,
               Algorithm::kind == ode::Kind::velocities_first, Algorithm::facts.in_float};
  });
  return known;
}

std::vector<double> evenly(double end, int count) {
  std::vector<double> times;
  for (int k = 0; k <= count; ++k) times.push_back(end * k / count);
  return times;
}

}  // namespace

template <std::size_t n>
Motion ModelInterfaceOf<n>::run(std::string_view algorithm, Precision precision, double setting,
                                std::span<const double> times) const {
  const Known by = known(algorithm);
  if (!by.found) return refused("the module does not have this algorithm");
  if (by.partitioned && !this->partitioned()) return refused("the model is not partitioned");
  if (by.velocities_first && !has_velocities()) return refused("the model has no velocities");
  if (precision == Precision::in_float && !by.in_float) return refused("this algorithm is in double only");
  if (precision == Precision::in_float && has_events()) return refused("events are found in double only");
  return seen(moved(algorithm, precision, setting, times), times);
}

template <std::size_t n>
auto ModelInterfaceOf<n>::moved(std::string_view algorithm, Precision precision, double setting,
                                std::span<const double> times) const -> ode::Trajectory<State> {
  if (precision == Precision::in_double) return integrate(algorithm, times, setting, {});
  const auto narrow = (*ode::in_float<n>(algorithm))(system_in_float(), start_in_float(), times, setting);
  ode::Trajectory<State> widened{{}, narrow.evaluations, narrow.error_estimate,
                                 0,  narrow.ending,      narrow.message};
  for (const std::array<float, n>& x : narrow.value) {
    widened.value.emplace_back();
    std::copy(x.begin(), x.end(), widened.value.back().begin());
  }
  return widened;
}

template <std::size_t n>
Motion ModelInterfaceOf<n>::seen(const ode::Trajectory<State>& trajectory,
                                 std::span<const double> times) const {
  Motion motion;
  motion.states = trajectory.value.size();
  motion.whole = motion.states - (trajectory.reached() || motion.states == 0 ? 0 : 1);
  for (std::size_t i = 0; i < motion.states; ++i) {
    observe(trajectory.value[i], times[i], motion.observed);
    if (this->constrained()) motion.off.push_back(off_constraint(trajectory.value[i], times[i]));
  }
  motion.drift = drift(trajectory, times);
  motion.evaluations = trajectory.evaluations;
  motion.ending = trajectory.ending;
  motion.message = trajectory.message;
  return motion;
}

template <std::size_t n>
std::vector<double> ModelInterfaceOf<n>::drift(const ode::Trajectory<State>& trajectory,
                                               std::span<const double> times) const {
  if (trajectory.value.empty()) return {};
  const auto at_start = conserved(trajectory.value[0], times[0]);
  if (at_start.empty()) return {};
  const std::vector<double>& scale = moving(times.back());
  std::vector<double> all;
  for (std::size_t i = 0; i < trajectory.value.size(); ++i)
    all.push_back(oddity::drift(at_start, conserved(trajectory.value[i], times[i]), scale));
  return all;
}

template <std::size_t n>
const std::vector<double>& ModelInterfaceOf<n>::moving(double end) const {
  auto& most = moving_[end];
  if (!most.empty()) return most;
  long steps = 0;  // a model that chatters near rest would take millions
  const auto enough = [&](double, const State&, double, const State&) { return ++steps > 100'000; };
  const auto times = evenly(end, 128);
  const auto motion = integrate("Dormand-Prince 5(4)", times, 1e-8, ode::Watch<n>(enough));
  most.resize(conserved(start(), 0).size());
  for (std::size_t i = 0; i < motion.value.size(); ++i) {
    const auto now = conserved(motion.value[i], times[i]);
    for (std::size_t k = 0; k < most.size(); ++k)
      if (now[k].moving > most[k]) most[k] = now[k].moving;
  }
  return most;
}

#define ODDITY_MODEL(n, type) template class type<n>;
ODDITY_FOR_UNKNOWNS(ODDITY_MODEL, ModelInterfaceOf)

}  // namespace oddity::module
