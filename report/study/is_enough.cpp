#include "report/study/is_enough.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/study/criterion.hpp"
#include "report/study/in_time.hpp"
#include "report/study/parallel.hpp"
#include "report/study/parting.hpp"
#include "report/study/stability.hpp"
#include "solvers/stop.hpp"

namespace oddity {

namespace {

/// Common names of an algorithm, as letters and digits only, and its names here: the first of these that a
/// scene has.
struct Alias {
  std::string_view name, algorithm;
};
constexpr Alias aliases[]{
    {"semiimpliciteuler", "semi-implicit Euler"},
    {"semiimpliciteuler", "symplectic Euler"},
    {"symplecticeuler", "semi-implicit Euler"},
    {"eulercromer", "symplectic Euler"},
    {"eulercromer", "semi-implicit Euler"},
    {"euler", "explicit Euler"},
    {"forwardeuler", "explicit Euler"},
    {"rk4", "Runge-Kutta 4"},
    {"rungekutta", "Runge-Kutta 4"},
    {"verlet", "velocity Verlet"},
    {"stormerverlet", "velocity Verlet"},
    {"stoermerverlet", "velocity Verlet"},
    {"leapfrog", "velocity Verlet"},
    {"kickdriftkick", "velocity Verlet"},
    {"impliciteuler", "linearly implicit Euler"},
    {"backwardeuler", "linearly implicit Euler"},
    {"ab4", "Adams-Bashforth 4"},
    {"adamsbashforth", "Adams-Bashforth 4"},
    {"rk45", "Dormand-Prince 5(4)"},
    {"ode45", "Dormand-Prince 5(4)"},
    {"dopri5", "Dormand-Prince 5(4)"},
    {"dormandprince", "Dormand-Prince 5(4)"},
    {"rkf78", "Fehlberg 7(8)"},
    {"vern9", "Verner 9(8)"},
};

std::string plain(std::string_view name) {
  std::string letters;
  for (unsigned char c : name)
    if (std::isalnum(c)) letters += static_cast<char>(std::tolower(c));
  return letters;
}

std::vector<std::string> algorithms_of(const std::vector<Method>& methods) {
  std::vector<std::string> names;
  for (const Method& m : methods)
    if (std::ranges::find(names, m.algorithm) == names.end()) names.push_back(m.algorithm);
  return names;
}

/// Growth of the error on the requested start, in the second half of the time.
double growth_of(const Quantity& motion, const Value& path) {
  const std::vector<double> until = errors_until(motion, path);
  return until.size() < 2 ? not_a_number : until.back() / until[until.size() / 2 - 1];
}

/// Judged at the scene's own times, as in `stability`.
std::optional<double> stable_to(const Task& task, const Method& asked) {
  if (!asked.unstable_steps) return {};
  const Scene& scene = *task.entry->exercise.scene;
  const Quantity seen = motion(scene, task.parameters, Reference::nothing());
  const Method* method = method_of(seen, asked.model, asked.algorithm);
  return method ? std::optional(measured_limit(*method, scene.horizon / seen.samples).step()) : std::nullopt;
}

/// The need with its frame rate matched to the step, which then divides a frame or is one. Frames of
/// different lengths stay as they are.
Need at_steps(Need need, const Method& method, double step) {
  if (method.resolution.name != "step" || need.frame_times) return need;
  const double rate = 1 / step;
  need.frames_per_second = rate / std::max(1.0, std::floor(rate / need.frames_per_second * (1 + 1e-9)));
  return need;
}

class Judge {
 public:
  Judge(const Task& task, const Need& need, const Reference& truth, const Price& price,
        const Progress& progress)
      : task_(task), need_(need), price_(price), conditions_(task, need, truth) {
    Stage stage(progress, "making the true motions", static_cast<std::size_t>(need.starts));
    starts_ = conditions_.asked_and_nearby(need.starts - 1, [&] { stage.add(); });
    try {
      energy_ = true_energy(starts_.front().motion);
    } catch (const BadInput&) {  // the motion has none
    }
  }

  Judgement operator()(const Method& method, double setting) const {
    check_stop();
    const Quantity& motion = starts_.front().motion;
    const auto& faulted = task_.entry->exercise.scene->faulted;
    Judgement judged{evaluate(starts_, method, setting, need_),
                     std::ranges::find(faulted, method.model) != faulted.end()};
    for (const Start& start : starts_)
      judged.failing += !evaluate(std::span(&start, 1), method, setting, need_).holds();
    const Trial trial = oddity::run(motion, method, setting);
    judged.growth = growth_of(motion, trial.answer.value);
    judged.drift = trial.answer.drift;
    if (energy_ && method.places_and_rates)
      judged.energy = off_by(Criterion::energy, motion, method, trial, trial.errors, &*energy_).error;
    judged.stable_to = stable_to(task_, method);
    judged.run.seconds_per_frame = price_(method, setting).seconds / motion.samples;
    return judged;
  }

  const std::vector<Start>& starts() const { return starts_; }

 private:
  const Task& task_;
  const Need& need_;
  const Price& price_;
  InitialConditions conditions_;
  std::vector<Start> starts_;
  std::optional<TrueEnergy> energy_;
};

}  // namespace

std::vector<std::string> algorithms_meant(const std::string& name, const std::vector<Method>& methods) {
  std::vector<std::string> meant;
  for (const std::string& algorithm : algorithms_of(methods)) {
    const bool is_called_so =
        plain(algorithm) == plain(name) || std::ranges::any_of(aliases, [&](const Alias& a) {
          return a.name == plain(name) && a.algorithm == algorithm;
        });
    if (is_called_so) meant.push_back(algorithm);
  }
  return meant;
}

IsEnough is_enough(const Task& task, const Need& asked, const MethodAsked& method, const Reference& truth,
                   const Price& price, const Progress& progress) {
  const Scene& scene = *task.entry->exercise.scene;
  const auto is_asked = [&](const Method& m) {
    return m.algorithm == method.algorithm && m.model.find(method.model) != std::string::npos;
  };
  const Quantity seen = motion(scene, task.parameters, Reference::nothing());
  const auto any = std::ranges::find_if(seen.methods, is_asked);
  if (any == seen.methods.end())
    throw BadInput("no model of " + to_string(task.entry->number) + " has '" + method.model +
                   "' in its name and " + method.algorithm);
  return in_time(asked.time_limit, "a shorter horizon or a model alone (--model)", [&] {
    IsEnough found{with_ways(at_steps(asked, *any, method.setting), task, truth),
                   to_string(task.entry->number), std::string(scene.axes.time)};
    const Judge judge(task, found.need, truth, price, progress);
    for (std::string_view unit : judge.starts().front().motion.units()) found.units.emplace_back(unit);
    for (const Start& start : judge.starts()) found.starts.push_back(start.says);
    const auto& methods = judge.starts().front().motion.methods;
    Stage stage(progress, "judging the method",
                static_cast<std::size_t>(std::ranges::count_if(methods, is_asked)));
    for (const Method& m : methods)
      if (is_asked(m)) {
        found.models.push_back(judge(m, method.setting));
        stage.add();
      }
    std::ranges::stable_sort(found.models, {},
                             [](const Judgement& j) { return std::pair(j.faulted, j.run.error); });
    return found;
  });
}

}  // namespace oddity
