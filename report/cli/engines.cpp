#include "report/cli/engines.hpp"

#include <unistd.h>

#include <cctype>
#include <iostream>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/similar.hpp"
#include "report/cli/settings.hpp"
#include "report/cli/verbs.hpp"
#include "report/pages/engines_view.hpp"
#include "report/study/prices.hpp"
#include "report/study/progress.hpp"

namespace oddity::verbs {

namespace {

/// What a game asks.
Need game_need() {
  return {.error = degree, .errors = {{"m", centimeter}, {"rad", degree}}, .objective = Objective::simple};
}

std::vector<EngineProgram> all_engines() {
  std::vector<EngineProgram> programs = engines_found(engines_folder(), source_folder());
  if (programs.empty())
    throw BadInput("no engine is built here; './oddity engines' installs and builds them");
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
      choice.chosen->errors, choice.chosen->seconds_per_frame};
}

/// What `choose` takes for the scene, at the prices kept.
std::optional<Instead> instead(const Task& task, const Reference& truth, const Progress& progress) {
  KeptPrices prices(prices_folder(), price_key(task, game_need()), false);
  const Choice choice = oddity::choose(task, game_need(), truth, std::ref(prices), progress);
  prices.keep();
  return instead_of(choice);
}

/// These, and what earlier runs kept of other scenes, in the order in which all would run.
std::vector<EngineContest> with_earlier(const std::vector<EngineContest>& contests) {
  std::vector<EngineContest> earlier;
  if (fs::exists(engines_file())) earlier = read_engines(engines_file());
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

EngineContest engines_on(const std::string& scene, const std::vector<EngineProgram>& programs,
                         const EngineTask& asked, const Reference& truth, const Progress& progress) {
  if (!exercise_number(scene))
    return run(programs, further_engine_scene(scene, game_need()), asked, progress);
  const Task task = task_of(scene, {});
  EngineContest result = run(programs, engine_scene(task, game_need(), truth), asked, progress);
  result.least = instead(task, truth, progress);
  return result;
}

}  // namespace

std::vector<EngineProgram> engines_named(const std::string& name) {
  if (name.empty()) return {};
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

EngineContest beside(const Choice& choice, const std::vector<EngineProgram>& programs, const Task& task,
                     const Reference& truth) {
  EngineContest tried = with_progress([&](const Progress& progress) {
    return run(programs, engine_scene(task, choice.need, truth), {.finest = 64}, progress);
  });
  tried.least = instead_of(choice);
  return tried;
}

void engines(const fs::path& folder, const std::vector<std::string>& scenes, const std::vector<double>& rates,
             int finest, bool all, bool rows, const fs::path& page, Format format) {
  const std::vector<EngineProgram> programs = all_engines();
  std::vector<std::string> asked = scenes;
  if (asked.empty()) {
    asked = scenes_for_engines();
    std::erase(asked, "chain of 100");  // takes half an hour, and is there by its name
  }
  const Reference truth(folder, motions_folder());
  std::vector<EngineContest> contests, kept;
  for (const std::string& scene : asked) {
    contests.push_back(with_progress([&](const Progress& progress) {
      return engines_on(scene, programs, {.finest = finest}, truth, progress);
    }));
    kept = with_earlier(contests);
    write(kept, engines_file());  // the whole takes an hour: what is there is not lost
  }
  if (rows) {
    std::cout << engine_rows(contests);
    return;
  }
  const Screen screen = screen_of(STDOUT_FILENO);
  const auto table = [&] { return engines_table(contests); };
  std::cout << (format == Format::json  ? to_json(table())
                : format == Format::csv ? to_csv(table())
                                        : engines_text(contests, rates, all, screen));
  if (page.empty()) return;
  write_whole(page, engines_page(kept, rates, surprises_in(source_folder() / "solvers/engines/found")));
  std::cout << "the page is " << page.string() << "\n";
}

}  // namespace oddity::verbs
