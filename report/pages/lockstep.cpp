#include "report/pages/lockstep.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <system_error>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/pages/code.hpp"
#include "report/study/run_program.hpp"
#include "report/study/search.hpp"
#include "solvers/stop.hpp"

namespace oddity {

namespace {

using namespace std::chrono_literals;

constexpr const char* compiler = "c++";

/// Algorithms and models that the need allows but that have no program in lockstep, by reason.
std::map<std::string, std::vector<std::string>> left_out(const Task& task, Need need) {
  need.takes = nullptr;
  std::map<std::string, std::vector<std::string>> all;
  const Quantity seen = motion(*task.entry->exercise.scene, task.parameters, Reference::nothing());
  for (const auto* methods : {&seen.methods, &seen.methods_in_float})
    for (const Method& m : *methods) {
      const std::string why = is_wanted(need, m) ? why_not_in_lockstep(task, m.model, m.algorithm) : "";
      if (why.empty()) continue;
      std::vector<std::string>& names = all[why];
      const std::string& name = why.starts_with("has a model") ? m.model : m.algorithm;
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  return all;
}

/// Seconds printed by the program; nullopt if it fails.
std::optional<double> printed_by(const std::string& program) {
  const Ended ran = run_program({program}, "", 60s);
  const auto end = ran.output.find('\n');
  return ran.ok && end != std::string::npos ? parse_number(ran.output.substr(0, end)) : std::nullopt;
}

/// Times both programs alternately, so that disturbances affect both.
void measure(const Task& task, const Choice& choice, InLockstep& found) {
  if (program_on_path(compiler).empty()) {
    found.measured = "its cost is not measured, as there is no c++ here";
    return;
  }
  const PassingFolder folder;
  const std::array<std::string, 2> programs{folder / "usual", folder / "lockstep"};
  for (const bool lockstep : {false, true}) {
    const Ended made = run_program(
        {compiler, "-std=c++20", "-O2", "-ffp-contract=off", "-x", "c++", "-", "-o", programs[lockstep]},
        timing_code_of(task, *choice.chosen, choice.need, lockstep), 60s);
    if (!made.ok) {
      found.measured = "its cost is not measured, as c++ -std=c++20 does not compile it";
      return;
    }
  }
  std::array<double, 2> best{std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::infinity()};
  for (int turn = 0; turn < 3; ++turn)
    for (std::size_t i = 0; i < 2; ++i)
      if (const auto seconds = printed_by(programs[i])) best[i] = std::min(best[i], *seconds);
  found.measured = "measured here, both compiled by c++ -O2";
  if (std::isfinite(best[0]) && std::isfinite(best[1]) && best[0] > 0)
    found.times_usual = best[1] / best[0];
  else
    found.measured = "its cost is not measured, as its program did not end";
}

}  // namespace

Need in_lockstep(Need need, const Task& task) {
  need.lockstep = true;
  need.takes = [&task](const std::string& model, const std::string& algorithm) {
    return why_not_in_lockstep(task, model, algorithm).empty();
  };
  const Quantity seen = motion(*task.entry->exercise.scene, task.parameters, Reference::nothing());
  for (const auto* methods : {&seen.methods, &seen.methods_in_float})
    if (std::ranges::any_of(*methods, [&](const Method& m) { return is_wanted(need, m); })) return need;
  std::string reasons;
  for (const auto& [why, names] : left_out(task, need)) {
    reasons +=
        (reasons.empty() ? ": " : "; ") + std::string(names.size() > 1 ? "each of " : "") + names.front();
    for (std::size_t i = 1; i < names.size(); ++i) reasons += ", " + names[i];
    reasons += " " + why;
  }
  throw BadInput("--lockstep leaves no method" + reasons +
                 "; only programs that --code prints have the same bits everywhere");
}

InLockstep lockstep_of(const Task& task, const Choice& choice, double seconds) {
  InLockstep found;
  found.left_out = left_out(task, choice.need);
  if (!choice.chosen) return found;
  found.functions = functions_in_lockstep(task, *choice.chosen);
  const Stop stop(seconds);
  const Stoppable here(&stop);
  try {
    measure(task, choice, found);
  } catch (const Stopped&) {
    found.measured = "its cost is not measured, as the time limit left no more";
  }
  return found;
}

}  // namespace oddity
