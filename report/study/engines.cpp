#include "report/study/engines.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run_program.hpp"
#include "solvers/engines/turns.hpp"
#include "solvers/engines/world_json.hpp"

namespace oddity {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t memory = 4'000'000'000;
constexpr int last_timed = 4;  ///< steps per frame

std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(std::lround(1000 * seconds));
}

/// The engine has no such world.
struct CannotBeHad : std::runtime_error {
  using std::runtime_error::runtime_error;
};

EngineProgram about(std::vector<std::string> command) {
  std::vector<std::string> words = command;
  words.push_back("--about");
  const Ended ended = run_program(words, "", std::chrono::seconds(30));
  if (!ended.ok) throw BadInput(command.back() + " --about: " + ended.how + " " + ended.words);
  const auto json = ordered_json::parse(ended.output);
  EngineProgram engine{std::move(command),
                       json.at("name"),
                       json.at("version"),
                       json.at("precision"),
                       json.at("plane"),
                       json.value("behind", "") == "WebAssembly",
                       {}};
  for (const auto& v : json.at("variants"))
    engine.variants.push_back({v.at("name"), v.at("says"), v.at("order"), v.at("defaults")});
  return engine;
}

// ---- what an engine does wrong beside the path ------------------------------------------------------------

}  // namespace

namespace engines {

namespace {

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

/// Energy is conserved in it.
bool conserves(const World& world) {
  return world.shaking == Vector{} && world.friction == 0 &&
         (world.floor == Vector{} || world.restitution == 1);
}

struct Energy {
  double kinetic = 0, potential = 0;
};

Energy energy(const World& world, const std::vector<State>& states) {
  Energy e;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& [mass, inertia, start, shape] = world.bodies[i];
    const State& s = states[i];
    const Vector w = turned(inverse(s.orientation), s.spin), swept = cross(world.turning, s.position);
    e.kinetic += mass * dot(s.velocity, s.velocity) / 2;
    for (std::size_t k = 0; k < 3; ++k) e.kinetic += inertia[k] * w[k] * w[k] / 2;
    e.potential -= mass * (dot(world.gravity, s.position) + dot(swept, swept) / 2);
  }
  for (const Spring& spring : world.springs) {
    const Vector along =
        Point(world, spring.b, spring.end).now(states) - Point(world, spring.a, spring.at).now(states);
    const double stretch = length(along) - spring.rest;
    e.potential += spring.stiffness * stretch * stretch / 2;
  }
  return e;
}

/// By how much it changes at most, as a part of the largest kinetic energy.
double energy_change(const World& world, const std::vector<std::vector<State>>& frames) {
  if (!conserves(world)) return nan;
  const Energy start = energy(world, frames.front());
  double change = 0, moving = 0;
  for (const auto& states : frames) {
    const Energy now = energy(world, states);
    change = std::max(change, std::abs(now.kinetic + now.potential - start.kinetic - start.potential));
    moving = std::max(moving, now.kinetic);
  }
  return moving > 0 ? change / moving : nan;
}

/// How far the joint's ends are apart, or a rod's length is off.
double off(const World& world, const Joint& joint, const std::vector<State>& states) {
  const Vector a = Point(world, joint.a, joint.at).now(states);
  if (joint.kind == Joint::rod)
    return std::abs(length(Point(world, joint.b, joint.end).now(states) - a) - length(joint.end - joint.at));
  const Vector apart = Point(world, joint.b, joint.at).now(states) - a;
  if (joint.kind != Joint::cylinder) return length(apart);
  return length(apart - dot(apart, joint.axis) * joint.axis);  // its axis does not turn
}

double off_joints(const World& world, const std::vector<std::vector<State>>& frames) {
  double most = 0;
  for (const auto& states : frames)
    for (const Joint& joint : world.joints) most = std::max(most, off(world, joint, states));
  return most;
}

}  // namespace

}  // namespace engines

namespace {

/// As run_program; what cannot even be started has failed too.
Ended answer(const std::vector<std::string>& command, const std::string& request,
             std::chrono::milliseconds limit, std::size_t most_memory) {
  try {
    return run_program(command, request, limit, most_memory);
  } catch (const std::system_error& error) {
    return {false, std::string("not started, ") + error.what(), "", ""};
  }
}

// ---- the path ---------------------------------------------------------------------------------------------

/// An angle alone is known up to whole turns: the one nearest to the truth.
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

Outcome outcome_of(const EngineTrial& trial, std::size_t frames, const EngineScene& contest) {
  if (static_cast<double>(frames) <= contest.need.frames()) return Outcome::non_finite;
  return trial.in_needs <= 1 ? Outcome::ok : Outcome::inaccurate;
}

void judge(EngineTrial& trial, const EngineScene& contest, const engines::Reply& reply) {
  trial.observed = observed(contest, reply.frames);
  trial.errors = contest.motion.errors(trial.observed);
  trial.in_needs = contest.motion.in_needs(trial.errors);
  trial.outcome = outcome_of(trial, reply.frames.size(), contest);
  trial.energy = engines::energy_change(contest.staging.world, reply.frames);
  trial.off_joint = engines::off_joints(contest.staging.world, reply.frames);
  std::vector<double> seconds = reply.seconds;
  std::ranges::sort(seconds);
  trial.seconds_per_frame = seconds[seconds.size() / 2] / contest.need.frames();
  trial.spread = (seconds.back() - seconds.front()) / contest.need.frames();
  trial.same_bits = reply.same_bits;
  trial.restored = reply.restored;
}

/// The law of the finest trials that show one: at least three, whose slopes agree within 0.15 from one to the
/// next, above thirty times the least error.
std::optional<PowerLaw> law_of(const EngineSeries& series) {
  std::vector<double> step, error;
  for (const EngineTrial& t : series.trials)
    if (std::isfinite(t.in_needs)) step.push_back(1.0 / t.steps_per_frame), error.push_back(t.in_needs);
  std::optional<PowerLaw> law;
  std::size_t longest = 2;
  for (std::size_t first = 0; first < step.size(); ++first)
    for (std::size_t last = first + longest; last < step.size(); ++last) {
      const std::span x = std::span(step).subspan(first, last - first + 1);
      const std::span y = std::span(error).subspan(first, x.size());
      const PowerLaw fitted = power_law(x, y);
      bool follows = fitted.exponent > 0.25;
      for (std::size_t i = 1; i < x.size(); ++i)
        follows = follows && std::abs(std::log2(y[i - 1] / y[i]) - fitted.exponent) < 0.15;
      if (follows) law = fitted, longest = last - first;
    }
  return law;
}

void summarize(EngineSeries& series) {
  series.floor = std::numeric_limits<double>::infinity();
  for (const EngineTrial& t : series.trials)
    if (t.in_needs < series.floor) series.floor = t.in_needs;
  series.law = law_of(series);
}

}  // namespace

std::vector<EngineProgram> engines_found(const fs::path& folder, const fs::path& source) {
  std::vector<std::vector<std::string>> commands;
  if (fs::is_directory(folder))
    for (const auto& file : fs::directory_iterator(folder))
      if (file.path().filename().string().starts_with("engine_") && file.path().extension().empty())
        commands.push_back({file.path().string()});
  const fs::path of_node = source / "solvers/engines";
  if (fs::is_directory(of_node / "node_modules"))
    for (const char* name : {"box2d", "jolt", "mujoco", "rapier"})
      if (fs::exists(of_node / (std::string(name) + ".mjs")))
        commands.push_back({"node", (of_node / "runner.mjs").string(), name});
  std::ranges::sort(commands);
  std::vector<EngineProgram> found;
  for (auto& command : commands) found.push_back(about(std::move(command)));
  std::ranges::sort(found, {}, [](const EngineProgram& e) { return std::pair(e.webassembly, e.name); });
  return found;
}

EngineTrial run(const EngineProgram& engine, const EngineVariant& variant, const EngineScene& contest,
                int steps_per_frame, const EngineTask& task) {
  EngineTrial trial{steps_per_frame};
  trial.in_needs = trial.energy = trial.off_joint = trial.seconds_per_frame = nan;
  const bool timed = steps_per_frame <= last_timed;
  const engines::Request request{contest.staging.world,
                                 variant.name,
                                 static_cast<int>(contest.need.frames()),
                                 contest.need.frames_per_second,
                                 steps_per_frame,
                                 timed ? task.timed : 1,
                                 steps_per_frame == 1};
  const bool native = !engine.webassembly;  // a WebAssembly engine reserves addresses that it does not use
  const Ended ended =
      answer(engine.command, nlohmann::json(request).dump(), milliseconds(task.limit), native ? memory : 0);
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

const EngineTrial* EngineSeries::first_enough() const {
  const EngineTrial* first = nullptr;
  for (auto t = trials.rbegin(); t != trials.rend() && t->outcome == Outcome::ok; ++t) first = &*t;
  return first;
}

namespace {

/// A variant on its way from coarse to fine.
struct Entrant {
  const EngineProgram* engine;
  const EngineVariant* variant;
  EngineSeries series;
};

/// Goes on with finer trials while they are at most `last` steps per frame.
void go_on(Entrant& entrant, const EngineScene& scene, int last, const EngineTask& task) {
  EngineSeries& series = entrant.series;
  if (!series.cannot.empty()) return;
  try {
    int steps = series.trials.empty() ? 1 : 2 * series.trials.back().steps_per_frame;
    for (; steps <= last; steps *= 2) {
      if (!series.trials.empty() && series.trials.back().outcome == Outcome::stalled) return;
      series.trials.push_back(run(*entrant.engine, *entrant.variant, scene, steps, task));
      if (steps > 1) series.trials.back().observed.clear();
    }
  } catch (const CannotBeHad& reason) {
    series.cannot = reason.what();
  }
}

std::vector<Entrant> entrants(const std::vector<EngineProgram>& programs) {
  std::vector<Entrant> all;
  for (const EngineProgram& e : programs)
    for (const EngineVariant& v : e.variants)
      all.push_back(
          {&e, &v, {e.name, e.version, e.precision, v.name, v.says, v.defaults, e.webassembly, v.order}});
  return all;
}

}  // namespace

EngineContest run(const std::vector<EngineProgram>& programs, const EngineScene& scene,
                  const EngineTask& task, const Progress& progress) {
  EngineContest result{
      scene.scene, scene.title, {}, scene.motion.needs, scene.need.horizon, scene.need.frames_per_second,
      {},          {}};
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
    summarize(one.series);
    result.series.push_back(std::move(one.series));
  }
  return result;
}

// ---- kept -------------------------------------------------------------------------------------------------

namespace {

/// Not a number is null.
ordered_json kept(double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); }
double number(const ordered_json& json) { return json.is_null() ? nan : json.get<double>(); }

ordered_json kept(const std::vector<double>& numbers) {
  ordered_json all = ordered_json::array();
  for (double x : numbers) all.push_back(kept(x));
  return all;
}
std::vector<double> numbers(const ordered_json& json) {
  std::vector<double> all;
  for (const auto& x : json) all.push_back(number(x));
  return all;
}

Outcome outcome_named(const std::string& name) {
  using enum Outcome;
  for (Outcome o : {ok, inaccurate, non_finite, stalled, raised})
    if (name_of(o) == name) return o;
  throw BadInput("there is no outcome '" + name + "'");
}

ordered_json kept(const EngineTrial& t) {
  return {{"steps_per_frame", t.steps_per_frame},
          {"outcome", name_of(t.outcome)},
          {"message", t.message},
          {"errors", kept(t.errors)},
          {"in_needs", kept(t.in_needs)},
          {"energy", kept(t.energy)},
          {"off_joint", kept(t.off_joint)},
          {"seconds_per_frame", kept(t.seconds_per_frame)},
          {"spread", kept(t.spread)},
          {"same_bits", t.same_bits},
          {"restored", t.restored},
          {"observed", kept(t.observed)}};
}
EngineTrial trial_from(const ordered_json& j) {
  return {j.at("steps_per_frame"),   outcome_named(j.at("outcome")),
          j.at("message"),           numbers(j.at("errors")),
          number(j.at("in_needs")),  number(j.at("energy")),
          number(j.at("off_joint")), number(j.at("seconds_per_frame")),
          number(j.at("spread")),    j.at("same_bits"),
          j.at("restored"),          numbers(j.at("observed"))};
}

ordered_json kept(const EngineSeries& s) {
  ordered_json trials = ordered_json::array();
  for (const EngineTrial& t : s.trials) trials.push_back(kept(t));
  return {{"engine", s.engine},
          {"version", s.version},
          {"precision", s.precision},
          {"variant", s.variant},
          {"says", s.says},
          {"defaults", s.defaults},
          {"webassembly", s.webassembly},
          {"stated_order", s.stated_order},
          {"cannot", s.cannot},
          {"trials", trials}};
}
EngineSeries series_from(const ordered_json& j) {
  EngineSeries s{j.at("engine"),   j.at("version"),     j.at("precision"),    j.at("variant"), j.at("says"),
                 j.at("defaults"), j.at("webassembly"), j.at("stated_order"), j.at("cannot")};
  for (const auto& t : j.at("trials")) s.trials.push_back(trial_from(t));
  summarize(s);
  return s;
}

}  // namespace

void write(const std::vector<EngineContest>& contests, const fs::path& file) {
  ordered_json all = ordered_json::array();
  for (const EngineContest& c : contests) {
    ordered_json series = ordered_json::array();
    for (const EngineSeries& s : c.series) series.push_back(kept(s));
    all.push_back({{"scene", c.scene},
                   {"title", c.title},
                   {"units", c.units},
                   {"needs", c.needs},
                   {"horizon", c.horizon},
                   {"frames_per_second", c.frames_per_second},
                   {"series", series},
                   {"least", c.least ? ordered_json{{"says", c.least->says},
                                                    {"errors", kept(c.least->errors)},
                                                    {"seconds_per_frame", kept(c.least->seconds_per_frame)}}
                                     : ordered_json(nullptr)}});
  }
  write_whole(file, all.dump(1) + "\n");
}

std::vector<EngineContest> read_engines(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw BadInput("cannot read " + file.string() + "; 'oddity engines' writes it");
  try {
    std::vector<EngineContest> contests;
    for (const auto& j : ordered_json::parse(in)) {
      EngineContest c{j.at("scene"),
                      j.at("title"),
                      j.at("units"),
                      j.at("needs"),
                      j.at("horizon"),
                      j.at("frames_per_second"),
                      {},
                      {}};
      for (const auto& s : j.at("series")) c.series.push_back(series_from(s));
      if (const auto& least = j.at("least"); !least.is_null())
        c.least =
            Instead{least.at("says"), numbers(least.at("errors")), number(least.at("seconds_per_frame"))};
      contests.push_back(std::move(c));
    }
    return contests;
  } catch (const nlohmann::json::exception& error) {
    throw BadInput(file.string() + ": not what 'oddity engines' writes: " + error.what());
  }
}

}  // namespace oddity
