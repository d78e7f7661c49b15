#include "extras/sweep/verb.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numeric>
#include <thread>

#include "chapters/scene.hpp"
#include "extras/sweep/merge.hpp"
#include "extras/sweep/ranks.hpp"
#include "problem/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/quantity_text.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/charts/chart_parts.hpp"
#include "report/cli/verb.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/progress.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace {

namespace fs = std::filesystem;
using sweep::Plan;

struct Words {
  const std::string& reference;
  std::string folder = {}, exercise = {}, model = {}, algorithm = {}, setting = {}, chunk_time = "60s";
  std::vector<std::string> overrides = {}, over = {}, others = {};
  AskedNeed need = {};
  bool every_cell = false, json = false, csv = false, overwrite = false;
  const CLI::App* plan = nullptr;
  int looks = 0, threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency())), slurm = 0;
  std::string shard = {}, out = {}, shown = "outcome";
};

// ---- plan -------------------------------------------------------------------------------------------------

/// "a=1deg..179deg:1000", "step=1ms..0.1:500", "g=0.1..100:50:log".
sweep::Axis axis_of(const Task& task, const std::string& text) {
  const auto equals = text.find('='), dots = text.find(".."), colon = text.find(':');
  if (equals == std::string::npos || dots == std::string::npos || colon == std::string::npos ||
      dots > colon || equals > dots)
    throw BadInput("--over '" + text + "' is not NAME=FROM..TO:COUNT, as in a=1deg..179deg:1000");
  sweep::Axis axis{text.substr(0, equals), ""};
  const bool setting = axis.name == "step" || axis.name == "tolerance";
  std::vector<std::string> names{"step", "tolerance"};
  for (const Parameter& p : task.parameters.declared()) {
    names.emplace_back(p.name);
    if (p.name == axis.name) axis.unit = p.unit;
  }
  if (std::ranges::find(names, axis.name) == names.end())
    throw BadInput("--over: no parameter '" + axis.name + "'" + did_you_mean(axis.name, names));
  if (axis.name == "step") axis.unit = task.entry->exercise.scene->axes.time;
  const std::string over = "--over " + axis.name;
  axis.from = value_of(over, text.substr(equals + 1, dots - equals - 1), axis.unit);
  axis.to = value_of(over, text.substr(dots + 2, colon - dots - 2), axis.unit);
  std::string count = text.substr(colon + 1);
  axis.by_factor = setting || count.ends_with(":log");
  if (count.ends_with(":log")) count.resize(count.size() - 4);
  axis.count = count_of(over + ": the number of cells", count, 2, 1'000'000);
  const double cell = axis.by_factor ? axis.from * std::expm1(std::log(axis.to / axis.from) / axis.count)
                                     : (axis.to - axis.from) / axis.count;
  if (axis.from + cell == axis.from || axis.to - cell == axis.to)
    throw BadInput(over + ": " + count + " cells between " + format_shortest(axis.from) + " and " +
                   format_shortest(axis.to) + " are too narrow for double precision");
  return axis;
}

/// Refuses a second value for a number that is swept.
void require_once(const Words& w, const std::vector<sweep::Axis>& axes) {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const bool setting = axes[i].name == "step" || axes[i].name == "tolerance";
    if (setting && !w.setting.empty())
      throw BadInput("--setting " + w.setting + " and --over '" + w.over[i] + "' both set the " +
                     axes[i].name + ": leave one of them out");
    for (const std::string& given : w.overrides)
      if (given.starts_with(axes[i].name + "="))
        throw BadInput("'" + given + "' and --over '" + w.over[i] + "' both set " + axes[i].name +
                       ": leave one of them out");
  }
}

/// A step has the unit of time, a tolerance has none.
double setting_of(const Task& task, const Words& w) {
  const Scene& scene = *task.entry->exercise.scene;
  const Quantity seen = motion(scene, task.parameters, Reference::nothing());
  const Method* method = method_of(seen, w.model, w.algorithm);  // null: reported for the whole plan
  return value_of("--setting", w.setting, method && method->resolution.name != "step" ? "" : scene.axes.time);
}

sweep::Asked asked_of(const Words& w) {
  const bool of_file = problem::is_file(w.exercise);
  const Task task = task_of(w.exercise, w.overrides);
  if (!task.entry->exercise.scene)
    throw BadInput((of_file ? "" : "exercise ") + w.exercise + " has no motion to sweep over");
  if (w.model.empty() != w.algorithm.empty())
    throw BadInput("--model and --algorithm go together; without both, a method is chosen at every cell");
  if (w.model.empty() && !w.setting.empty())
    throw BadInput("--setting '" + w.setting +
                   "' is a method's: name it by --model and --algorithm; without both, 'choose' takes the "
                   "setting at every cell");
  sweep::Asked asked;
  asked.exercise = of_file ? problem::source_of(*task.entry).name : to_string(task.entry->number);
  if (of_file) asked.problem = problem::source_of(*task.entry).text;
  asked.model = w.model;
  asked.algorithm = w.algorithm;
  for (const Parameter& p : task.parameters.declared())
    asked.parameters.emplace_back(p.name, task.parameters[p.name]);
  AskedNeed need = w.need;
  need.horizon_is_given = w.plan->get_option("--horizon")->count() > 0;
  need.rate_is_given = w.plan->get_option("--fps")->count() > 0;
  if (of_file) ask_as_file(need, *task.entry);
  need.time_limit = "none";
  if (need.criterion != "path" && !w.model.empty())
    throw BadInput(
        "--criterion '" + need.criterion +
        "' applies to the method chosen at each cell: leave --model and --algorithm out; a named method "
        "is judged by its path");
  if (need.criterion != "path" && need.criterion != "bounded" && need.error.empty())
    throw BadInput("--criterion " + need.criterion + " needs --error");
  if (need.error.empty() && need.criterion == "path") need.error = "1";
  asked.need = need_of(task, need);
  const Scene& scene = *task.entry->exercise.scene;
  if (w.need.error.empty() && need.criterion == "path" && !of_file)
    for (std::string_view unit : motion(scene, task.parameters, Reference::nothing()).units())
      asked.need.errors[std::string(unit)] = game_error(unit);
  asked.looks = w.looks;
  asked.every_cell = w.every_cell;
  asked.frames = frames_of(need, std::string(scene.axes.time));
  asked.kick = need.kick;
  set_frames_and_kicks(asked);
  for (const std::string& text : w.over) asked.axes.push_back(axis_of(task, text));
  require_once(w, asked.axes);
  // The method's setting goes upward, so that the cells of a column share their reference.
  if (asked.axes.size() == 2 && (asked.axes[0].name == "step" || asked.axes[0].name == "tolerance"))
    std::swap(asked.axes[0], asked.axes[1]);
  if (!w.setting.empty()) asked.setting = setting_of(task, w);
  return asked;
}

std::string duration(double seconds) {
  if (seconds < 90) return format_significant(seconds, 2) + " s";
  if (seconds < 5400) return format_significant(seconds / 60, 2) + " min";
  return seconds < 100 * 3600 ? format_significant(seconds / 3600, 2) + " h"
                              : format_significant(seconds / 86400, 3) + " days";
}

double sum(const std::vector<double>& seconds) {
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

std::string cells_of(const Plan& plan) {
  return with_commas(static_cast<long>(plan.width()) * plan.height()) + " cells in " +
         with_commas(static_cast<long>(plan.chunks())) + (plan.chunks() == 1 ? " chunk" : " chunks");
}

/// A note on shortened steps, which the map's axis does not show; empty up to a hundredth.
std::string shortened_steps(const sweep::Asked& asked) {
  constexpr double unnoticed = 0.01;
  const double part = sweep::most_shortened(asked);
  if (part <= unnoticed) return "";
  const Scene& scene = *sweep::entry_of(asked).exercise.scene;
  return "a step is shortened so that a whole number of them fills the " +
         format_significant(sweep::between_looks(asked), 3) + " " + std::string(scene.axes.time) +
         " between looks: by up to " + format_significant(100 * part, 2) + " %\n";
}

const Needs for_hdf5{{"libhdf5-dev"}, {}, {"oddity"}};

void make_plan(const Words& w) {
  const fs::path folder = w.folder;
  if (fs::exists(folder / "chunks") && !fs::is_empty(folder / "chunks"))
    throw BadInput(folder.string() + " has chunks of a sweep already: take another folder, or remove it");
  const double seconds = between("--chunk-time", w.chunk_time, "s", 1e-6, 1e6);
  const Plan plan = sweep::planned(asked_of(w), Reference(w.reference), w.reference, seconds);
  take_folder(folder, w.overwrite);
  // A program that is rebuilt for the merge would not match the plan.
  if (needs_are_all(for_hdf5)) return;
  write_whole(sweep::plan_file(folder), to_json(plan));
  std::cout << sweep::plan_file(folder).string() << ": " << cells_of(plan) << ", about "
            << duration(sum(plan.seconds)) << " on one thread\n"
            << shortened_steps(plan.asked) << program_as_typed() << " sweep run "
            << for_shell(folder.string()) << "\n";
}

// ---- run --------------------------------------------------------------------------------------------------

Plan plan_in(const Words& w) { return sweep::read_plan(sweep::plan_file(w.folder), w.reference); }

std::string how_far(const Plan& plan, const std::vector<std::size_t>& missing, const fs::path& folder) {
  const std::size_t all = plan.chunks(), done = all - missing.size();
  const std::string sweep = program_as_typed() + " sweep ", there = for_shell(folder.string());
  if (missing.empty())
    return "all " + with_commas(static_cast<long>(all)) + " chunks are there\n" + sweep + "merge " + there +
           "\n" + sweep + "draw " + there + "\n";
  double left = 0;
  for (std::size_t chunk : missing) left += plan.seconds[chunk];
  return with_commas(static_cast<long>(done)) + " of " + with_commas(static_cast<long>(all)) +
         " chunks are there; about " + duration(left) + " on one thread left\n" + sweep + "run " + there +
         "\n";
}

void print_slurm(const Words& w, const Plan& plan) {
  const double longest = *std::ranges::max_element(plan.seconds);
  const std::string reference = fs::path(w.reference) == reference_folder()
                                    ? ""
                                    : "--reference " + for_shell(fs::absolute(w.reference).string()) + " ";
  const double minutes = 2 * (sum(plan.seconds) / w.slurm + longest) / 60 + 1;  // a margin, as estimates have
                                                                                // errors
  std::cout
      << "#!/bin/bash\n#SBATCH --job-name=oddity-sweep\n#SBATCH --array=1-" << w.slurm
      << "\n#SBATCH --cpus-per-task=1\n#SBATCH --time=" << static_cast<long>(std::ceil(minutes))
      << "\n# The folder has to be one that all machines see; chunks that are there already are not made again.\n"
      << (own_tree().empty() ? "oddity" : for_shell(program_file().string())) << " " << reference
      << "sweep run " << for_shell(fs::absolute(w.folder).string())
      << " --threads 1 --shard \"$SLURM_ARRAY_TASK_ID/" << w.slurm << "\"\n";
}

void run_by_mpi(const Words& w, const Plan& plan) {
  const Reference truth(w.reference);
  std::vector<std::size_t> left = sweep::missing(w.folder, plan);
  std::ranges::reverse(left);
  const auto next = [&]() -> std::optional<std::size_t> {  // only on the first rank
    if (left.empty()) return {};
    const std::size_t chunk = left.back();
    left.pop_back();
    return chunk;
  };
  const bool first = sweep::dealt_by_mpi(next, [&](std::size_t chunk) {
    keep(w.folder, plan, chunk, worked_out(plan, chunk, sweep::looks_at(plan.asked, truth)));
  });
  if (first) std::cout << how_far(plan, sweep::missing(w.folder, plan), w.folder);
}

void run_chunks(const Words& w) {
  const Plan plan = plan_in(w);
  if (w.slurm > 0) return print_slurm(w, plan);
  require_writable_folder(fs::path(w.folder) / "chunks");
  if (sweep::under_mpirun() && w.shard.empty()) return run_by_mpi(w, plan);
  std::vector<std::size_t> chunks = sweep::missing(w.folder, plan);
  if (!w.shard.empty()) chunks = sweep::dealt(plan, chunks, shard_of(w.shard));
  with_progress([&](const Progress& progress) {
    sweep::work_through(w.folder, plan, chunks, w.threads, Reference(w.reference), progress);
    return 0;
  });
  std::cout << how_far(plan, sweep::missing(w.folder, plan), w.folder);
}

// ---- results --------------------------------------------------------------------------------------------

void status(const Words& w) {
  const Plan plan = plan_in(w);
  const auto missing = sweep::missing(w.folder, plan);
  if (!w.json && !w.csv) {
    std::cout << cells_of(plan) << "; " << how_far(plan, missing, w.folder);
    return;
  }
  Table table{{"chunk", "tiles", "estimated seconds", "there"}, {}};
  for (std::size_t chunk = 0; chunk < plan.chunks(); ++chunk)
    table.rows.push_back({static_cast<long>(chunk), plan.first_tile[chunk + 1] - plan.first_tile[chunk],
                          plan.seconds[chunk],
                          static_cast<long>(std::ranges::find(missing, chunk) == missing.end())});
  std::cout << (w.json ? to_json(table) : to_csv(table));
}

sweep::Map map_of(const Words& w) {
  std::vector<fs::path> folders{w.folder};
  folders.insert(folders.end(), w.others.begin(), w.others.end());
  return sweep::merged(plan_in(w), folders);
}

fs::path output_of(const Words& w, const char* usual) {
  return w.out.empty() ? fs::path(w.folder) / usual : fs::path(w.out);
}

void merge(const Words& w) {
  const fs::path out = output_of(w, "map.h5");
  if (out.extension() != ".h5" && out.extension() != ".csv")
    throw BadInput("--out ends with .h5 or .csv, and is " + out.string());
  require_writable(out);
  const bool in_hdf5 = out.extension() == ".h5";
  if (needs_are_asked()) plan_in(w);
  if (needs_are_all(in_hdf5 ? for_hdf5 : Needs())) return;
  const sweep::Map map = map_of(w);
  if (in_hdf5)
    write_hdf5(map, out);
  else
    write_whole(out, to_csv(cells_table(map)));
  std::cout << out.string() << ": " << summary(map) << "\n";
}

void draw(const Words& w) {
  const fs::path out = output_of(w, "map.svg");
  if (out.extension() != ".svg") throw BadInput("--out ends with .svg, and is " + out.string());
  const std::vector<std::string> names{"outcome", "error", "cost"};
  const auto shown = std::ranges::find(names, w.shown);
  if (shown == names.end())
    throw BadInput("--show '" + w.shown + "' is not outcome, error or cost" + did_you_mean(w.shown, names));
  require_writable(out);
  const sweep::Map map = map_of(w);
  write_whole(out, picture(map, static_cast<sweep::Shown>(shown - names.begin())));
  std::cout << out.string() << ": " << summary(map) << "\n";
}

// ---- the command line -------------------------------------------------------------------------------------

CLI::App* part(CLI::App& sweep, const std::string& name, const std::string& says, const std::string& footer,
               const std::function<void()>& act, bool shows_needs = false) {
  auto* part = sweep.add_subcommand(name, says);
  part->group("Verbs");
  part->footer(footer);
  part->callback([act, shows_needs] {
    if (shows_needs || !needs_are_asked()) act();
  });
  return part;
}

void add_folder(CLI::App& part, Words& w) {
  part.add_option("folder", w.folder, "the sweep's folder: its plan and its finished chunks")
      ->required()
      ->check(not_empty("a path"));
}

void add_plan(CLI::App& sweep, const std::shared_ptr<Words>& w) {
  auto* plan = part(
      sweep, "plan", "Plan a sweep: its axes, and the chunks of its map.",
      "Examples:\n  oddity sweep plan /tmp/map 3.5 --model 'one angle' --algorithm 'Runge-Kutta 4' "
      "--over a=1deg..179deg:1000 --over step=1ms..2.5s:1000 --looks 4\n  oddity sweep plan /tmp/table 3.5 "
      "--over a=1deg..179deg:90 --over L=0.1..10:50:log --error 1deg\n  oddity sweep plan /tmp/uneven 3.5 "
      "--over a=1deg..179deg:90 --error 1deg --jitter 20% --drop 1%",
      [w] { make_plan(*w); }, true);
  w->plan = plan;
  add_folder(*plan, *w);
  plan->add_option("exercise", w->exercise, "its number, such as 3.5, or a problem's file")->required();
  plan->add_option("overrides", w->overrides, "name=value for parameters that stay as they are");
  const auto value = [&](const char* name, std::string& to, const char* type, const char* says) {
    return add_value(*plan, name, to, type, says);
  };
  plan->add_option(
          "--over", w->over,
          "NAME=FROM..TO:COUNT, once or twice: a parameter, or the method's step or tolerance, which go "
          "by a factor, as a parameter does with :log behind")
      ->required()
      ->type_name("AXIS")
      ->allow_extra_args(false);
  value("--model", w->model, "NAME", "with an algorithm: how this method ends at every cell");
  value("--algorithm", w->algorithm, "NAME",
        "without both, each cell has the method that 'choose' takes, by counted evaluations");
  value("--setting", w->setting, "NUMBER", "the method's step or tolerance, where it is no axis");
  value("--error", w->need.error, "ERROR", "as for 'choose'; unless given 1 cm, 1 degree");
  value("--criterion", w->need.criterion, "WORD", "as for 'choose', where no model is named")
      ->capture_default_str();
  value("--horizon", w->need.horizon, "TIME", "how long the motion is watched")->capture_default_str();
  value("--fps", w->need.frames_per_second, "RATE",
        "looks at the motion; steps divide the time between two evenly, and none is longer")
      ->capture_default_str();
  add_frames(*plan, w->need);
  add_kick(*plan, w->need);
  add_count(*plan, "--looks", w->looks, 1, 1'000'000,
            "so many looks within the horizon instead, so that steps may be longer");
  plan->add_flag("--every-cell", w->every_cell,
                 "look at all cells, not only where neighbours end differently; of up to 4096 cells all are");
  value("--chunk-time", w->chunk_time, "TIME", "how long a chunk takes, about")->capture_default_str();
  plan->add_flag("--overwrite", w->overwrite, "also in a folder that holds files of others, and over these");
}

void add_run(CLI::App& sweep, const std::shared_ptr<Words>& w) {
  auto* run = part(
      sweep, "run", "Work out the chunks that are not there yet.",
      "Chunks are written whole or not at all: an interrupted run continues where it ended. Results do not "
      "depend on the number of threads, ranks and machines.\nExamples:\n  oddity sweep run "
      "/tmp/map\n  mpirun -n 8 oddity sweep run /tmp/map\n  oddity sweep run /tmp/map --shard 2/7\n  "
      "oddity sweep run /tmp/map --slurm 100 | sbatch",
      [w] { run_chunks(*w); });
  add_folder(*run, *w);
  auto* threads = add_count(*run, "--threads", w->threads, 1, 4096, "threads of this program");
  auto* shard = add_value(*run, "--shard", w->shard, "I/N", "this share of the chunks alone: 2/7");
  add_count(*run, "--slurm", w->slurm, 1, 100'000, "print the script of a job array of so many instead")
      ->excludes(shard)
      ->excludes(threads);
}

void add_results(CLI::App& sweep, const std::shared_ptr<Words>& w) {
  auto* status = part(sweep, "status", "Show the progress of a sweep.",
                      "Columns: chunk, tiles, estimated seconds, there (1 or 0); a row for each chunk.",
                      [w] { oddity::status(*w); });
  add_folder(*status, *w);
  auto* json = status->add_flag("--json", w->json, "the chunks, as JSON");
  status->add_flag("--csv", w->csv, "the chunks, as comma-separated values")->excludes(json);
  auto* merge = part(
      sweep, "merge", "Put the chunks together into one file.",
      "An .h5 file has the arrays ended, error, evaluations and looked (rows from below), x and y, and "
      "the names of the endings. A .csv file has a row for each cell.\nExamples:\n  oddity sweep merge "
      "/tmp/map\n  oddity sweep merge /tmp/map /mnt/other/map --out map.csv",
      [w] { oddity::merge(*w); }, true);
  auto* draw =
      part(sweep, "draw", "Draw the map.",
           "Examples:\n  oddity sweep draw /tmp/map\n  oddity sweep draw /tmp/map --show error --out e.svg",
           [w] { oddity::draw(*w); });
  for (CLI::App* one : {merge, draw}) {
    add_folder(*one, *w);
    one->add_option("others", w->others, "folders that have others of its chunks")
        ->check(not_empty("a path"));
    one->add_option("--out", w->out, one == merge ? "the file: .h5 or .csv" : "the picture, an .svg")
        ->type_name("FILE");
  }
  draw->add_option("--show", w->shown, "outcome; error or cost, where every cell was looked at")
      ->type_name("WORD")
      ->capture_default_str();
}

}  // namespace

void add_sweep(const CommandLine& line) {
  auto* sweep = add_verb(
      line.app, "sweep",
      "Map a scene densely over one or two of its numbers, on as many machines as there are.",
      "A plan divides the map into chunks. Any number of runs, threads, MPI ranks and machines work them out. The "
      "result is the same, byte for byte.\n"
      "Examples:\n  oddity sweep plan /tmp/map 3.5 --model 'one angle' --algorithm 'Runge-Kutta 4' --over "
      "a=1deg..179deg:1000 --over step=1ms..2.5s:1000 --looks 4\n  oddity sweep run /tmp/map\n  oddity sweep merge "
      "/tmp/map\n  oddity sweep draw /tmp/map\n  oddity sweep plan --help",
      [] {});
  sweep->require_subcommand(1);
  const auto words = std::make_shared<Words>(Words{line.reference});
  add_plan(*sweep, words);
  add_run(*sweep, words);
  add_results(*sweep, words);
}

}  // namespace oddity
