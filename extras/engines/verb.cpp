#include "extras/engines/verb.hpp"

#include <cctype>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "chapters/scene.hpp"
#include "extras/engines/contest.hpp"
#include "extras/engines/page.hpp"
#include "extras/engines/view.hpp"
#include "problem/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/cli/verb.hpp"
#include "report/study/in_time.hpp"
#include "report/study/prices.hpp"
#include "report/study/progress.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace {

namespace fs = std::filesystem;
using verbs::Format, verbs::output;

/// The programs of the native engines.
fs::path engines_folder() {
  return (own_tree().empty() ? own_code() : program_file().parent_path()) / "engines";
}
/// The engines in JavaScript and their runner.
fs::path adapters_folder() {
  return own_tree().empty() ? engines_folder() : own_tree() / "extras/engines/adapters";
}
/// Programs that show the surprises found in engines.
fs::path surprises_folder() {
  return own_tree().empty() ? own_data() / "engines/found" : own_tree() / "extras/engines/adapters/found";
}

Need simple_need() {
  Need need = game_need();
  need.objective = Objective::simple;
  return need;
}

std::vector<EngineProgram> all_engines() {
  std::vector<EngineProgram> programs = engines_found(engines_folder(), adapters_folder());
  if (programs.empty())
    throw BadInput("no engine is built here; " + where_to_build() +
                   "'./oddity engines' installs and builds them");
  return programs;
}

std::vector<std::string> scenes_for_engines() {
  std::vector<std::string> scenes;
  for (const Entry& entry : registry())
    if (has_engine_scene(entry)) scenes.push_back(to_string(entry.number));
  for (std::string& name : further_engine_scenes()) scenes.push_back(std::move(name));
  return scenes;
}

std::optional<Instead> instead_of(const Choice& choice) {
  if (!choice.chosen) return {};
  const std::string setting = shown_setting(*choice.chosen, choice.need);
  return Instead{
      choice.chosen->model + " by " + choice.chosen->algorithm + (setting == "-" ? "" : ", " + setting),
      choice.chosen->errors, choice.chosen->seconds_per_frame, choice.chosen->by};
}

/// The model that `choose` takes for the scene, at the prices kept.
std::optional<Instead> instead(const Task& task, const Need& need, const Reference& truth,
                               const Progress& progress) {
  KeptPrices prices(prices_folder(), price_key(task, need), false);
  const Choice choice = choose(task, need, truth, std::ref(prices), progress);
  prices.keep();
  return instead_of(choice);
}

std::vector<EngineContest> kept_engines() {
  return fs::exists(engines_file()) ? read_engines(engines_file()) : std::vector<EngineContest>();
}

/// These, and the kept results of other scenes, in the order in which all would run.
std::vector<EngineContest> with_earlier(const std::vector<EngineContest>& contests) {
  const std::vector<EngineContest> earlier = kept_engines();
  std::vector<EngineContest> all;
  for (const std::string& scene : scenes_for_engines())
    for (const auto* some : {&contests, &std::as_const(earlier)}) {
      const auto found = std::ranges::find(*some, scene, &EngineContest::scene);
      if (found == some->end()) continue;
      all.push_back(*found);
      break;
    }
  return all;
}

/// Runs the algorithms that engines and their critics name, at the steps that engines are tried with.
std::vector<OwnSteps> own_steps(const Task& task, const Reference& truth) {
  const Need need = simple_need();
  const std::vector<Start> start{InitialConditions(task, need, truth).asked()};
  std::vector<OwnSteps> all{{"symplectic Euler", {}}, {"Runge-Kutta 4", {}}};
  for (auto& [algorithm, errors] : all)
    for (int steps = 1; steps <= EngineTask{}.finest; steps *= 2) {
      double least = std::numeric_limits<double>::infinity();
      for (const Method& method : start.front().motion.methods)
        if (method.algorithm == algorithm)
          least = std::min(least, evaluate(start, method, 1 / (need.frames_per_second * steps), need).error);
      errors.emplace_back(steps, least);
    }
  return all;
}

std::vector<fs::path> write_pictures(const std::vector<EngineContest>& contests, const OwnByScene& own,
                                     const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& pictures : {engine_pictures(contests, own), engine_pictures_of_times(contests)})
    for (const auto& [name, svg] : pictures) {
      files.push_back(folder / name);
      write_whole(files.back(), svg);
    }
  return files;
}

void write_page(const std::vector<EngineContest>& contests, const Reference& truth, const fs::path& page) {
  OwnByScene own;
  for (const EngineContest& c : contests)
    if (exercise_number(c.scene)) own[c.scene] = own_steps(task_of(c.scene, {}), truth);
  write_pictures(contests, own, page.parent_path());
  for (const auto& [name, csv] : engine_trials(contests)) write_whole(page.parent_path() / name, csv);
  const fs::path programs = surprises_folder();
  write_whole(page,
              engines_page(contests, surprises_in(programs),
                           programs.lexically_proximate(fs::absolute(page).parent_path()).generic_string()));
  std::cerr << "the page is " << page.string() << "\n";
}

/// Options of the command line.
struct AskedEngines : Formats {
  std::vector<std::string> scenes = {};  ///< numbers or names, or one exercise with other parameters; none:
                                         ///< all
  std::string rates = "60,240";          ///< 1/s, of the table
  int finest = 32;                       ///< steps per frame
  bool all = false;                      ///< every variant
  bool rows = false;                     ///< prints the rows of the approved records instead
  bool kept = false;                     ///< shows the results kept of earlier runs; runs nothing
  bool page = false;                     ///< writes the page as well
  std::string horizon = {};              ///< exercises only; empty: their own
  AskedNeed need = {};                   ///< its errors and criteria, of exercises
  std::string time_limit = "none";       ///< per scene
};

/// The unusual settings of an exercise: other parameters, another horizon, another tolerance.
struct AskedScenes {
  WithOverrides words;
  std::string horizon;
  AskedNeed need;

  std::string first_option() const { return horizon.empty() ? accuracy_option(need) : "--horizon"; }
  /// Whether exercises run unmodified, to the default accuracy. A problem's file does not count.
  bool is_usual() const {
    return words.overrides.empty() && first_option().empty() &&
           std::ranges::none_of(words.exercises, problem::is_file);
  }

  /// A centimetre and a degree, unless another error or criterion is requested.
  Need of(const std::string& scene, const Task& task) const {
    AskedNeed all = need;
    all.rate_is_given = true;  // engines are tried at 60 Hz and finer
    all.horizon_is_given = !horizon.empty();
    if (!horizon.empty()) all.horizon = horizon;
    if (problem::is_file(scene)) ask_as_file(all, *task.entry);
    all.as_engines = true;
    all.time_limit = "none";
    return need_of(task, all);
  }
};

/// Whether it names an exercise or a problem's file, and no scene of engines alone.
bool is_task(const std::string& scene) {
  return problem::is_file(scene) || exercise_number(scene).has_value();
}

EngineContest engines_on(const std::string& scene, const AskedScenes& words,
                         const std::vector<EngineProgram>& programs, const EngineTask& asked,
                         const Reference& truth, const Progress& progress) {
  if (!is_task(scene)) return run(programs, further_engine_scene(scene, simple_need()), asked, progress);
  const Task task = task_of(scene, words.words.overrides);
  const Need need = words.is_usual() ? simple_need() : words.of(scene, task);
  EngineContest result = run(programs, engine_scene(task, need, truth), asked, progress);
  result.least = instead(task, need, truth, progress);
  return result;
}

/// Engines whose names begin with this, ignoring case. Throws BadInput if no name does.
std::vector<EngineProgram> engines_named(const std::string& name) {
  const auto lower = [](std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  };
  std::vector<EngineProgram> programs = all_engines();
  std::vector<std::string> names;
  for (const EngineProgram& e : programs) names.push_back(e.name);
  std::erase_if(programs, [&](const EngineProgram& e) { return !lower(e.name).starts_with(lower(name)); });
  if (programs.empty()) throw BadInput("there is no engine '" + name + "'" + did_you_mean(name, names));
  return programs;
}

/// Runs the engines of this name on the scene of a choice, with its tolerance.
OtherEngines::Answers beside(const std::string& name, const Task& task) {
  return [task, programs = engines_named(name)](const Choice& choice, const Reference& truth) {
    EngineContest tried = with_progress([&](const Progress& progress) {
      return run(programs, engine_scene(task, choice.need, truth), {.finest = 64}, progress);
    });
    tried.least = instead_of(choice);
    return OtherEngines::Answer{engine_answer(tried, output()), to_json(engines_table({tried}))};
  };
}

/// Any of these engines that is installed is judged.
Needs needs_of_engines() {
  return {{"libode-dev", "libbullet-dev", "libbox2d-dev", "libchipmunk-dev", "libmujoco-dev",
           "libsimbody-dev", "libdart-dev"},
          {"extras/engines/adapters"},
          {"engines"}};
}

/// Checked before anything runs, since that may take minutes.
void require_scenes(const std::vector<std::string>& scenes) {
  const std::vector<std::string> all = scenes_for_engines();
  for (const std::string& scene : scenes)
    if (problem::is_file(scene))
      require_engine_scene(entry_of(scene));
    else if (std::ranges::find(all, scene) == all.end())
      throw BadInput("engines have no scene '" + scene + "'" + did_you_mean(scene, all) +
                     "; those that they have are: " + joined(all));
}

/// Nothing is tried at other rates.
void require_rates(const std::vector<double>& rates) {
  for (double rate : rates) {
    const double doublings = std::log2(rate / 60);
    if (!(doublings >= 0 && doublings <= 12) || doublings != std::round(doublings))
      throw BadInput("--hz: engines are tried at 60 Hz, 120, 240 and so on, and not at " +
                     format_shortest(rate));
  }
}

/// Runs the requested scenes in order. Each result is kept as soon as it is there, unless it has other
/// parameters or another horizon.
std::vector<EngineContest> engines_run(const AskedEngines& asked, const AskedScenes& words,
                                       const std::vector<std::string>& scenes, const Reference& truth) {
  const double limit = time_limit_of(asked.time_limit);
  kept_engines();  // refuses an unreadable file before anything runs
  const std::vector<EngineProgram> programs = all_engines();
  std::vector<EngineContest> contests;
  for (const std::string& scene : scenes) {
    contests.push_back(in_time(limit, "a lower --finest", [&] {
      return with_progress([&](const Progress& progress) {
        return engines_on(scene, words, programs, {.finest = asked.finest}, truth, progress);
      });
    }));
    if (words.is_usual()) write(with_earlier(contests), engines_file());
  }
  return contests;
}

/// The requested scenes from the results of earlier runs.
std::vector<EngineContest> engines_kept(const std::vector<std::string>& scenes) {
  std::vector<EngineContest> contests = read_engines(engines_file());
  std::erase_if(contests, [&](const EngineContest& c) { return std::ranges::count(scenes, c.scene) == 0; });
  return contests;
}

/// Charts of the kept results of the tasks' scenes, with the exercises' own parameters.
std::vector<fs::path> draw_engines(const std::vector<Task>& tasks, const Reference& truth,
                                   const fs::path& folder) {
  const std::vector<EngineContest> kept = kept_engines();
  OwnByScene own;
  std::vector<EngineContest> asked;
  for (const Task& task : tasks)
    for (const EngineContest& contest : kept)
      if (contest.scene == to_string(task.entry->number)) {
        asked.push_back(contest);
        own[contest.scene] = own_steps(Task(*task.entry), truth);
      }
  return asked.empty() ? std::vector<fs::path>() : write_pictures(asked, own, folder);
}

std::vector<double> rates_of(const std::string& text) {
  std::vector<double> rates;
  for (const std::string& rate : listed("--hz", text)) rates.push_back(value_of("--hz", rate, "1/s"));
  return rates;
}

void run_engines(const fs::path& folder, const AskedEngines& asked) {
  const std::vector<double> rates = rates_of(asked.rates);
  const fs::path page = asked.page ? to_write_to(report_folder()) / "engines.md" : fs::path();
  const AskedScenes words{with_overrides(asked.scenes), asked.horizon, asked.need};
  std::vector<std::string> scenes = words.words.exercises;
  const std::string option = words.first_option();
  if (!option.empty() && std::ranges::none_of(scenes, is_task))
    throw BadInput(option + " is of an exercise: name one, such as 3.5");
  if (!words.is_usual() && (asked.kept || asked.page))
    throw BadInput("--kept and --report take the exercises as they are: leave '" +
                   (!words.words.overrides.empty() ? words.words.overrides.front()
                    : !option.empty()              ? option
                                                   : scenes.front()) +
                   "' out");
  if (scenes.empty()) {
    scenes = scenes_for_engines();
    if (!asked.kept) std::erase(scenes, "chain of 100");  // only if requested by name
  }
  require_scenes(scenes);
  require_rates(rates);
  time_limit_of(asked.time_limit);
  if (!words.is_usual())
    for (const std::string& scene : scenes)
      if (is_task(scene)) words.of(scene, task_of(scene, words.words.overrides));
  if (needs_are_all(asked.kept ? Needs() : needs_of_engines())) return;
  const Reference truth(folder, motions_folder());
  const std::vector<EngineContest> contests =
      asked.kept ? engines_kept(scenes) : engines_run(asked, words, scenes, truth);
  if (asked.rows) {
    std::cout << engine_rows(contests);
    return;
  }
  const auto table = [&] { return engines_table(contests); };
  std::cout << (asked.format() == Format::json  ? to_json(table())
                : asked.format() == Format::csv ? to_csv(table())
                                                : engines_text(contests, rates, asked.all, output()));
  if (asked.page) write_page(with_earlier(contests), truth, page);
}

}  // namespace

void add_engines(const CommandLine& line) {
  const auto asked = std::make_shared<AskedEngines>();
  auto* engines = add_verb(
      line.app, "engines", "Run third-party physics engines on the scenes, and compare them with the models.",
      "Each engine that is built runs as a separate program, at 60 steps a second and finer by doubling. It is "
      "judged at every frame over 10 s: to 1 cm and 1 degree. In oddity's sources './oddity engines' installs and "
      "builds them.\n"
      "Columns: scene, engine, version, precision, variant, webassembly (1 or 0), hz, outcome, error, unit, "
      "in_needs, energy, momentum, off_joint, seconds_per_frame, spread, same_bits (1 or 0), restored, and off_energy, "
      "off_period, off_constraint or off_bounded where that is asked for; a row for each trial and unit.\n"
      "Examples:\n  oddity engines\n  oddity engines 3.33 'free body' --hz 60,240,960\n  oddity engines 3.5 a=60deg --horizon 30\n"
      "  oddity engines 3.5 --criterion energy --error 5%",
      [line, asked] { run_engines(line.reference, *asked); }, true);
  engines->add_option(
      "scene", asked->scenes,
      "exercises, a problem's file with [staged], or: free body, bouncing ball, box on corners, chain of 10, chain of 100. Default: "
      "all except the last, which takes long. Behind one exercise, name=value for each parameter to change");
  auto* horizon = add_value(*engines, "--horizon", asked->horizon, "TIME",
                            "how long the motion of an exercise is watched, instead of 10 s");
  add_value(*engines, "--error", asked->need.error, "ERROR",
            "an exercise's largest error, instead of 1cm and 1deg; for energy and period a fraction, 1%");
  add_criteria(*engines, asked->need);
  add_time_limit(*engines, asked->time_limit, ", for each scene");
  add_value(*engines, "--hz", asked->rates, "RATES", "the rates to show")->capture_default_str();
  add_count(*engines, "--finest", asked->finest, 1, 4096, "steps per frame to go to, by doubling");
  engines->add_flag("--all", asked->all, "every variant, not the defaults and the best of each engine");
  auto* rows = engines->add_flag("--rows", asked->rows, "print the rows of engines.csv instead");
  engines->add_flag("--kept", asked->kept, "show results kept from earlier runs, and run nothing");
  engines->add_flag("--report", asked->page, "write the page engines.md of the report");
  add_formats(*engines, *asked, "every trial");
  set_apart(*engines, rows, {"--json", "--csv", "--report"});
  set_apart(*engines, horizon, {"--kept", "--report"});
}

OtherEngines other_engines() { return {further_engine_scenes, require_engine_scene, beside, draw_engines}; }

}  // namespace oddity
