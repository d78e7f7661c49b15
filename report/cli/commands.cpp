#include "report/cli/commands.hpp"

#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <cctype>
#include <csignal>
#include <iostream>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/interrupted.hpp"
#include "reference/similar.hpp"
#include "report/cli/asked.hpp"
#include "report/cli/settings.hpp"
#include "report/cli/verbs.hpp"

namespace oddity {

namespace {

/// What was asked on the command line, and what comes of it.
struct Session {
  const Suite& suite;
  std::string folder = reference_folder().string();
  std::string exercise = {}, chapter = {};
  std::vector<std::string> exercises = {}, overrides = {};
  std::string results = {};
  std::string report_out = report_folder().string(), chart_out = chart_folder().string(),
              maps_out = report_folder().string(), site_out = site_folder().string();
  bool json = false, csv = false, code = false, rows = false, all_rows = false, approve = false, book = false;
  AskedNeed need = {};
  NewExercise begun = {};
  std::string outside = {};
  bool scene = false, identity = false;
  std::string command = {};  ///< as it would be typed
  int status = 0;

  verbs::Format format() const {
    return json   ? verbs::Format::json
           : csv  ? verbs::Format::csv
           : code ? verbs::Format::code
                  : verbs::Format::text;
  }
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
  verb.add_option("overrides", s.overrides,
                  "name=value for each parameter to change; units fit: a=30deg L=50cm");
}

/// A path that is asked for is not empty, which would be the current folder.
CLI::Option* add_path(CLI::App& verb, const std::string& name, std::string& path, const std::string& says) {
  return verb.add_option(name, path, says)->capture_default_str()->check([name](const std::string& given) {
    return given.empty() ? std::string("it needs a path") : "";
  });
}

void add_formats(CLI::App& verb, Session& s, const std::string& what) {
  auto* json = verb.add_flag("--json", s.json, what + " as JSON");
  verb.add_flag("--csv", s.csv, what + " as comma-separated values")->excludes(json);
}

void add_list(CLI::App& app, Session& s) {
  auto* list = verb(app, "list", "list the exercises, with their parameters and ranges",
                    "Example: oddity list 3.5", [&] { verbs::list(s.exercise, s.format()); });
  list->add_option("exercise", s.exercise, "its number, such as 3.33; none: all");
  add_formats(*list, s, "the parameters");
}

/// Catch2's words, which are not exercises.
void require_test_specifications(const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (exercise_number(words[i]) && (i == 0 || !words[i - 1].starts_with('-')))
      throw BadInput("verify takes Catch2's tests by tag: '[" + words[i] +
                     "]' with its quotes, for exercise " + words[i]);
}

void add_verify(CLI::App& app, Session& s) {
  auto* verify = verb(
      app, "verify", "run the verification suite (Catch2) over all exercises",
      "All else goes to Catch2: a test specification and its options, its reporters and 'markdown'.\n"
      "Tags: [ch3] [3.5] [scene] [erratum] [misprint]. Catch2's own help: oddity verify -?\n"
      "Examples: oddity verify '[ch3]~[scene]'    oddity verify '[3.5]' -s    oddity verify -r markdown -o "
      "report.md",
      [&] {
        const auto words = app.get_subcommand("verify")->remaining();
        require_test_specifications(words);
        s.status = s.suite({words, s.folder, s.results, s.approve});
      });
  add_path(*verify, "--results", s.results, "also keep the results in this file, as JSON");
  verify->add_flag("--approve", s.approve,
                   "put what this run finds for the selected exercises on record: verdicts, limits and maps");
  verify->allow_extras();
}

void add_solve(CLI::App& app, Session& s) {
  auto* solve = verb(app, "solve", "solve one exercise: every quantity by every method",
                     "Example: oddity solve 3.5 a=150deg L=50cm",
                     [&] { verbs::solve(s.folder, s.exercise, s.overrides, s.format()); });
  add_one_exercise(*solve, s);
  solve->add_flag("--json", s.json, "print the results as JSON");
}

void add_choose(CLI::App& app, Session& s) {
  auto* choose = verb(
      app, "choose", "choose the model, algorithm and step for a need",
      "Errors are judged at every frame. A one-step method of fixed step, or a closed form, that holds with "
      "a "
      "margin of three is taken, the cheapest of them; of those that cost the same within a quarter, the "
      "most "
      "accurate. It is chosen on the start asked for and two beside it, and tested on three others. The exit "
      "code "
      "is 1 when nothing meets the need.\n"
      "Example: oddity choose 3.5 a=60deg --error 1deg --horizon 10 --fps 60 --budget 5us",
      [&] {
        s.status =
            verbs::choose(s.folder, s.exercise, s.overrides, s.need, s.format(), s.all_rows, s.command);
      });
  add_one_exercise(*choose, s);
  auto* error = choose->add_option("--error", s.need.error,
                                   "largest error of the observables: 0.01 in their units, 1cm, 1cm,1deg; of "
                                   "energy and period a fraction, such as 0.01; of a constraint a length");
  choose->add_option("--digits", s.need.digits, "instead: correct digits of the largest observable")
      ->excludes(error);
  choose
      ->add_option("--horizon", s.need.horizon,
                   "how far ahead [s, or the scene's own unit]: 10, 1h; at most a million frames")
      ->capture_default_str();
  choose->add_option("--fps", s.need.frames_per_second, "frames per second: 60, 60Hz")->capture_default_str();
  choose->add_option("--budget", s.need.budget, "at most this time per frame: 5us, 300ns, 0.1ms");
  choose
      ->add_option(
          "--criterion", s.need.criterion,
          "what has to hold: path, energy (what is conserved), period, bounded (nothing explodes), or "
          "constraint (held lengths)")
      ->capture_default_str();
  choose->add_flag("--cheapest", s.need.cheapest, "take whatever is cheapest, however complicated");
  choose->add_flag("--one-step", s.need.one_step, "take no method that needs a history");
  choose
      ->add_option(
          "--precision", s.need.precision,
          "what it may compute in: float, double or any; in float there are closed forms and explicit "
          "algorithms of fixed step")
      ->capture_default_str();
  choose->add_option("--only", s.need.only, "only models and algorithms with these words in their names");
  choose->add_option("--exclude", s.need.exclude, "no models or algorithms with these words");
  choose->add_option("--time-limit", s.need.time_limit, "at most this long for the answer: 60s");
  choose->add_flag("--measure", s.need.measure,
                   "times anew: those of an earlier run are kept, so that the same question gets the same "
                   "answer");
  choose->add_flag("--all", s.all_rows, "all rows of the table");
  add_formats(*choose, s, "the choice");
  auto* code = choose->add_flag("--code", s.code, "the chosen model and loop as C++ to paste");
  for (const char* other : {"--json", "--csv"}) code->excludes(choose->get_option(other));
}

void add_report(CLI::App& app, Session& s) {
  auto* report = verb(
      app, "report", "write the Markdown report, from the last results if they are fresh",
      "Example: oddity report --chapter 3 --out /tmp/report",
      [&] { verbs::report(s.folder, s.chapter, s.book ? Edition::book : Edition::whole, s.report_out); });
  report->add_option("--chapter", s.chapter, "the exercises of one chapter only");
  report->add_flag("--book", s.book, "without times: what stands in report/book of the sources");
  add_path(*report, "--out", s.report_out, "folder to write to");
}

void add_site(CLI::App& app, Session& s) {
  auto* site = verb(app, "site", "write the report that runs: one folder, opened by double click",
                    "Example: oddity site --out /tmp/site", [&] { verbs::site(s.folder, s.site_out); });
  add_path(*site, "--out", s.site_out, "folder to write to");
}

void add_chart(CLI::App& app, Session& s) {
  auto* chart =
      verb(app, "chart", "draw error against work and against time, with the tables",
           "Example: oddity chart 3.5 2.13 --out /tmp/charts",
           [&] { verbs::chart(s.folder, s.exercises, s.all_rows ? Curves::all : Curves::few, s.chart_out); });
  chart->add_flag("--all", s.all_rows, "every method's curve, not eight at most");
  chart->add_option("exercises", s.exercises, "their numbers, such as 3.5; none: all");
  add_path(*chart, "--out", s.chart_out, "folder to write to");
}

void add_stability(CLI::App& app, Session& s) {
  auto* stability = verb(app, "stability", "show where methods break: by step, and over a parameter",
                         "Example: oddity stability 3.5 --out /tmp/maps", [&] {
                           if (s.rows)
                             verbs::stability_rows(s.folder, s.exercises);
                           else if (s.format() != verbs::Format::text)
                             verbs::stability_table(s.folder, s.exercises, s.format());
                           else
                             verbs::stability(s.folder, s.exercises, s.maps_out);
                         });
  stability->add_option("exercises", s.exercises, "their numbers, such as 3.5; none: all that have a motion");
  add_formats(*stability, s, "the limits, nothing drawn,");
  auto* rows =
      stability->add_flag("--rows", s.rows, "the rows of limits.csv and stability_maps.csv, nothing drawn");
  auto* out = add_path(*stability, "--out", s.maps_out, "folder to draw the maps in");
  for (const char* instead : {"--rows", "--json", "--csv"}) out->excludes(stability->get_option(instead));
  for (const char* other : {"--json", "--csv"}) rows->excludes(stability->get_option(other));
}

void add_new(CLI::App& app, Session& s) {
  auto* begin =
      verb(app, "new", "begin an exercise of your own: files that compile, and say what is to be written",
           "It needs a number that is free: even ones, other chapters. Nothing is overwritten.\n"
           "Examples: oddity new 3.2 spring_pendulum    oddity new 9.2 law_of_cosines --identity    "
           "oddity new 20.1 comet --topic space --in ~/exercises",
           [&] {
             s.begun.in = s.outside;
             s.begun.scene = !s.identity;
             verbs::create(s.begun);
           });
  begin->add_option("number", s.begun.number, "such as 3.2")->required();
  begin->add_option("slug", s.begun.slug, "the name of its folder, such as spring_pendulum")->required();
  auto* scene = begin->add_flag("--scene", s.scene,
                                "a motion, with models, methods and claims; so without either word");
  begin->add_flag("--identity", s.identity, "claims alone")->excludes(scene);
  begin->add_option("--topic", s.begun.topic, "for a chapter that has no folder: its name");
  add_path(*begin, "--in", s.outside,
           "a folder outside the tree, in which ODDITY_OWN has the build find the exercise");
}

std::vector<std::string> names_of_verbs(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* one : app.get_subcommands({})) names.push_back(one->get_name());
  return names;
}

void require_verb(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> names = names_of_verbs(app);
  if (std::ranges::find(names, word) != names.end()) return;
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  throw BadInput("no verb '" + word + "'; the verbs are: " + all + did_you_mean(word, names));
}

/// The command line without the program; "help solve" is "solve --help".
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words.front() == "help") {
    words.erase(words.begin());
    words.insert(words.begin() + (words.empty() ? 0 : 1), "--help");
  }
  return words;
}

/// The words as a shell takes them.
std::string typed(const std::vector<std::string>& words) {
  std::string all = "oddity";
  for (const std::string& word : words) {
    std::string quoted;
    for (char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    const bool plain = std::ranges::all_of(word, [](unsigned char c) {
      return std::isalnum(c) || c >= 0x80 ||
             std::string_view("-_=.,:/+%@").find(static_cast<char>(c)) != std::string_view::npos;
    });
    all += " " + (plain && !word.empty() ? word : "'" + quoted + "'");
  }
  return all;
}

/// The main job: verify everything and write the report.
int all_of_it(const Session& s) {
  const int verdict = s.suite({{}, s.folder, results_file()});
  verbs::report(s.folder, "", Edition::whole, s.report_out);
  return verdict;
}

std::string refusal(const CLI::App& app, const std::string& taker, const std::string& word) {
  std::vector<std::string> options;
  for (const CLI::Option* option : app.get_options()) options.push_back(option->get_name());
  const std::string meant = word.starts_with('-') ? did_you_mean(word, options) : "";
  return taker + " does not take '" + word + "'" + meant + (meant.empty() ? "; '" : " '") + taker +
         " --help' says more";
}

/// The first word that is no option of the program's own is its verb.
void require_a_verb(const CLI::App& app, const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with('-')) return require_verb(app, words[i]);
    if (!app.get_option_no_throw(words[i].substr(0, words[i].find('='))))
      throw BadInput(refusal(app, "oddity", words[i]));
    if (words[i] == "--reference") ++i;
  }
}

/// What CLI11 complains of, in the program's words.
std::string complaint_of(const CLI::App& app, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  const CLI::App& verb = used.empty() ? app : *used.front();
  const std::string taker = used.empty() ? "oddity" : "oddity " + verb.get_name();
  const std::vector<std::string> unknown = verb.remaining();
  if (!unknown.empty()) return refusal(verb, taker, unknown.front());
  const std::string says = error.what();
  const bool lacks_value = error.get_name() == "ArgumentMismatch";
  return (lacks_value ? says.substr(0, says.find(':')) + " needs a value" : says) + "; '" + taker +
         " --help' says more";
}

/// Standard streams that are closed are opened such that writing fails: no file may take their place.
void occupy_standard_streams() {
  for (int stream : {0, 1, 2})
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
}

/// Standard output took all that was printed; else says so.
bool output_arrived() {
  errno = 0;
  std::cout.flush();
  if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
  std::cerr << "oddity: cannot write to standard output"
            << (errno == 0 ? "" : ": " + std::error_code(errno, std::generic_category()).message()) << "\n";
  return false;
}

int answer(CLI::App& app, Session& session, const std::vector<std::string>& words) {
  try {
    require_a_verb(app, words);
    std::vector<std::string> reversed(words.rbegin(), words.rend());  // as CLI11 wants them
    app.parse(reversed);
    return app.get_subcommands().empty() ? all_of_it(session) : session.status;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::cerr << "oddity: " << complaint_of(app, error) << "\n";
    return 2;
  } catch (const BadInput& error) {
    std::cerr << "oddity: " << error.what() << "\n";
    return 2;
  } catch (const std::filesystem::filesystem_error& error) {
    std::cerr << "oddity: " << error.path1().string() << ": " << error.code().message() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "oddity: internal error: " << error.what() << "\n";
    return 1;
  }
}

}  // namespace

int command_line(int argc, char** argv, const Suite& suite) {
  occupy_standard_streams();
  tidy_when_interrupted();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a write that fails
  CLI::App app(
      "oddity: the solutions of Game Physics, 2nd edition, checked by machine.\n"
      "Without a verb: verify everything and write the report.",
      "oddity");
  Session session{suite};
  app.set_version_flag("-v,--version", version());
  add_path(app, "--reference", session.folder, "folder of the reference tables");
  app.require_subcommand(0, 1);
  add_list(app, session);
  add_verify(app, session);
  add_solve(app, session);
  add_chart(app, session);
  add_stability(app, session);
  add_choose(app, session);
  verb(app, "bench", "measure how fast this build is: loops by hand, best methods, the suite",
       "Times mean something only on an idle machine. The exit code is 1 when a limit is broken.\n"
       "Example: oddity bench",
       [&] { session.status = verbs::bench(session.folder); });
  add_report(app, session);
  add_site(app, session);
  add_new(app, session);
  verb(app, "help", "show this help, or that of a verb", "Example: oddity help choose", [] {});
  session.command = typed(words_of(argc, argv));
  const int status = answer(app, session, words_of(argc, argv));
  return output_arrived() ? status : 2;
}

}  // namespace oddity
