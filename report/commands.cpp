#include "report/commands.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "reference/verdicts.hpp"
#include "report/bench.hpp"
#include "report/chart.hpp"
#include "report/choose.hpp"
#include "report/ledger.hpp"
#include "report/progress.hpp"
#include "report/run.hpp"
#include "report/settings.hpp"
#include "report/stability.hpp"
#include "report/text_view.hpp"
#include "report/write_report.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

std::string numbers_of_registry() {
  std::string numbers;
  for (const Entry& entry : registry()) numbers += (numbers.empty() ? "" : ", ") + to_string(entry.number);
  return numbers;
}

const Entry& entry_of(const std::string& text) {
  const auto number = exercise_number(text);
  for (const Entry& entry : registry())
    if (number == entry.number) return entry;
  throw BadInput("no exercise '" + text + "'; the exercises are: " + numbers_of_registry());
}

/// "a=2.5" set in the parameters.
void override_with(Parameters& parameters, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos) throw BadInput("'" + assignment + "' is not name=value");
  const auto value = number_in(std::string_view(assignment).substr(equals + 1));
  if (!value) throw BadInput("'" + assignment + "': '" + assignment.substr(equals + 1) + "' is not a number");
  parameters.set(assignment.substr(0, equals), *value);
}

void list(const fs::path& folder) {
  const Verdicts verdicts = read_verdicts(folder);
  for (const Entry& entry : registry()) {
    const std::string id = to_string(entry.number);
    const auto claims =
        std::ranges::count_if(verdicts, [&](const auto& row) { return row.first.starts_with(id + "-"); });
    std::cout << id << "  " << entry.exercise.title << (entry.exercise.scene ? " (scene)" : "") << ", "
              << claims << " claims\n";
    for (const Parameter& p : entry.exercise.parameters)
      std::cout << "      " << p.name << " = " << shortest(p.value) << (p.unit.empty() ? "" : " ") << p.unit
                << "  " << p.says << "\n";
  }
}

Task task_of(const std::string& exercise, const std::vector<std::string>& overrides) {
  Task task(entry_of(exercise));
  for (const std::string& assignment : overrides) override_with(task.parameters, assignment);
  return task;
}

void solve(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           bool json) {
  const Task task = task_of(exercise, overrides);
  const Reference truth(folder);
  const Results results = run(std::span(&task, 1), truth, true);
  std::cout << (json ? to_json(results) : text_view(results.exercises.front())) << std::flush;
}

/// 0 when something meets the need, else 1.
int choose(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           const Need& need) {
  const Choice choice = oddity::choose(task_of(exercise, overrides), need, Reference(folder));
  std::cout << choice_text(choice) << std::flush;
  return choice.chosen ? 0 : 1;
}

bool older(const fs::path& file, const fs::path& than) {
  return fs::last_write_time(file) < fs::last_write_time(than);
}

/// Older than the program or than a table.
bool stale(const fs::path& results, const fs::path& folder) {
  if (older(results, fs::read_symlink("/proc/self/exe"))) return true;
  for (const auto& table : fs::directory_iterator(folder))
    if (table.path().extension() == ".csv" && older(results, table)) return true;
  return false;
}

/// The last results where they are fresh, else those of a new run; with the ledgers, which a run of the suite
/// does not need and does not make.
Results last_results(const fs::path& folder) {
  const fs::path file = results_file();
  const Reference truth(folder);
  const std::vector<Task> tasks(registry().begin(), registry().end());
  ProgressBar bar;
  Results results = fs::exists(file) && !stale(file, folder)
                        ? read_results(file)
                        : with_stability(run(tasks, truth, true, bar.callback()), tasks, truth,
                                         read_limits(folder), bar.callback());
  if (std::ranges::any_of(results.exercises, [](const ExerciseResult& e) { return e.scene && !e.ledger; })) {
    results = with_ledgers(std::move(results), tasks, truth, bar.callback());
    write_whole(file, to_json(results));
  }
  return results;
}

void report(const fs::path& folder, int chapter, const fs::path& out) {
  if (chapter != 0 && std::ranges::none_of(chapters(), [&](const Chapter& c) { return c.number == chapter; }))
    throw BadInput("no chapter " + std::to_string(chapter) + "; the book has chapters 1 to 14");
  make_folder(out);
  const fs::path page = write_report(last_results(folder), chapter, out);
  std::cout << "the report is in " << page.string() << "\n";
}

void chart(const fs::path& folder, const std::vector<std::string>& exercises, const fs::path& out) {
  std::vector<Task> tasks;
  for (const Entry& entry : registry())
    if (exercises.empty()) tasks.emplace_back(entry);
  for (const std::string& exercise : exercises) tasks.emplace_back(entry_of(exercise));
  make_folder(out);
  ProgressBar bar;
  for (const fs::path& page : write_charts(run(tasks, Reference(folder), true, bar.callback()), out))
    std::cout << page.string() << "\n";
}

/// The exercises asked for, or all, of those that have a motion.
std::vector<Task> scenes(const std::vector<std::string>& exercises) {
  std::string numbers;
  for (const Entry& entry : registry())
    if (entry.exercise.scene) numbers += (numbers.empty() ? "" : ", ") + to_string(entry.number);
  std::vector<Task> tasks;
  for (const std::string& exercise : exercises) {
    tasks.emplace_back(entry_of(exercise));
    if (!tasks.back().entry->exercise.scene)
      throw BadInput("exercise " + exercise + " has no motion; those that have one are: " + numbers);
  }
  if (exercises.empty())
    for (const Entry& entry : registry())
      if (entry.exercise.scene) tasks.emplace_back(entry);
  return tasks;
}

void stability(const fs::path& folder, const std::vector<std::string>& exercises, bool rows,
               const fs::path& out) {
  const std::vector<Task> tasks = scenes(exercises);
  const Reference truth(folder);
  Results blank;
  for (const Task& task : tasks) {
    ExerciseResult& e = blank.exercises.emplace_back();
    e.number = task.entry->number;
    e.title = task.entry->exercise.title;
  }
  ProgressBar bar;
  const Results results = with_stability(blank, tasks, truth, read_limits(folder), bar.callback());
  if (rows) {
    std::cout << limit_rows(results) << "\n" << map_rows(results) << std::flush;
    return;
  }
  make_folder(out);
  std::vector<std::string> scripts;
  for (const ExerciseResult& e : results.exercises) {
    std::cout << stability_text(e) << "\n";
    scripts.push_back(map_script(e, (out / map_file(e)).string()));
  }
  draw(scripts);
  std::cout << "the maps are in " << (out / "charts").string() << "\n" << std::flush;
}

void time_all(const fs::path& folder) {
  ProgressBar bar;
  std::cout << bench_view(bench(Reference(folder), bar.callback())) << std::flush;
}

}  // namespace

int command_line(int argc, char** argv, const Suite& suite) {
  CLI::App app(
      "oddity: the solutions of Game Physics, 2nd edition, checked by machine.\n"
      "Without a verb: verify everything and write the report.",
      "oddity");
  app.set_version_flag("--version", version());
  std::string folder = reference_folder().string();
  app.add_option("--reference", folder, "folder of the reference tables")->capture_default_str();
  app.require_subcommand(0, 1);

  auto* list_verb = app.add_subcommand("list", "exercises, titles, parameters, number of claims");
  list_verb->footer("Example: oddity list");

  auto* verify_verb = app.add_subcommand("verify", "run the verification suite (Catch2) over all exercises");
  std::string results;
  verify_verb->add_option("--results", results, "also keep the results in this file, as JSON");
  verify_verb->allow_extras();
  verify_verb->footer(
      "All else goes to Catch2: a test specification and its options, its reporters and 'markdown'.\n"
      "Tags: [ch3] [3.5] [scene] [erratum] [misprint]. Catch2's own help: oddity verify -?\n"
      "Examples: oddity verify '[ch3]~[scene]'    oddity verify '[3.5]' -s    oddity verify -r markdown -o "
      "report.md");

  auto* solve_verb = app.add_subcommand("solve", "one exercise: every quantity by every method");
  std::string exercise;
  std::vector<std::string> overrides;
  bool json = false;
  solve_verb->add_option("exercise", exercise, "its number, such as 3.5")->required();
  solve_verb->add_option("overrides", overrides, "name=value for each parameter to change");
  solve_verb->add_flag("--json", json, "print the results as JSON");
  solve_verb->footer("Example: oddity solve 3.5 a=2.5");

  auto* choose_verb =
      app.add_subcommand("choose", "the cheapest model, algorithm and step that a need allows");
  Need need{0.01};
  int digits = 0;
  choose_verb->add_option("exercise", exercise, "its number, such as 3.33")->required();
  choose_verb->add_option("overrides", overrides, "name=value for each parameter to change");
  auto* absolute =
      choose_verb->add_option("--error", need.error, "largest error of the observables, in their unit");
  choose_verb->add_option("--digits", digits, "instead: right digits of the largest observable")
      ->excludes(absolute)
      ->check(CLI::Range(1, 15));
  choose_verb->add_option("--horizon", need.horizon, "how far ahead [s]")->capture_default_str();
  choose_verb->add_option("--fps", need.frames_a_second, "frames a second")->capture_default_str();
  choose_verb->add_option("--budget", need.budget, "most time a frame: 5us, 300ns, 0.1ms")
      ->transform(CLI::AsNumberWithUnit(
          std::map<std::string, double>{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}},
          CLI::AsNumberWithUnit::UNIT_REQUIRED));
  choose_verb->footer(
      "It is chosen on the start asked for and two beside it, and tested on three others. The exit code is 1 "
      "when nothing meets the need.\n"
      "Example: oddity choose 3.5 a=1 --error 1e-3 --horizon 10 --fps 60 --budget 5us");

  auto* report_verb =
      app.add_subcommand("report", "write the Markdown report, from the last results where they are fresh");
  int chapter = 0;
  std::string out = report_folder().string();
  report_verb->add_option("--chapter", chapter, "one chapter only");
  report_verb->add_option("--out", out, "folder to write to")->capture_default_str();
  report_verb->footer("Example: oddity report --chapter 3 --out /tmp/report");

  auto* chart_verb =
      app.add_subcommand("chart", "error against work and against time, drawn, with the tables");
  std::vector<std::string> charted;
  std::string charts = chart_folder().string();
  chart_verb->add_option("exercises", charted, "their numbers, such as 3.5; none: all");
  chart_verb->add_option("--out", charts, "folder to write to")->capture_default_str();
  chart_verb->footer("Example: oddity chart 3.5 2.13 --out /tmp/charts");

  auto* stability_verb =
      app.add_subcommand("stability", "where methods break: by step, and over a parameter");
  std::vector<std::string> moving;
  bool rows = false;
  std::string maps_out = report_folder().string();
  stability_verb->add_option("exercises", moving,
                             "their numbers, such as 3.5; all that have a motion if none");
  stability_verb->add_flag("--rows", rows, "print the rows of limits.csv and stability_maps.csv instead");
  stability_verb->add_option("--out", maps_out, "folder to draw the maps in")->capture_default_str();
  stability_verb->footer("Example: oddity stability 3.5 --out /tmp/maps");

  auto* bench_verb =
      app.add_subcommand("bench", "how fast this build is: loops by hand, best methods, the suite");
  bench_verb->footer("Times mean something only on an idle machine. Example: oddity bench");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }

  try {
    if (*list_verb) return list(folder), 0;
    if (*verify_verb) return suite({verify_verb->remaining(), folder, results});
    if (*solve_verb) return solve(folder, exercise, overrides, json), 0;
    if (*chart_verb) return chart(folder, charted, charts), 0;
    if (*bench_verb) return time_all(folder), 0;
    if (*choose_verb) {
      if (digits > 0) need.error = std::pow(10, -digits), need.relative = true;
      if (digits == 0 && absolute->empty()) throw BadInput("choose needs --error or --digits");
      return choose(folder, exercise, overrides, need);
    }
    if (*report_verb) return report(folder, chapter, out), 0;
    if (*stability_verb) return stability(folder, moving, rows, maps_out), 0;
    const int verdict = suite({{}, folder, results_file()});
    report(folder, 0, out);
    return verdict;
  } catch (const BadInput& error) {
    std::cerr << "oddity: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "oddity: internal error: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace oddity
