#include "extras/bench/verbs.hpp"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/study/fit.hpp"
#include "report/study/run_program.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

VerbCost cost_of(const Words& words) {
  Words command{program_file().string()};
  VerbCost cost{"", 0, 0, 0, ""};
  command.insert(command.end(), words.begin(), words.end());
  for (const std::string& word : words) {
    if (word.starts_with("--")) break;
    if (!word.starts_with('/')) cost.words += (cost.words.empty() ? "" : " ") + word;
  }
  const auto start = std::chrono::steady_clock::now();
  const Ended ended = run_program(command, "", std::chrono::minutes(30));
  cost.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  cost.cpu_seconds = ended.cpu_seconds;
  cost.peak_bytes = ended.peak_bytes;
  if (!ended.ok) cost.failure = ended.how;
  return cost;
}

/// The commands. Those that write do so in the folder; `report` and `site` read the previous results.
std::vector<Words> verbs_to_run(const PassingFolder& folder) {
  return {{"list"},
          {"solve", "3.5"},
          {"verify", "[3.5]"},
          {"verify", "--results", folder / "results.json"},
          {"chart", "3.5", "--out", folder / "charts"},
          {"stability", "3.5", "--out", folder / "maps"},
          {"choose", "3.33", "--error", "1deg"},
          {"choose", "3.25", "--error", "1mm"},
          {"sweep", "plan", folder / "sweep", "3.5", "--model", "one angle", "--algorithm", "Runge-Kutta 4",
           "--over", "a=1deg..179deg:1000", "--over", "step=1ms..2.5s:1000", "--looks", "4"},
          {"sweep", "run", folder / "sweep"},
          {"sweep", "merge", folder / "sweep", "--out", folder / "sweep.csv"},
          {"report", "--out", folder / "report"},
          {"site", "--out", folder / "site"}};
}

/// CPU time; throws if the command fails, since a growth is measured on finished work only.
double cpu_seconds_of(const Words& words) {
  const VerbCost cost = cost_of(words);
  if (!cost.failure.empty()) throw std::runtime_error("oddity " + cost.words + " failed: " + cost.failure);
  return cost.cpu_seconds;
}

/// Every stride-th of the book's exercises, so that each part has some of all chapters.
std::string every(std::size_t stride) {
  std::string tags;
  for (std::size_t i = 0; i < registry().size(); i += stride)
    tags += (tags.empty() ? "[" : ",[") + to_string(registry()[i].number) + "]";
  return tags;
}

double trials_in(const std::string& results) {
  std::ifstream in(results);
  const auto found = nlohmann::json::parse(in);
  double trials = 0;
  for (const auto& exercise : found.at("exercises"))
    for (const auto& quantity : exercise.at("quantities"))
      trials += static_cast<double>(quantity.at("trials").size());
  return trials;
}

std::vector<Growth> growth_of_verify(const PassingFolder& folder) {
  Growth by_trials{"verify, by trials", {}, {}}, by_exercises{"verify, by exercises", {}, {}};
  for (const std::size_t stride : std::initializer_list<std::size_t>{16, 8, 4, 2, 1}) {
    const std::string results = folder / "part.json";
    const double seconds = cpu_seconds_of({"verify", every(stride), "--results", results});
    by_trials.amounts.push_back(trials_in(results));
    by_exercises.amounts.push_back(
        std::ceil(static_cast<double>(registry().size()) / static_cast<double>(stride)));
    by_trials.cpu_seconds.push_back(seconds);
    by_exercises.cpu_seconds.push_back(seconds);
  }
  return {by_trials, by_exercises};
}

Growth growth_of_sweeps(const PassingFolder& folder) {
  Growth growth{"sweep run --every-cell, by cells", {}, {}};
  for (const int side : {30, 60, 120, 240}) {
    const std::string sweep = folder / ("cells_" + std::to_string(side)), n = std::to_string(side);
    cpu_seconds_of({"sweep", "plan", sweep, "3.5", "--model", "one angle", "--algorithm", "Runge-Kutta 4",
                    "--over", "a=1deg..179deg:" + n, "--over", "step=5ms..500ms:" + n, "--looks", "20",
                    "--every-cell"});
    growth.amounts.push_back(static_cast<double>(side) * side);
    growth.cpu_seconds.push_back(cpu_seconds_of({"sweep", "run", sweep}));
  }
  return growth;
}

std::string megabytes(double bytes) { return format_significant(std::round(bytes / 1e6), 6) + " MB"; }

}  // namespace

double Growth::slope() const { return power_law(amounts, cpu_seconds).exponent; }

VerbsBench bench_verbs(const Progress& progress) {
  const PassingFolder folder;
  const std::vector<Words> all = verbs_to_run(folder);
  VerbsBench bench;
  for (const Words& words : all) {
    if (progress) progress("running each verb", static_cast<double>(bench.verbs.size()), all.size());
    bench.verbs.push_back(cost_of(words));
  }
  if (progress) progress("timing parts of the suite", 0, 2);
  bench.growth = growth_of_verify(folder);
  if (progress) progress("timing parts of the suite", 1, 2);
  bench.growth.push_back(growth_of_sweeps(folder));
  return bench;
}

std::string verbs_view(const VerbsBench& bench, const Screen& screen) {
  std::vector<std::vector<std::string>> rows{{"verb", "time", "CPU", "peak memory", ""}};
  for (const VerbCost& v : bench.verbs)
    rows.push_back(
        {v.words, shown_time(v.seconds), shown_time(v.cpu_seconds), megabytes(v.peak_bytes), v.failure});
  std::string text = wrapped("Each verb as a separate program, on all cores\n", screen) +
                     aligned(rows, screen, {{"verb"}, {}});
  for (const Growth& g : bench.growth) {
    text += wrapped("\n" + g.of + ": the CPU time grows as their number to the power " +
                        format_significant(g.slope(), 3) + "\n",
                    screen);
    std::vector<std::vector<std::string>> points{{"number", "CPU"}};
    for (std::size_t i = 0; i < g.amounts.size(); ++i)
      points.push_back({format_shortest(g.amounts[i]), shown_time(g.cpu_seconds[i])});
    text += aligned(points, screen, {});
  }
  return text;
}

Table verbs_table(const VerbsBench& bench) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Table table{{"part", "subject", "amount", "seconds", "cpu_seconds", "peak_bytes", "failure"}, {}};
  for (const VerbCost& v : bench.verbs)
    table.rows.push_back({"verb", v.words, none, v.seconds, v.cpu_seconds, v.peak_bytes, v.failure});
  for (const Growth& g : bench.growth)
    for (std::size_t i = 0; i < g.amounts.size(); ++i)
      table.rows.push_back({"growth", g.of, g.amounts[i], none, g.cpu_seconds[i], none, ""});
  return table;
}

}  // namespace oddity
