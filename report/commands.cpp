#include "report/commands.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>

#include "reference/bad_input.hpp"
#include "report/settings.hpp"
#include "report/verbs.hpp"

namespace oddity {

namespace {

/// What was asked on the command line, and what comes of it.
struct Session {
  const Suite& suite;
  std::string folder = reference_folder().string();
  std::string exercise = {};
  std::vector<std::string> exercises = {}, overrides = {};
  std::string results = {};
  std::string report_out = report_folder().string(), chart_out = chart_folder().string(),
              maps_out = report_folder().string();
  bool json = false, rows = false, approve = false;
  int chapter = 0, digits = 0;
  Need need{std::numeric_limits<double>::quiet_NaN()};
  int status = 0;
};

CLI::App* verb(CLI::App& app, const std::string& name, const std::string& says, const std::string& footer,
               const std::function<void()>& act) {
  auto* verb = app.add_subcommand(name, says);
  verb->footer(footer);
  verb->callback(act);
  return verb;
}

void add_one_exercise(CLI::App& verb, Session& s) {
  verb.add_option("exercise", s.exercise, "its number, such as 3.33")->required();
  verb.add_option("overrides", s.overrides, "name=value for each parameter to change");
}

void add_verify(CLI::App& app, Session& s) {
  auto* verify = verb(
      app, "verify", "run the verification suite (Catch2) over all exercises",
      "All else goes to Catch2: a test specification and its options, its reporters and 'markdown'.\n"
      "Tags: [ch3] [3.5] [scene] [erratum] [misprint]. Catch2's own help: oddity verify -?\n"
      "Examples: oddity verify '[ch3]~[scene]'    oddity verify '[3.5]' -s    oddity verify -r markdown -o "
      "report.md",
      [&] {
        s.status = s.suite({app.get_subcommand("verify")->remaining(), s.folder, s.results, s.approve});
      });
  verify->add_option("--results", s.results, "also keep the results in this file, as JSON");
  verify->add_flag("--approve", s.approve,
                   "put what this run finds for the selected exercises on record: verdicts, limits and maps");
  verify->allow_extras();
}

void add_solve(CLI::App& app, Session& s) {
  auto* solve =
      verb(app, "solve", "one exercise: every quantity by every method", "Example: oddity solve 3.5 a=2.5",
           [&] { verbs::solve(s.folder, s.exercise, s.overrides, s.json); });
  add_one_exercise(*solve, s);
  solve->add_flag("--json", s.json, "print the results as JSON");
}

int chosen(Session& s) {
  if (s.digits > 0) {
    s.need.error = std::pow(10, -s.digits);
    s.need.relative = true;
  }
  if (std::isnan(s.need.error)) throw BadInput("choose needs --error or --digits");
  return verbs::choose(s.folder, s.exercise, s.overrides, s.need);
}

void add_choose(CLI::App& app, Session& s) {
  auto* choose = verb(
      app, "choose", "the cheapest model, algorithm and step that a need allows",
      "It is chosen on the start asked for and two beside it, and tested on three others. The exit code is "
      "1 when nothing meets the need.\n"
      "Example: oddity choose 3.5 a=1 --error 1e-3 --horizon 10 --fps 60 --budget 5us",
      [&] { s.status = chosen(s); });
  add_one_exercise(*choose, s);
  auto* error =
      choose->add_option("--error", s.need.error, "largest error of the observables, in their unit");
  choose->add_option("--digits", s.digits, "instead: right digits of the largest observable")
      ->excludes(error)
      ->check(CLI::Range(1, 15));
  choose->add_option("--horizon", s.need.horizon, "how far ahead [s, or the scene's own unit]")
      ->capture_default_str();
  choose->add_option("--fps", s.need.frames_a_second, "frames a second")->capture_default_str();
  choose->add_option("--budget", s.need.budget, "most time a frame: 5us, 300ns, 0.1ms")
      ->transform(CLI::AsNumberWithUnit(
          std::map<std::string, double>{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}},
          CLI::AsNumberWithUnit::UNIT_REQUIRED));
}

void add_report(CLI::App& app, Session& s) {
  auto* report = verb(app, "report", "write the Markdown report, from the last results where they are fresh",
                      "Example: oddity report --chapter 3 --out /tmp/report",
                      [&] { verbs::report(s.folder, s.chapter, s.report_out); });
  report->add_option("--chapter", s.chapter, "one chapter only");
  report->add_option("--out", s.report_out, "folder to write to")->capture_default_str();
}

void add_chart(CLI::App& app, Session& s) {
  auto* chart = verb(app, "chart", "error against work and against time, drawn, with the tables",
                     "Example: oddity chart 3.5 2.13 --out /tmp/charts",
                     [&] { verbs::chart(s.folder, s.exercises, s.chart_out); });
  chart->add_option("exercises", s.exercises, "their numbers, such as 3.5; none: all");
  chart->add_option("--out", s.chart_out, "folder to write to")->capture_default_str();
}

void add_stability(CLI::App& app, Session& s) {
  auto* stability = verb(app, "stability", "where methods break: by step, and over a parameter",
                         "Example: oddity stability 3.5 --out /tmp/maps",
                         [&] { verbs::stability(s.folder, s.exercises, s.rows, s.maps_out); });
  stability->add_option("exercises", s.exercises, "their numbers, such as 3.5; none: all that have a motion");
  stability->add_flag("--rows", s.rows, "print the rows of limits.csv and stability_maps.csv instead");
  stability->add_option("--out", s.maps_out, "folder to draw the maps in")->capture_default_str();
}

/// The main job: verify everything and write the report.
int all_of_it(const Session& s) {
  const int verdict = s.suite({{}, s.folder, results_file()});
  verbs::report(s.folder, 0, s.report_out);
  return verdict;
}

}  // namespace

int command_line(int argc, char** argv, const Suite& suite) {
  CLI::App app(
      "oddity: the solutions of Game Physics, 2nd edition, checked by machine.\n"
      "Without a verb: verify everything and write the report.",
      "oddity");
  Session session{suite};
  app.set_version_flag("--version", version());
  app.add_option("--reference", session.folder, "folder of the reference tables")->capture_default_str();
  app.require_subcommand(0, 1);
  verb(app, "list", "exercises, titles, parameters", "Example: oddity list",
       [&] { verbs::list(); });
  add_verify(app, session);
  add_solve(app, session);
  add_chart(app, session);
  add_stability(app, session);
  add_choose(app, session);
  verb(app, "bench", "how fast this build is: loops by hand, best methods, the suite",
       "Times mean something only on an idle machine. Example: oddity bench",
       [&] { verbs::bench(session.folder); });
  add_report(app, session);
  try {
    app.parse(argc, argv);
    return app.get_subcommands().empty() ? all_of_it(session) : session.status;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const BadInput& error) {
    std::cerr << "oddity: " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "oddity: internal error: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace oddity
