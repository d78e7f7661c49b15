#include "report/tried.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/text.hpp"

namespace oddity {

namespace {

/// Steps a frame, from one on, none much more than half as many again as the one before.
constexpr std::array steps_a_frame{1,  2,  3,  4,  5,  6,  8,   10,  12,  16,  20,  24,
                                   32, 40, 48, 64, 80, 96, 128, 160, 192, 256, 384, 512};

}  // namespace

std::vector<double> settings(const Method& method, const Need& need) {
  std::vector<double> all;
  if (method.knob.name == "step")
    for (int steps : steps_a_frame) all.push_back(1 / (need.frames_a_second * steps));
  else if (method.knob.name == "tolerance")
    all = tolerances(2, 13, 1).settings;
  else
    all = method.knob.settings;
  return all;
}

Tried attempt(const std::vector<Start>& starts, const Method& method, double setting, const Need& need,
              Trial* first) {
  Tried tried{method.model, method.algorithm, method.knob.name, setting};
  for (const Start& start : starts) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Method* here = method_of(start.motion, method.model, method.algorithm);
    const Trial trial =
        here ? run(start.motion, *here, setting)
             : Trial{method.model, method.algorithm, {}, setting, {}, nan, nan, Outcome::raised};
    if (&start == &starts.front()) {
      tried.evaluations_a_frame = static_cast<double>(trial.answer.evaluations) / need.frames();
      if (first) *first = trial;
    }
    const double error = trial.error / start.motion.need.allowed;
    tried.error =
        std::isfinite(error) ? std::max(tried.error, error) : std::numeric_limits<double>::infinity();
    if (tried.holds() && trial.outcome != Outcome::ok) {
      tried.outcome = trial.outcome;
      tried.where = start.says;
    }
  }
  return tried;
}

std::string shown_setting(const Tried& tried, const Need& need) {
  if (tried.knob != "step") return tried.knob.empty() ? "-" : tried.knob + " " + shortest(tried.setting);
  const double steps = std::round(1 / (tried.setting * need.frames_a_second));
  return shortest(steps) + (steps == 1 ? " step" : " steps") + " a frame";
}

bool hopeless(const Tried& tried) {
  return tried.outcome == Outcome::raised || tried.evaluations_a_frame > 1e5;
}

}  // namespace oddity
