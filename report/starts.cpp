#include "report/starts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/parallel.hpp"

namespace oddity {

namespace {

constexpr double nearby = 0.1;
constexpr int looks = 4;

}  // namespace

Starts::Starts(const Task& task, const Need& need, const Reference& truth)
    : task_(task), need_(need), truth_(truth) {
  if (!task.entry->exercise.scene)
    throw BadInput("exercise " + to_string(task.entry->number) + " has no motion to choose a method for");
  for (const auto& [name, value] :
       {std::pair("error", need.error), std::pair("horizon", need.horizon),
        std::pair("frame rate", need.frames_a_second), std::pair("budget", need.budget)})
    if (!(value > 0))
      throw BadInput("the " + std::string(name) + " must be positive, and is " + shortest(value));
  if (need.horizon * need.frames_a_second < 1) throw BadInput("the horizon is shorter than a frame");
}

Start Starts::start(const Parameters& p) const {
  std::string says;
  for (std::string_view name : scene().starts)
    says += (says.empty() ? "" : ", ") + std::string(name) + " = " + rounded(p[name], 4);
  Start start{says, scene().motion(p, {need_.horizon, looks, need_.frames_a_second}, truth_)};
  const double scale = need_.relative ? size_of(start.motion.reference.value) : 1;
  start.motion.need = {need_.error * scale, "asked for"};
  return start;
}

Start Starts::asked() const {
  Start asked = start(task_.parameters);
  if (asked.motion.need.allowed < asked.motion.reference_error)
    throw BadInput("the true motion is known to " + rounded(asked.motion.reference_error, 2) +
                   ", and the error asked for is smaller");
  return asked;
}

Parameters Starts::draw() {
  Parameters p = task_.parameters;
  for (std::string_view name : scene().starts) {
    const auto declared = std::ranges::find(p.declared(), name, &Parameter::name);
    const double value = p[name], size = value == 0 ? 1 : std::abs(value);
    p.set(name, std::clamp(value + size * random_.between(-nearby, nearby), declared->least, declared->most));
  }
  return p;
}

std::vector<Start> Starts::beside(int count) {
  std::vector<Parameters> drawn;
  for (int i = 0; i < count; ++i) drawn.push_back(draw());
  std::vector<std::optional<Start>> made(drawn.size());
  in_parallel(drawn.size(), [&](std::size_t i) {
    try {
      made[i] = start(drawn[i]);
    } catch (const std::exception&) {  // no reference there
    }
  });
  std::vector<Start> known;
  for (auto& one : made)
    if (one) known.push_back(std::move(*one));
  return known;
}

}  // namespace oddity
