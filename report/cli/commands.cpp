#include "report/cli/commands.hpp"

#include <fcntl.h>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <set>

#include "chapters/contents.hpp"
#include "problem/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/interrupted.hpp"
#include "report/cli/asked.hpp"
#include "report/cli/examples.hpp"
#include "report/cli/for_shells.hpp"
#include "report/cli/help.hpp"
#include "report/cli/needs.hpp"
#include "report/cli/prove.hpp"
#include "report/cli/schema.hpp"
#include "report/cli/verb.hpp"
#include "report/cli/verbs.hpp"
#include "report/cli/words.hpp"
#include "report/study/settings.hpp"
#include "report/text/visible.hpp"

namespace oddity {

namespace {

/// The command line's input, and the result.
struct Session : Formats {
  const Suite& suite;
  const Extras& extras;
  std::string folder = reference_folder().string();
  std::string exercise = {}, chapter = {};
  std::vector<std::string> exercises = {}, overrides = {};
  std::string results = {}, shard = {};
  std::vector<std::string> from = {};
  std::string report_out = report_folder().string(), chart_out = chart_folder().string(),
              maps_out = report_folder().string(), site_out = site_folder().string(),
              proofs_out = proofs_folder().string();
  bool rows = false, all_rows = false, approve = false, thorough = false, book = false, overwrite = false;
  std::string engine = {}, language = "C++", horizon = {};
  AskedNeed need = {};
  NewExercise begun = {};
  std::string outside = {}, from_exercise = {}, single = {};
  bool schema = false;
  bool scene = false, identity = false;
  std::string command = {};  ///< as typed in a shell
  int status = 0;
};

void add_one_exercise(CLI::App& verb, Session& s) {
  verb.add_option("exercise", s.exercise,
                  "its number, such as 3.33, or a problem's file, such as suspension.toml")
      ->required();
  verb.add_option(
      "overrides", s.overrides,
      "name=value for each parameter to change; units fit: a=30deg L=50cm; a point or a matrix at once: "
      "v0=1,2,-1");
}

void add_exercises(CLI::App& verb, Session& s, const std::string& says) {
  verb.add_option("exercises", s.exercises, says);
}

void add_list(CLI::App& app, Session& s) {
  auto* list =
      add_verb(app, "list", "List the exercises, with their parameters and ranges.",
               "Columns: exercise, title, scene (1 or 0), parameter, value, unit, least, most, whole (1 or "
               "0), says; a row for each parameter.\n"
               "Examples:\n  oddity list\n  oddity list 3.5\n  oddity list spring\n  oddity list --csv",
               [&] { verbs::list(s.exercises, s.format(), s.extras.engines); });
  add_exercises(
      *list, s,
      "numbers, such as 3.33, or words of their subjects, such as gyroscope; all when none is given");
  add_formats(*list, s, "the parameters");
}

std::string columns_of_trials() {
  return "Columns: exercise, quantity, unit, model, algorithm, precision, resolution, setting, value, error, needed, "
         "evaluations, seconds, spread, outcome, message; a row for each trial.\n";
}

/// Catch2's test specifications, which are not exercises.
void require_test_specifications(const std::vector<std::string>& words) {
  std::set<std::string> options;
  for (const std::string& word : words) {
    if (word.empty()) throw BadInput("verify: an argument is empty; '[3.5]' selects exercise 3.5");
    if (word.starts_with('-') && word != "-c" && word != "--section" && !options.insert(word).second)
      throw BadInput(word + " is given twice");
  }
  for (std::size_t i = 0; i < words.size(); ++i)
    if (exercise_number(words[i]) && (i == 0 || !words[i - 1].starts_with('-')))
      throw BadInput("verify takes Catch2's tests by tag: '[" + words[i] +
                     "]' with its quotes, for exercise " + words[i]);
}

/// A problem's file is judged alone.
void require_file_alone(const CLI::App& verify, const std::vector<std::string>& words) {
  if (words.size() > 1)
    throw BadInput("verify takes one problem's file and nothing else: leave '" +
                   words[problem::is_file(words[0]) ? 1 : 0] + "' out");
  for (const char* option : {"--results", "--shard", "--from", "--approve"})
    if (verify.get_option(option)->count() > 0)
      throw BadInput(std::string(option) + " is of the exercises, and " + words[0] + " is a problem's file");
}

/// A share is always taken of all exercises.
void require_all_exercises(const std::vector<std::string>& words) {
  for (const std::string& word : words)
    if (word.starts_with('[') || word.starts_with('~'))
      throw BadInput("--shard takes its share of all exercises, and does not go together with '" + word +
                     "'");
}

/// "[2.1],[2.15]": the exercises of a share.
std::string tags_of_shard(const std::string& text) {
  const Shard shard = shard_of(text);
  std::string tags;
  for (std::size_t i = shard.number - 1; i < registry().size(); i += shard.of)
    tags += (tags.empty() ? "[" : ",[") + to_string(registry()[i].number) + "]";
  if (tags.empty())
    throw BadInput("--shard " + text + ": there are " + std::to_string(registry().size()) + " exercises");
  return tags;
}

void add_verify(CLI::App& app, Session& s) {
  auto* verify = add_verb(
      app, "verify",
      "Check the exercises: judge every claim, run every method, compare with the approved results.",
      "Runs a Catch2 suite: test specifications, options and reporters work, and so does the reporter 'markdown'; "
      "'oddity verify -?' lists them. The exit code is 1 when anything differs from the approved results.\n"
      "Tags: [ch3], [3.5], [scene], [wrong], [incomplete], [misprint], [lost].\n"
      "Columns: exercise, claim, line (of the solutions), verdict, on_record, kind, root, says, why; a row "
      "for each claim.\n"
      "For a problem's file, it judges the claims. The exit code is then 1 when a verdict is not the one in the file.\n"
      "Examples:\n  oddity verify '[ch3]~[scene]'\n  oddity verify '[3.5]' -s\n  oddity verify -r markdown "
      "-o report.md\n  oddity verify '[wrong]' --csv\n"
      "  oddity verify --shard 1/2 --results 1.json; oddity verify --shard 2/2 --results 2.json; oddity verify --from "
      "1.json --from 2.json --results all.json",
      [&] {
        auto words = app.get_subcommand("verify")->remaining();
        if (std::ranges::any_of(words, problem::is_file)) {
          require_file_alone(*app.get_subcommand("verify"), words);
          s.status = verbs::judge(words[0], s.format());
          return;
        }
        require_test_specifications(words);
        if (s.json || s.csv) words.insert(words.end(), {"--reporter", s.json ? "claims-json" : "claims-csv"});
        if (!s.shard.empty()) {
          require_all_exercises(words);
          words.push_back(tags_of_shard(s.shard));
        }
        s.status =
            s.suite({words, s.folder, s.results, {s.from.begin(), s.from.end()}, s.approve, s.thorough});
      });
  add_path(*verify, "--results", s.results, "also write all results to this file, as JSON");
  add_value(*verify, "--shard", s.shard, "I/N", "run only this share of all exercises, such as 2/7");
  add_value(*verify, "--from", s.from, "FILE",
            "judge these results instead of running, one file for each --from; with --results, merge them")
      ->allow_extra_args(false);
  verify->add_flag("--approve", s.approve,
                   "approve the results of the selected exercises: verdicts, limits, maps and errors");
  verify->add_flag("--thorough", s.thorough,
                   "look for limits of stability by scans of all steps; otherwise those on both sides of the "
                   "approved limits are tried first");
  add_formats(*verify, s, "print the claims and their verdicts");
  verify->allow_extras();
}

void add_enclosed(CLI::App& app, AskedNeed& need) {
  app.add_flag(
      "--enclosed", need.enclosed,
      "prove bounds for the errors of true values that are computed on the spot, in ball arithmetic (Arb); "
      "the chain of 3.25 takes a minute or two");
}

void add_solve(CLI::App& app, Session& s) {
  auto* solve =
      add_verb(app, "solve", "Solve one exercise: every quantity by every method.",
               columns_of_trials() +
                   "Examples:\n  oddity solve 3.5\n  oddity solve 3.5 a=150deg L=50cm\n  oddity solve "
                   "3.5 a=150deg --csv",
               [&] { verbs::solve(s.folder, s.exercise, s.overrides, s.need.enclosed, s.format()); });
  add_one_exercise(*solve, s);
  add_enclosed(*solve, s.need);
  auto* json = solve->add_flag("--json", s.json, "all results as JSON, as in a results file");
  solve->add_flag("--csv", s.csv, "the trials, as comma-separated values")->excludes(json);
}

void add_choose_need(CLI::App& choose, AskedNeed& need) {
  auto* error =
      add_value(choose, "--error", need.error, "ERROR",
                "largest error of the observables: a number in their unit, 0.01, or with a unit, 1cm; "
                "for observables of several units 1cm,1deg. For energy and period a fraction, 0.01; for a "
                "constraint a length, 1mm");
  add_value(choose, "--digits", need.digits, "N",
            "instead of --error: correct digits of the largest observable")
      ->excludes(error);
  add_value(choose, "--horizon", need.horizon, "TIME",
            "length of the motion: 10 (in s, or in the scene's unit), 1h; at most a million frames")
      ->capture_default_str();
  add_value(choose, "--fps", need.frames_per_second, "RATE", "frames per second: 60, 60Hz")
      ->capture_default_str();
  add_value(choose, "--budget", need.budget, "TIME", "longest time of a frame: 5us, 300ns, 0.1ms");
  add_value(
      choose, "--bodies", need.bodies, "N",
      "number of bodies of the same kind in each frame: in SIMD lanes, if the method has them, else one "
      "after the other")
      ->capture_default_str();
  add_value(
      choose, "--restart-every", need.restart_every, "TIME",
      "interval of contacts that restart the integration: the cost of the restarts is added to a method's time; "
      "its error is that of a run without contacts");
  add_criteria(choose, need);
}

void add_choose_own(CLI::App& choose, AskedNeed& need) {
  add_value(
      choose, "--starts", need.starts, "N",
      "number of initial conditions on which a method must hold: the requested, and others up to a tenth "
      "away; 1: the requested alone, with a report on five others")
      ->capture_default_str();
  auto* method = add_value(
      choose, "--method", need.method, "NAME@STEP",
      "judge the method that you use: 'semi-implicit Euler@60Hz', RK4@1/30, Verlet@5ms, "
      "'Dormand-Prince 5(4)@1e-6'; without a step, one per frame. The exit code is 1 when it is not good enough");
  add_value(choose, "--model", need.model, "WORD", "with --method: only models with this in their names")
      ->needs(method);
}

void add_choose_methods(CLI::App& choose, AskedNeed& need) {
  choose.add_flag("--cheapest", need.cheapest, "choose the cheapest method, however complicated");
  choose.add_flag("--lockstep", need.lockstep,
                  "only methods with the same bits from every compiler and on every processor: --code prints "
                  "such a program, with its own elementary functions and a hash of the whole motion");
  choose.add_flag("--one-step", need.one_step, "exclude methods that need a history");
  add_value(choose, "--precision", need.precision, "WORD",
            "float, double or any; closed forms and explicit algorithms of fixed step exist in float")
      ->capture_default_str();
  add_value(choose, "--only", need.only, "WORD",
            "only models and algorithms with this in their names; repeatable")
      ->allow_extra_args(false);
  add_value(choose, "--exclude", need.exclude, "WORD",
            "no models or algorithms with this in their names; repeatable")
      ->allow_extra_args(false);
  add_time_limit(choose, need.time_limit);
  add_enclosed(choose, need);
  choose.add_flag(
      "--thorough", need.thorough,
      "try every method at every setting, and judge by true motions of 24 digits: slow; a check of the "
      "usual answer");
  choose.add_flag("--explain", need.explain, "show the tried methods, and where the time went");
  choose.add_flag("--measure", need.measure,
                  "measure times again; by default those of an earlier run are used, so that the same "
                  "question gets the same answer");
}

/// Notes which of the need's options are given.
void see_what_is_given(AskedNeed& need, const CLI::App& verb) {
  need.horizon_is_given = verb.get_option("--horizon")->count() > 0;
  need.rate_is_given = verb.get_option("--fps")->count() > 0;
}

/// "2.7, 3.3, 3.5".
std::string numbers_of_scenes() {
  std::vector<std::string> numbers;
  for (const Entry& entry : registry())
    if (entry.exercise.scene) numbers.push_back(to_string(entry.number));
  return joined(numbers);
}

void add_choose(CLI::App& app, Session& s) {
  auto* choose = add_verb(
      app, "choose", "Choose the model, the algorithm and the step that a scene needs.",
      "A method must hold at every frame. It is chosen on the requested start and two near it, and tested on three "
      "others. The choice is the cheapest of the closed forms and one-step methods of fixed step that hold with a "
      "margin of three. Of those whose costs differ by less than a quarter, it is the most accurate. A long horizon "
      "is judged in parts, each eight times as long as the one before; the answer shows which part the time limit "
      "left out. The exit code is 1 when nothing meets the need, or only a part of the horizon was judged.\n"
      "Columns: model, algorithm, precision, setting, error [unit] (one for each unit; if the method "
      "fails, on the first start where it does), holds (1 or 0), outcome, evaluations per frame, seconds per frame, chosen (1 or 0); a row for each method.\n"
      "Keys of the JSON: need (judged_over: the part of its horizon), chosen (null when nothing is; rollback: to take eight frames again), in_float, ties, candidates (followed: false where finer "
      "settings were not tried), on_asked (when nothing is chosen, the method that holds on the requested start), engine, "
      "predictable, chosen_on, tested_on, failing_nearby, left_out (nearby starts with another kind of motion), "
      "in_chaos (how many unseen starts hold, with bounds), lockstep (null unless requested; functions: its own ones, times_usual: its time relative to the usual program's, left_out by reason), engines (with --engine, the trials as 'engines --json' has them), times, explanation.\n"
      "Columns with --method: exercise, model, algorithm, resolution, setting, holds (1 or 0), outcome, where, error_in_needs, "
      "starts, failing, growth (of the error, from half the time to the end), drift (of the model's conserved quantity), energy (error of the observed energy), stable_to, "
      "evaluations_per_frame, seconds_per_frame, frames_per_second; a row for each model.\n"
      "If frames differ in length, a fixed step has four separate methods. One divides each frame into steps. In the others "
      "an accumulator takes steps of one length, and draws the last state, one between the last two, or one ahead.\n"
      "Scenes: " +
          numbers_of_scenes() +
          "\n"
          "Examples:\n  oddity choose 3.5 a=60deg --error 1deg --budget 5us\n  oddity choose 3.5 --error 1deg --jitter 20% --drop 1%\n  oddity choose 3.5 --error 1deg --kick \"t=1s,theta'=+2\"\n  oddity choose 3.33 --error 1deg "
          "--horizon 2 --fps 120\n  oddity choose 3.25 --criterion bounded --precision float\n  oddity choose 3.5 "
          "--error 1deg --exclude closed --code\n  oddity choose 3.5 --error 1deg --lockstep --code\n  oddity choose 3.5 --error 1deg --bodies 10000 --budget 1ms\n"
          "  oddity choose 3.5 --error 1deg --method 'semi-implicit Euler@60Hz'",
      [&] {
        s.need.as_engines = !s.engine.empty();
        see_what_is_given(s.need, *app.get_subcommand("choose"));
        if (problem::is_file(s.exercise)) ask_as_file(s.need, entry_of(s.exercise));
        s.status = verbs::choose(s.folder, s.exercise, s.overrides, s.need, s.format(), s.all_rows, s.engine,
                                 s.command, s.language, s.extras);
      },
      true);
  add_one_exercise(*choose, s);
  add_choose_need(*choose, s.need);
  add_frames(*choose, s.need);
  add_kick(*choose, s.need);
  add_choose_methods(*choose, s.need);
  add_choose_own(*choose, s.need);
  choose->add_flag("--all", s.all_rows, "show all rows of the table");
  add_formats(*choose, s, "the choice and every method tried");
  auto* code = choose->add_flag("--code", s.code, "print the chosen model and its loop, as C++ to paste");
  set_apart(*choose, code, {"--json", "--csv"});
  add_value(*choose, "--language", s.language, "NAME",
            "language of the code: C++ (cpp), C# (cs) or JavaScript (js)")
      ->needs(code);
  auto* engine = add_value(
      *choose, "--engine", s.engine, "NAME",
      "compare the choice with an engine: bullet, mujoco; within 1 cm and 1 degree unless --error or "
      "--digits is given");
  set_apart(*choose, engine, {"--csv", "--code"});
  set_apart(*choose, choose->get_option("--method"),
            {"--engine", "--code", "--explain", "--all", "--enclosed"});
  set_apart(*choose, choose->get_option("--lockstep"), {"--method", "--engine", "--bodies"});
  set_apart(*choose, choose->get_option("--kick"), {"--code", "--engine", "--lockstep"});
}

CLI::Option* add_overwrite(CLI::App& verb, Session& s) {
  return verb.add_flag("--overwrite", s.overwrite,
                       "also write into a folder with other files, and over these");
}

void add_report(CLI::App& app, Session& s) {
  auto* report = add_verb(app, "report", "Write the Markdown report.",
                          "Uses the last results. Exercises with changed code or tables run first.\n"
                          "Examples:\n  oddity report\n  oddity report --chapter 3 --out /tmp/report",
                          [&] {
                            verbs::report(s.folder, s.chapter, s.book ? Edition::book : Edition::whole,
                                          s.report_out, s.overwrite);
                          });
  add_value(*report, "--chapter", s.chapter, "N", "only the exercises of one chapter");
  report->add_flag("--book", s.book, "without times, as in report/book of the sources");
  add_path(*report, "--out", s.report_out, "the folder to write to");
  add_overwrite(*report, s);
}

void add_site(CLI::App& app, Session& s) {
  auto* site = add_verb(
      app, "site", "Write the report that runs: one folder, for a browser.",
      "Open its index.html with a double click; it needs no network. Uses the last results. "
      "Exercises with changed code or tables run first.\n"
      "Examples:\n  oddity site\n  oddity site --out /tmp/site\n"
      "  oddity site --single 3.5 --out /tmp/pendulum.html\n  oddity new bump.toml && oddity site bump.toml --out /tmp/bump",
      [&app, &s] {
        const bool is_named = app.get_subcommand("site")->get_option("--out")->count() > 0;
        if (!s.single.empty()) {
          const std::string name = problem::is_file(s.single) ? problem::stem_of(s.single) : s.single;
          return verbs::single(s.folder, s.single, is_named ? s.site_out : name + ".html", s.overwrite);
        }
        if (s.exercise.empty()) return verbs::site(s.folder, s.site_out, s.overwrite);
        verbs::site_of_file(s.folder, s.exercise, is_named ? s.site_out : problem::stem_of(s.exercise),
                            s.overwrite);
      },
      true);
  auto* file =
      site->add_option("file", s.exercise, "a problem's file: writes one page, in a folder of its name")
          ->check(not_empty("a problem's file"));
  add_value(*site, "--single", s.single, "N.M",
            "one exercise, or a problem's file, as one file, to mail: N.M.html")
      ->excludes(file);
  add_path(*site, "--out", s.site_out, "the folder to write to, or the file");
  add_overwrite(*site, s);
}

void add_chart(CLI::App& app, Session& s) {
  auto* chart = add_verb(
      app, "chart", "Draw error against work and against time, with the tables behind the charts.",
      columns_of_trials() +
          "Scenes with engines' results have their charts as well. --jitter, --drop and --frames chart a scene's motion "
          "at such frames, with each way to match fixed steps to them.\nExamples:\n  oddity chart 3.5 2.13 --out /tmp/charts\n  oddity chart 3.5 --csv\n  "
          "oddity chart 3.5 --jitter 20% --drop 1% --out /tmp/uneven",
      [&] {
        const CLI::App& asked = *app.get_subcommand("chart");
        see_what_is_given(s.need, asked);
        for (const char* option : {"--horizon", "--fps", "--jitter", "--drop", "--frame-seed", "--frames",
                                   "--max-frame", "--kick"})
          if (asked.get_option(option)->count() > 0) s.need.frames_are_given = true;
        if (s.format() == verbs::Format::text)
          verbs::chart(s.folder, s.exercises, s.need, s.all_rows ? Curves::all : Curves::few, s.chart_out,
                       s.overwrite, s.extras.engines);
        else
          verbs::chart_table(s.folder, s.exercises, s.need, s.format());
      });
  add_exercises(*chart, s, "numbers, such as 3.5, or problems' files; all exercises when none is given");
  chart->add_flag("--all", s.all_rows, "curves of all methods, instead of at most eight");
  add_value(*chart, "--horizon", s.need.horizon, "TIME",
            "scenes: chart the motion up to this time, at every frame");
  add_value(*chart, "--fps", s.need.frames_per_second, "RATE", "scenes: frames per second: 60, 60Hz");
  add_frames(*chart, s.need);
  add_kick(*chart, s.need);
  add_formats(*chart, s, "the trials, with nothing drawn");
  add_time_limit(*chart, s.need.time_limit, ", for each exercise");
  set_apart(*chart, add_path(*chart, "--out", s.chart_out, "the folder to write to"), {"--json", "--csv"});
  set_apart(*chart, add_overwrite(*chart, s), {"--json", "--csv"});
}

void add_stability(CLI::App& app, Session& s) {
  auto* stability = add_verb(
      app, "stability", "Show the largest stable step of each method, and how it breaks beyond.",
      "Also draws maps of each method's outcome, over the step and the parameter that makes the scene hard.\n"
      "Columns: exercise, model, algorithm, stable_to, breaks_at, theory, unit (of these), breaks_by, error, "
      "error_unit, why, unstable_in_theory, error_there (at stable_to), needed_to (the longest within the scene's need), "
      "not_sharp_from, not_sharp_to (for other observers, where the limit is not sharp), watched (the time, where the motion does "
      "not continue in the same way), how, cure, and holds_to where an error or a criterion is asked for (the longest within that; 0: "
      "none found; nan where the method does not show it), and stable_at_frames where frames vary (the longest usual frame "
      "at which a step a frame is stable); a row for each method of fixed step.\n"
      "Examples:\n  oddity stability 3.5 --out /tmp/maps\n  oddity stability 3.5 3.33 --csv\n  oddity stability 3.5 "
      "a=1 L=2 --horizon 20s\n  oddity stability 3.5 --drop 5%\n  oddity stability 3.5 --criterion energy --error 5% --horizon 1min",
      [&] {
        s.need.criterion_is_given = app.get_subcommand("stability")->get_option("--criterion")->count() > 0;
        const verbs::AskedStability asked{s.exercises, s.horizon, s.need};
        if (s.rows)
          verbs::stability_rows(s.folder, asked);
        else if (s.format() != verbs::Format::text)
          verbs::stability_table(s.folder, asked, s.format());
        else
          verbs::stability(s.folder, asked, s.maps_out, s.overwrite);
      });
  add_exercises(
      *stability, s,
      "numbers, such as 3.5, or problems' files; all exercises that have a motion when none is given; behind one name=value for each "
      "parameter to change");
  add_value(*stability, "--horizon", s.horizon, "TIME", "length of the motion, instead of the scene's");
  add_value(*stability, "--error", s.need.error, "ERROR",
            "also show the longest step that keeps the motion within this at the end of every step, 1cm,1deg "
            "by default; for energy and period a part, 1%");
  add_criteria(*stability, s.need);
  add_varied_frames(*stability, s.need);
  add_time_limit(*stability, s.need.time_limit, ", for each exercise");
  add_formats(*stability, s, "the limits, with nothing drawn");
  auto* rows = stability->add_flag("--rows", s.rows,
                                   "the rows of limits.csv and stability_maps.csv, with nothing drawn");
  set_apart(*stability, rows,
            {"--json", "--csv", "--horizon", "--error", "--criterion", "--energy", "--period", "--constraint",
             "--jitter", "--drop", "--frames"});
  set_apart(*stability, add_path(*stability, "--out", s.maps_out, "the folder to draw the maps in"),
            {"--rows", "--json", "--csv"});
  set_apart(*stability, add_overwrite(*stability, s), {"--rows", "--json", "--csv"});
}

void add_trust(CLI::App& app, Session& s) {
  auto* trust = add_verb(
      app, "trust", "Show how far the results are proved, checked and tested.",
      "Counts of proofs, enclosures, witnesses, mutants, fuzzed inputs and survived faults. Uses the last results. "
      "Exercises with changed code or tables run first.\n"
      "Columns: part, subject, count, of, says, date, commit, rests_on; a row for each part, and for each of its "
      "kinds, rooms, targets or faults.\n"
      "Examples:\n  oddity trust\n  oddity trust --json",
      [&] { verbs::trust(s.folder, s.format()); });
  add_formats(*trust, s, "all figures");
}

void add_prove(CLI::App& app, Session& s) {
  auto* prove = add_verb(
      app, "prove", "Prove claims by Coq, for all numbers instead of samples.",
      "Writes a file for each claim with a proof, from the formulas that the suite computes with, and checks it with "
      "coqc. The exit code is 1 when one is refused.\n"
      "Columns: claim, proved, margin (of a printed value, which is off by no less), outcome, seconds, message.\n"
      "Examples:\n  oddity prove\n  oddity prove 3.5 7.9 --out /tmp/proofs",
      [&] {
        s.status = verbs::prove(s.folder, {s.exercises, s.proofs_out, s.overwrite, s.approve}, s.format());
      },
      true);
  add_exercises(*prove, s, "numbers, such as 3.5; without any, all that have proofs");
  add_path(*prove, "--out", s.proofs_out, "the folder to write the files to");
  add_overwrite(*prove, s);
  prove->add_flag("--approve", s.approve, "approve the proofs");
  add_formats(*prove, s, "the proofs");
}

/// A problem's file accepts no other options.
void begin_problem(const CLI::App& begin, const Session& s) {
  for (const char* option : {"slug", "--scene", "--identity", "--topic", "--in"})
    if (begin.get_option(option)->count() > 0)
      throw BadInput(std::string(option) + " is of an exercise, and " + s.begun.number +
                     " is a problem's file");
  verbs::create_problem(s.begun.number, s.from_exercise);
}

void add_new(CLI::App& app, Session& s) {
  auto* begin = add_verb(
      app, "new",
      "Begin an exercise of your own, with files that compile and list their gaps; or a problem's file.",
      "The number must be free: an even one, or one of another chapter. Overwrites nothing.\n"
      "Examples:\n  oddity new suspension.toml\n  oddity new --from-exercise 3.5 mine.toml\n  oddity new 3.2 spring_pendulum\n  oddity new 9.2 law_of_cosines --identity\n  "
      "oddity new 20.1 comet --topic space --in ~/exercises",
      [&] {
        if (s.schema) {
          if (!s.begun.number.empty()) throw BadInput("--schema prints the schema and takes no name");
          std::cout << schema_of_problems();
          return;
        }
        if (s.begun.number.empty())
          throw BadInput("new needs a number, such as 3.2, or a problem's file, such as suspension.toml");
        if (problem::is_file(s.begun.number)) return begin_problem(*app.get_subcommand("new"), s);
        if (!s.from_exercise.empty())
          throw BadInput("--from-exercise writes a problem's file: name one, such as mine.toml");
        if (s.begun.slug.empty())
          throw BadInput("new needs the name of its folder behind the number, such as 3.2 spring_pendulum");
        s.begun.in = s.outside;
        s.begun.scene = !s.identity;
        verbs::create(s.begun);
      });
  begin->add_option("number", s.begun.number, "such as 3.2; or a problem's file, such as suspension.toml");
  add_value(*begin, "--from-exercise", s.from_exercise, "NUMBER",
            "write this scene of the book as a problem's file, to be changed");
  begin->add_flag("--schema", s.schema,
                  "print the JSON schema of a problem's file, by which editors check it");
  begin->add_option("slug", s.begun.slug, "the name of its folder, such as spring_pendulum");
  auto* scene = begin->add_flag("--scene", s.scene, "a motion, with models, methods and claims; the default");
  begin->add_flag("--identity", s.identity, "only claims")->excludes(scene);
  add_value(*begin, "--topic", s.begun.topic, "WORD", "the name of a chapter that has no folder yet");
  add_path(*begin, "--in", s.outside, "a folder outside the tree, which the build finds by ODDITY_OWN");
}

/// The default command: verifies everything, and writes the report and the site.
int all_of_it(const Session& s) {
  if (needs_are_all(verbs::needs_of_site())) return 0;
  const auto begun = std::chrono::steady_clock::now();
  verbs::require_room_for_all(s.report_out, s.site_out);
  const int verdict = s.suite({{}, s.folder, results_file()});
  verbs::publish(s.folder, s.report_out, s.site_out, verdict == 0, [begun] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  });
  return verdict;
}

/// Opens closed standard streams so that writing fails: otherwise a file could take their place.
void occupy_standard_streams() {
  for (int stream : {0, 1, 2})
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
}

/// Whether standard output took everything that was printed; reports it if not.
bool output_arrived() {
  errno = 0;
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  std::cerr << "oddity: cannot write to standard output"
            << (errno == 0 ? ", which is closed or full"
                           : ": " + std::error_code(errno, std::generic_category()).message())
            << "\n";
  return false;
}

void complain(const std::string& what) {
  std::cerr << wrapped("oddity: " + visible(what) + "\n", screen_of(STDERR_FILENO), 2);
}

/// Includes memory for a thread; TBB reports that only in the message.
bool lacks_memory(const std::exception& error) {
  const auto* of_system = dynamic_cast<const std::system_error*>(&error);
  return dynamic_cast<const std::bad_alloc*>(&error) ||
         (of_system && of_system->code() == std::errc::resource_unavailable_try_again) ||
         std::string_view(error.what()).starts_with("pthread_create has failed");
}

int no_memory() {
  constexpr std::string_view says = "oddity: there is not enough memory for this\n";
  static_cast<void>(!write(STDERR_FILENO, says.data(), says.size()));
  return 2;
}

const std::terminate_handler usual_end = std::get_terminate();

/// Called if memory runs out in a destructor or another thread: destroying JSON takes some.
[[noreturn]] void end_without_memory() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    tidy_up();
    _exit(no_memory());
  } catch (...) {
  }
  usual_end();
  std::abort();
}

int answer(CLI::App& app, Session& session, int argc, char** argv) {
  try {
    std::vector<std::string> words = words_of(argc, argv);
    if (words == std::vector<std::string>{"--completion"}) return std::cout << completion_of(app), 0;
    if (words == std::vector<std::string>{"--examples"}) return std::cout << examples_of(app), 0;
    if (words == std::vector<std::string>{"--manual"}) return std::cout << manual_of(app, version()), 0;
    if (!words.empty() && words.front() == "--needs") {
      ask_for_needs();
      words.erase(words.begin());
    }
    require_verbs_alone(app, argc, argv);
    require_a_verb(app, words);
    require_each_once(app, words);
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // CLI11's order
    app.parse(reversed);
    return app.get_subcommands().empty() ? all_of_it(session) : session.status;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    complain(complaint_of(app, error));
    return 2;
  } catch (const BadInput& error) {
    complain(error.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error.path1().string() + ": " + error.code().message());
    return 2;
  } catch (const std::exception& error) {
    if (lacks_memory(error)) throw std::bad_alloc();
    complain("internal error: " + std::string(error.what()));
    return 1;
  }
}

}  // namespace

int command_line(int argc, char** argv, const Suite& suite, const Extras& extras) try {
  std::set_terminate(end_without_memory);
  occupy_standard_streams();
  const VisibleOutput printed(std::cout, screen_of(STDOUT_FILENO).colour),
      said(std::cerr, screen_of(STDERR_FILENO).colour, "\r");  // progress returns to the start of its line
  tidy_when_interrupted();
  std::signal(SIGXFSZ, SIG_IGN);  // exceeding the file size limit is then a write error
  CLI::App app(
      "The solutions of Game Physics, 2nd edition, checked by machine. Without a verb everything is verified, "
      "and the report and the site are written.",
      "oddity");
  app.formatter(help_for(screen_of(STDOUT_FILENO)));
  app.footer(
      "Start with:\n  oddity list\n  oddity solve 3.5\n  oddity choose 3.5 a=60deg --error 1deg\n  oddity verify "
      "'[3.5]'\n  oddity help choose\n"
      "Tables fit the terminal, and are complete in a pipe. Output to a terminal has colour. NO_COLOR=1 turns it "
      "off, CLICOLOR_FORCE=1 on in a pipe.\n"
      "Exit codes: 0 green, 1 something differs from the approved results (or nothing meets the need), 2 bad input "
      "or output that could not be written, 130 interrupted.");
  Session session{{}, suite, extras};
  app.set_help_flag("-h,--help", "show this help");
  app.set_version_flag("-v,--version", version(), "show the version");
  add_path(app, "--reference", session.folder, "the folder of the reference tables");
  app.require_subcommand(0, 1);
  add_list(app, session);
  add_verify(app, session);
  add_solve(app, session);
  add_chart(app, session);
  add_stability(app, session);
  add_choose(app, session);
  for (const auto& add : extras.verbs) add({app, session.folder, session.status});
  add_prove(app, session);
  add_trust(app, session);
  add_report(app, session);
  add_site(app, session);
  add_new(app, session);
  add_verb(app, "help", "Show this help, or that of a verb.", "Example: oddity help choose", [] {});
  session.command = typed(words_of(argc, argv));
  const int status = answer(app, session, argc, argv);
  return output_arrived() ? status : 2;
} catch (const std::bad_alloc&) {
  return no_memory();
} catch (const BadInput& error) {
  complain(error.what());
  return 2;
}

}  // namespace oddity
