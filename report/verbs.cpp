#include "report/verbs.hpp"

#include <iostream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
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

namespace oddity::verbs {

namespace {

std::string numbers_of_registry() {
  std::string numbers;
  for (const Entry& entry : registry()) numbers += (numbers.empty() ? "" : ", ") + to_string(entry.number);
  return numbers;
}

std::string numbers_of_chapters() {
  std::string numbers;
  for (const Chapter& c : chapters()) numbers += (numbers.empty() ? "" : ", ") + std::to_string(c.number);
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

Task task_of(const std::string& exercise, const std::vector<std::string>& overrides) {
  Task task(entry_of(exercise));
  for (const std::string& assignment : overrides) override_with(task.parameters, assignment);
  return task;
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

}  // namespace

void list() {
  for (const Entry& entry : registry()) {
    std::cout << to_string(entry.number) << "  " << entry.exercise.title
              << (entry.exercise.scene ? " (scene)" : "") << (of_the_book(entry.number) ? "" : " (own)")
              << "\n";
    for (const Parameter& p : entry.exercise.parameters)
      std::cout << "      " << p.name << " = " << shortest(p.value) << (p.unit.empty() ? "" : " ") << p.unit
                << "  " << p.says << "\n";
  }
}

void solve(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           bool json) {
  const Task task = task_of(exercise, overrides);
  const Reference truth(folder);
  const Results results = run(std::span(&task, 1), truth, true);
  std::cout << (json ? to_json(results) : text_view(results.exercises.front())) << std::flush;
}

int choose(const fs::path& folder, const std::string& exercise, const std::vector<std::string>& overrides,
           const Need& need) {
  const Choice choice = oddity::choose(task_of(exercise, overrides), need, Reference(folder));
  std::cout << choice_text(choice) << std::flush;
  return choice.chosen ? 0 : 1;
}

void report(const fs::path& folder, int chapter, const fs::path& out) {
  if (chapter != 0 && std::ranges::none_of(chapters(), [&](const Chapter& c) { return c.number == chapter; }))
    throw BadInput("no chapter " + std::to_string(chapter) + "; the chapters are " + numbers_of_chapters());
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

void bench(const fs::path& folder) {
  ProgressBar bar;
  std::cout << bench_view(oddity::bench(Reference(folder), bar.callback())) << std::flush;
}

}  // namespace oddity::verbs
