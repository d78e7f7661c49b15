#include "extras/engines/contest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "extras/engines/drifts.hpp"
#include "extras/engines/world_json.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "report/study/criterion.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run_program.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t memory = 4'000'000'000;
constexpr int last_timed = 4;  ///< steps per frame

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(std::lround(1000 * seconds));
}

/// The engine cannot build the world.
struct CannotBeHad : std::runtime_error {
  using std::runtime_error::runtime_error;
};

EngineProgram about(std::vector<std::string> command) try {
  std::vector<std::string> words = command;
  words.push_back("--about");
  const Ended ended = run_program(words, "", std::chrono::seconds(30));
  if (!ended.ok) throw BadInput(command.back() + " --about: " + ended.how + " " + ended.words);
  const auto json = nlohmann::json::parse(ended.output);
  EngineProgram engine{command,
                       json.at("name"),
                       json.at("version"),
                       json.at("precision"),
                       json.value("behind", "") == "WebAssembly",
                       {}};
  for (const auto& v : json.at("variants"))
    engine.variants.push_back({v.at("name"), v.at("says"), v.at("order"), v.at("defaults"),
                               v.value("lasting", ""), v.value("friction", "")});
  return engine;
} catch (const nlohmann::json::exception& error) {
  throw BadInput(command.back() + " --about: the engine's description is not valid: " + error.what());
}

/// Like run_program; a program that cannot be started counts as failed.
Ended answer(const std::vector<std::string>& command, const std::string& request,
             std::chrono::milliseconds limit, std::size_t most_memory) {
  try {
    return run_program(command, request, limit, most_memory);
  } catch (const std::system_error& error) {
    return {false, std::string("not started, ") + error.what(), "", ""};
  }
}

// ---- the path ---------------------------------------------------------------------------------------------

/// An angle is known up to whole turns: takes the one nearest to the reference.
void unwind(std::vector<double>& seen, const Quantity& motion, std::size_t observables) {
  constexpr double turn = 2 * std::numbers::pi;
  for (const Norm& norm : motion.norms)
    if (norm.unit == "rad" && norm.components.size() == 1)
      for (std::size_t i = norm.components.front(); i < seen.size(); i += observables)
        seen[i] -= turn * std::round((seen[i] - motion.reference.value[i]) / turn);
}

std::vector<double> observed(const EngineScene& contest,
                             const std::vector<std::vector<engines::State>>& frames) {
  std::vector<double> seen;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto now =
        contest.staging.observe(frames[i], static_cast<double>(i) / contest.need.frames_per_second);
    seen.insert(seen.end(), now.begin(), now.end());
  }
  if (frames.size() > 1) unwind(seen, contest.motion, seen.size() / (frames.size() - 1));
  return seen;
}

/// Error by a criterion, in its own unit. The energy, where it is conserved, and the distance in joints come
/// from the engine's own bodies.
double off_by(Criterion criterion, const EngineTrial& trial, const EngineScene& contest,
              const std::vector<double>& seen) {
  const double observed = off_by_observed(criterion, contest.motion, Value(seen), trial.errors).error;
  const double own = criterion == Criterion::energy       ? trial.energy
                     : criterion == Criterion::constraint ? std::max(trial.off_joint, observed)
                                                          : observed;
  return std::isnan(own) ? std::numeric_limits<double>::infinity() : own;
}

Outcome outcome_of(const EngineTrial& trial, std::size_t frames, const EngineScene& contest) {
  if (static_cast<double>(frames) <= contest.need.frames()) return Outcome::non_finite;
  return trial.in_needs <= 1 ? Outcome::ok : Outcome::inaccurate;
}

void judge(EngineTrial& trial, const EngineScene& contest, const engines::Reply& reply) {
  if (reply.frames.empty() || reply.seconds.empty()) {  // its start is not finite
    trial.outcome = Outcome::non_finite;
    return;
  }
  std::vector<double> seen = observed(contest, reply.frames);
  trial.errors = contest.motion.errors(seen);
  trial.energy = engines::energy_drift(contest.staging.world, reply.frames);
  trial.momentum = engines::momentum_drift(contest.staging.world, reply.frames);
  trial.off_joint = engines::joints_apart(contest.staging.world, reply.frames);
  trial.in_needs = static_cast<double>(reply.frames.size()) > contest.need.frames() ? 0 : not_a_number;
  for (Criterion criterion : criteria_of(contest.need)) {
    const double off = off_by(criterion, trial, contest, seen);
    if (criterion != Criterion::path) trial.by[criterion] = off;
    trial.in_needs = std::max(trial.in_needs, off / contest.need.error_by(criterion));
  }
  trial.outcome = outcome_of(trial, reply.frames.size(), contest);
  std::vector<double> seconds = reply.seconds;
  std::ranges::sort(seconds);
  trial.seconds_per_frame = seconds[seconds.size() / 2] / contest.need.frames();
  trial.spread = (seconds.back() - seconds.front()) / contest.need.frames();
  trial.same_bits = reply.same_bits;
  trial.restored = reply.restored;
  trial.path = std::move(seen);
}

/// Names of the adapters in JavaScript, from their settings.
std::vector<std::string> adapters_in(const fs::path& folder) {
  const fs::path settings = folder / "variants.json";
  const auto adapters = nlohmann::json::parse(read_whole(settings), nullptr, false);
  if (!adapters.is_object()) throw BadInput(settings.string() + " is not an object in JSON");
  std::vector<std::string> names;
  for (const auto& [adapter, _] : adapters.items())
    if (adapter.ends_with(".mjs")) names.push_back(fs::path(adapter).stem().string());
  return names;
}

}  // namespace

std::vector<EngineProgram> engines_found(const fs::path& folder, const fs::path& adapters) {
  std::vector<std::vector<std::string>> commands;
  for (const fs::path& code : {folder, adapters})
    if (fs::is_directory(code)) require_own(code);
  if (fs::is_directory(folder))
    for (const auto& file : fs::directory_iterator(folder))
      if (file.path().filename().string().starts_with("engine_") && file.path().extension().empty())
        commands.push_back({file.path().string()});
  if (fs::is_directory(adapters / "node_modules"))
    for (const std::string& name : adapters_in(adapters))
      commands.push_back({"node", (adapters / "runner.mjs").string(), name});
  std::ranges::sort(commands);
  std::vector<EngineProgram> found;
  for (auto& command : commands) found.push_back(about(std::move(command)));
  std::ranges::sort(found, {}, [](const EngineProgram& e) { return std::pair(e.webassembly, e.name); });
  return found;
}

namespace {

EngineTrial tried(const EngineProgram& engine, const EngineVariant& variant, const EngineScene& contest,
                  int steps_per_frame, int runs, double limit) {
  EngineTrial trial{steps_per_frame};
  trial.in_needs = trial.energy = trial.momentum = trial.off_joint = trial.seconds_per_frame = not_a_number;
  const engines::Request request{contest.staging.world,
                                 variant.name,
                                 static_cast<int>(contest.need.frames()),
                                 contest.need.frames_per_second,
                                 steps_per_frame,
                                 runs,
                                 steps_per_frame == 1};
  const bool native = !engine.webassembly;  // a WebAssembly engine reserves addresses that it does not use
  const Ended ended =
      answer(engine.command, nlohmann::json(request).dump(), milliseconds(limit), native ? memory : 0);
  if (!ended.ok) {
    const bool late = ended.how.starts_with("no answer");
    trial.outcome = late ? Outcome::stalled : Outcome::raised;
    trial.message = ended.how + (ended.words.empty() ? "" : ": " + ended.words.substr(0, 200));
    return trial;
  }
  engines::Reply reply;
  try {
    reply = nlohmann::json::parse(ended.output).get<engines::Reply>();
  } catch (const nlohmann::json::exception& error) {
    trial.outcome = Outcome::raised;
    trial.message = std::string("its answer is no reply: ") + error.what();
    return trial;
  }
  if (!reply.cannot.empty()) throw CannotBeHad(reply.cannot);
  judge(trial, contest, reply);
  return trial;
}

}  // namespace

EngineTrial run(const EngineProgram& engine, const EngineVariant& variant, const EngineScene& contest,
                int steps_per_frame, const EngineTask& task) {
  const int runs = steps_per_frame <= last_timed ? task.timed : 1;
  return tried(engine, variant, contest, steps_per_frame, runs, task.limit);
}

namespace {

/// A variant that is refined from coarse to fine.
struct Entrant {
  const EngineProgram* engine;
  const EngineVariant* variant;
  EngineSeries series;
};

/// Runs finer trials while they are at most `last` steps per frame.
void go_on(Entrant& entrant, const EngineScene& scene, int last, const EngineTask& task) {
  EngineSeries& series = entrant.series;
  if (!series.cannot.empty()) return;
  try {
    int steps = series.trials.empty() ? 1 : 2 * series.trials.back().steps_per_frame;
    for (; steps <= last; steps *= 2) {
      if (!series.trials.empty() && series.trials.back().outcome == Outcome::stalled) return;
      series.trials.push_back(run(*entrant.engine, *entrant.variant, scene, steps, task));
      if (steps > 1 || !series.defaults) series.trials.back().path.clear();
    }
  } catch (const CannotBeHad& reason) {
    series.cannot = reason.what();
  }
}

/// Times the first sufficient trial, whose price the tables show: if it is finer than all timed ones, it runs
/// once more, alone.
void time_what_is_enough(Entrant& entrant, const EngineScene& scene, const EngineTask& task) {
  const EngineTrial* const enough = entrant.series.first_enough();
  if (!enough || enough->steps_per_frame <= last_timed) return;
  EngineTrial& trial = entrant.series.trials[static_cast<std::size_t>(enough - entrant.series.trials.data())];
  const EngineTrial alone = tried(*entrant.engine, *entrant.variant, scene, trial.steps_per_frame, task.timed,
                                  task.timed * task.limit);
  trial.seconds_per_frame = alone.seconds_per_frame;
  trial.spread = alone.spread;
  trial.same_bits = trial.same_bits && alone.same_bits;
}

std::vector<Entrant> entrants(const std::vector<EngineProgram>& programs) {
  std::vector<Entrant> all;
  for (const EngineProgram& e : programs)
    for (const EngineVariant& v : e.variants)
      all.push_back({&e,
                     &v,
                     {e.name, e.version, e.precision, v.name, v.says, v.defaults, e.webassembly, v.order,
                      v.lasting, v.friction}});
  return all;
}

}  // namespace

EngineContest run(const std::vector<EngineProgram>& programs, const EngineScene& scene,
                  const EngineTask& task, const Progress& progress) {
  EngineContest result{
      scene.scene, scene.title, {}, scene.motion.needs, scene.need.horizon, scene.need.frames_per_second,
      {},          {}};
  result.differs = scene.staging.differs;
  result.criteria.clear();
  for (Criterion criterion : criteria_of(scene.need))
    result.criteria.emplace_back(criterion, scene.need.error_by(criterion));
  result.rubs = scene.staging.world.friction != 0;
  for (std::string_view unit : scene.motion.units()) result.units.emplace_back(unit);
  std::vector<Entrant> all = entrants(programs);
  Stage stage(progress, "engines on " + scene.scene, 2 * all.size());
  for (Entrant& one : all) {  // timed: alone
    go_on(one, scene, std::min(last_timed, task.finest), task);
    stage.add();
  }
  parallel_for_each(all, [&](Entrant& one) {
    go_on(one, scene, task.finest, task);
    stage.add();
  });
  for (Entrant& one : all) {
    time_what_is_enough(one, scene, task);
    summarize(one.series);
    result.series.push_back(std::move(one.series));
  }
  return result;
}

}  // namespace oddity
