#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "report/pages/closing_screen.hpp"
#include "report/study/findings.hpp"
#include "report/text/readable.hpp"
#include "report/text/table_text.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"
#include "tests/run_of_all.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace program;

#ifndef SKIP  // in Catch2 since 3.3
#define SKIP(why) \
  do {            \
    WARN(why);    \
    return;       \
  } while (false)
#endif

namespace {

constexpr const char* no_terminals =
    "skipped: there are no pseudo-terminals here, as devpts is not mounted on /dev/pts";

const Screen narrow{20, false}, coloured{40, true};

std::size_t widest_line(const std::string& text) {
  std::string lines = text;
  std::ranges::replace(lines, '\r', '\n');  // a carriage return overwrites a line
  std::istringstream in(lines);
  std::size_t widest = 0;
  for (std::string line; std::getline(in, line);) widest = std::max(widest, columns_of(line));
  return widest;
}

std::string without_colour(const std::string& text) {
  return std::regex_replace(text, std::regex("\x1b\\[[0-9;]*m"), "");
}

const std::vector<std::vector<std::string>> table{
    {"model", "algorithm", "error", "outcome"},
    {"one angle", "Runge-Kutta 4", "0.01", "ok"},
    {"one angle", "velocity Verlet", "0.02", "ok"},
    {"two", "velocity Verlet", "0.02", "raised: it is at an end"}};

/// The columns of a table of comma-separated values, from its first line.
std::vector<std::string> columns_in(const std::string& csv) {
  std::istringstream line(csv.substr(0, csv.find('\n')));
  std::vector<std::string> columns;
  for (std::string column; std::getline(line, column, ',');) columns.push_back(column);
  return columns;
}

}  // namespace

TEST_CASE("a screen counts letters, not bytes, colours or accents", "[terminal]") {
  CHECK(columns_of("abc") == 3);
  CHECK(columns_of("θ₀ = 30°") == 8);
  CHECK(columns_of("x\u0304y") == 2);
  CHECK(columns_of(coloured.styled(Style::bad, "abc")) == 3);
  CHECK(coloured.styled(Style::bad, "abc") == "\x1b[31mabc\x1b[0m");
  CHECK(narrow.styled(Style::bad, "abc") == "abc");
  CHECK(cut("abcdef", 6) == "abcdef");
  CHECK(cut("abcdef", 5) == "ab...");
  CHECK(cut("θθθθθθ", 5) == "θθ...");
  CHECK(cut("abcdef", 2) == "..");
  CHECK(cut(coloured.styled(Style::good, "abcdef"), 5) == "\x1b[32mab\x1b[0m...");
  CHECK(cut_at_word("the pendulum swings", 19) == "the pendulum swings");
  CHECK(cut_at_word("the pendulum swings", 17) == "the pendulum...");
  CHECK(cut_at_word("the pendulum, swinging", 17) == "the pendulum...");
  CHECK(cut_at_word("a 0123456789012345", 10) == "a 01234...");
}

TEST_CASE("text is broken between words", "[terminal]") {
  const std::string text = "  the first line has seven words\nshort\n\n";
  CHECK(wrapped(text, {}) == text);
  CHECK(wrapped(text, narrow, 4) == "  the first line has\n    seven words\nshort\n\n");
  CHECK(wrapped("one two", {3, false}) == "one\ntwo");
  CHECK(wrapped("unbreakable", {3, false}) == "unbreakable");
}

TEST_CASE("a table that is too wide is narrowed", "[terminal]") {
  const std::string whole = aligned(table);
  CHECK(whole ==
        "  model      algorithm        error  outcome\n"
        "  one angle  Runge-Kutta 4    0.01   ok\n"
        "  one angle  velocity Verlet  0.02   ok\n"
        "  two        velocity Verlet  0.02   raised: it is at an end\n");
  const Fitting fit{{"algorithm", "outcome"}, {"error"}};
  CHECK(aligned(table, {}, fit) == whole);
  CHECK(aligned(table, {60, false}, fit) == whole);
  CHECK(aligned(table, {52, false}, fit) ==
        "  model      algorithm        error  outcome\n"
        "  one angle  Runge-Kutta 4    0.01   ok\n"
        "  one angle  velocity Verlet  0.02   ok\n"
        "  two        velocity Verlet  0.02   raised: it i...\n");
  CHECK(aligned(table, {45, false}, fit) ==
        "  model      algorithm        outcome\n"
        "  one angle  Runge-Kutta 4    ok\n"
        "  one angle  velocity Verlet  ok\n"
        "  two        velocity Verlet  raised: it i...\n"
        "  (too wide for this screen: error)\n");
  CHECK(aligned(table, {45, false}, {{"outcome"}, {}, true}) ==
        "  algorithm          error  outcome\n"
        "  one angle:\n"
        "    Runge-Kutta 4    0.01   ok\n"
        "    velocity Verlet  0.02   ok\n"
        "  two:\n"
        "    velocity Verlet  0.02   raised: it is ...\n");
}

TEST_CASE("no text of the exercises shows TeX on a terminal", "[terminal]") {
  for (const ExerciseResult& e : run_of_all().exercises) {
    for (const Root& root : e.roots) CHECK(readable(root.shows).find_first_of("\\{}") == std::string::npos);
    for (const JudgedClaim& c : e.claims) {
      const std::string text = readable(c.claim.says);
      INFO(c.claim.id << ": " << text);
      CHECK(text.find('\\') == std::string::npos);
    }
  }
}

TEST_CASE("every exercise of the book with a finding has a verdict by its author", "[terminal]") {
  for (const ExerciseResult& e : run_of_all().exercises) {
    INFO(to_string(e.number));
    CHECK((!e.verdict.empty() || findings_of(e).empty()));
  }
}

TEST_CASE("a run ends with a screen of checks, findings and files to open", "[terminal]") {
  const Results& results = run_of_all();
  const Closing closing{true, 61.5, "/site/index.html", "/report/README.md"};
  for (const std::size_t width : {50u, 60u, 80u, 100u, 200u}) {
    const std::string screen = closing_screen(results, closing, {width, true});
    INFO(screen);
    CHECK(widest_line(screen) <= std::min<std::size_t>(width, 120));
    CHECK(screen.find("\x1b[32m643 confirmed\x1b[0m") != std::string::npos);
  }
  const std::string plain = closing_screen(results, closing, {});
  INFO(plain);
  CHECK(plain.find('\x1b') == std::string::npos);
  CHECK(plain.find("...") == std::string::npos);  // no finding is cut off
  for (const char* part :
       {"48 exercises, 837 claims, 186 quantities in",
        "56 wrong, 22 incomplete, 39 misprints, 62 lost in our", "\n  3.5   A pendulum of 1 m takes 0.51 s",
        "and 48 others", "/site/index.html", "/report/README.md",
        "All results match the approved records, after 1 minute 2 seconds."})
    CHECK(plain.find(part) != std::string::npos);
  Results scenes = results;
  Candidate candidate{};
  candidate.algorithm = "closed form";
  CheapestModel least{"1 degree", {}, candidate};
  scenes.exercises[0].cheapest_models = CheapestModels{{"rad"}, {least}, {}, {}};
  scenes.exercises[1].cheapest_models = scenes.exercises[0].cheapest_models;
  least.least->algorithm = "Runge-Kutta 4";
  least.least->resolution = "step";
  scenes.exercises[2].cheapest_models = CheapestModels{{"rad"}, {least}, {}, {}};
  CHECK(
      closing_screen(scenes, closing, {}).find("\n  a closed form in 2 scenes, Runge-Kutta 4 in 1 scene\n") !=
      std::string::npos);
  CHECK(plain.find("every scene in motion") != std::string::npos);
  CHECK(plain.find("lacks") == std::string::npos);
  const Closing lacking{
      true, 1, "", "", "./oddity", {"the models: nothing moves"}, "apt-get install clang && ./oddity site"};
  const std::string told = closing_screen(results, lacking, {});
  INFO(told);
  CHECK(told.find("every scene in motion") == std::string::npos);
  CHECK(
      told.find(
          "\nThe site lacks\n  the models: nothing moves\n  a whole one is made by: apt-get install clang && "
          "./oddity site\n") != std::string::npos);
  CHECK(closing_screen(scenes, lacking, {}).find("start and budget of your own: ./oddity choose\n") !=
        std::string::npos);
  CHECK(closing_screen(results, {false, 1, "", ""}, {}).find("Results differ from the approved records") !=
        std::string::npos);
  CHECK(closing_screen({}, closing, {}).find("0 exercises, 0 claims") != std::string::npos);
}

TEST_CASE("all output fits the terminal", "[terminal]") {
  if (!has_terminals()) SKIP(no_terminals);
  const ScratchFolder scratch;
  const std::string maps = scratch.path().string();
  for (const int width : {50, 60, 80})
    for (const std::string& arguments :
         std::vector<std::string>{"list", "solve 3.5", "solve 5.5", "stability 3.5 --out " + maps,
                                  "choose 3.31 --error 1cm,1deg --horizon 1 --all", "sovle", "solve 3.5 b=1",
                                  "--help", "choose --help", "verify --help", "bench --help", "new --help"}) {
      const Ran ran = on_terminal(width, arguments + " 2>&1");
      INFO(arguments << "\n" << ran.output);
      CHECK(widest_line(ran.output) <= static_cast<std::size_t>(width));
      CHECK(ran.output.size() > 20);
    }
}

TEST_CASE("colour is for terminals, and off when the user wants none", "[terminal]") {
  if (!has_terminals()) SKIP(no_terminals);
  for (const std::string arguments : {"solve 3.5", "verify '[9.1]'", "list 3.5"}) {
    const std::string plain = printed(arguments).output;
    const auto has_colour = [](const Ran& ran) { return says(ran, "\x1b["); };
    INFO(arguments);
    CHECK_FALSE(has_colour(run(arguments)));
    CHECK(has_colour(on_terminal(300, arguments)));
    CHECK_FALSE(has_colour(on_terminal(300, arguments, "NO_COLOR=1")));
    CHECK_FALSE(has_colour(on_terminal(300, arguments, "NO_COLOR=1 CLICOLOR_FORCE=1")));
    CHECK_FALSE(has_colour(on_terminal(300, arguments, "TERM=dumb")));
    const Ran forced = shell("CLICOLOR_FORCE=1 $oddity " + arguments);
    CHECK(has_colour(forced));
    CHECK_FALSE(has_colour(shell("CLICOLOR_FORCE=0 $oddity " + arguments)));
    CHECK_FALSE(has_colour(shell("CLICOLOR_FORCE=1 NO_COLOR=1 $oddity " + arguments)));
    if (arguments == "list 3.5") CHECK(without_colour(forced.output) == plain);
  }
}

TEST_CASE("tables are available as CSV and as JSON, and help names their columns", "[terminal]") {
  for (const std::string arguments : {"list 3.5", "verify '[3.5]'", "chart 3.5", "stability 3.5", "solve 3.5",
                                      "choose 3.5 --error 1deg --horizon 1"}) {
    INFO(arguments);
    const Ran csv = printed(arguments + " --csv"), json = printed(arguments + " --json");
    CHECK(csv.status == 0);
    CHECK(json.status == 0);
    const std::string help = std::regex_replace(
        run(arguments.substr(0, arguments.find(' ')) + " --help").output, std::regex("\n *"), " ");
    for (const std::string& column : columns_in(csv.output)) {
      INFO(column << " in\n" << help);
      const bool unit = column.starts_with("error [");
      CHECK(help.find(unit ? "error [unit]" : column) != std::string::npos);
    }
    const auto read = nlohmann::json::parse(json.output);
    if (read.is_array()) {
      CHECK(std::count(csv.output.begin(), csv.output.end(), '\n') == static_cast<long>(read.size()) + 1);
      CHECK(read.front().size() == columns_in(csv.output).size());
    } else if (arguments.starts_with("choose")) {
      for (const auto& [key, value] : read.items()) CHECK(help.find(key) != std::string::npos);
    }
  }
  CHECK(says(run("verify '[3.5]' --csv"), "\n3.5,3.5-value,"));
  CHECK(says(run("verify '[3.5]' --csv"), ",wrong,wrong,"));
  CHECK(says(run("chart 3.5 --csv"),
             "\n3.5,quarter_period,sqrt(L/2g),singular integrand,QAGS,double,tolerance,0.01,"));
}

TEST_CASE("a long run reports its progress, on a terminal in one line", "[terminal]") {
  if (!has_terminals()) SKIP(no_terminals);
  const std::string question = "choose 3.25 --error 1mm --horizon 31 --fps 600 --thorough --time-limit 8s";
  const Ran terminal = on_terminal(40, question);
  INFO(terminal.output);
  CHECK(terminal.status == 2);
  CHECK(says(terminal, "\roddity: "));
  std::string lines = terminal.output;
  std::ranges::replace(lines, '\n', '\r');
  std::istringstream updates(lines);
  for (std::string update; std::getline(updates, update, '\r');) CHECK(columns_of(update) <= 40);
  const Ran piped = run(question);
  INFO(piped.output);
  CHECK_FALSE(says(piped, "\r"));
  CHECK_FALSE(says(run("list 3.5"), "oddity: "));
}

TEST_CASE("the completion knows the commands, their options and the exercises, and runs nothing",
          "[terminal]") {
  const auto completed = [](const std::string& words) {
    return shell("bash -c 'source <('$oddity' --completion); PATH=; COMP_WORDS=(/none/oddity " + words +
                 "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _oddity; echo ${COMPREPLY[*]}'")
        .output;
  };
  const std::string verbs =
      "list verify solve chart stability choose bench engines sweep prove trust report site new help\n";
  CHECK(completed("\"\"") == verbs);
  CHECK(completed("help \"\"") == verbs);
  CHECK(completed("solve --") == "--help --enclosed --json --csv\n");
  CHECK(completed("solve 3.3") == "3.3 3.31 3.33 3.35\n");
  CHECK(completed("sweep \"\"") == "plan run status merge draw\n");
  CHECK(completed("sweep merge /tmp/map --o") == "--out\n");
}

TEST_CASE("the manual page has every command and no path of this build", "[terminal]") {
  const Ran made = run("--manual");
  CHECK(made.status == 0);
  for (const char* verb : {"list", "verify", "solve", "chart", "stability", "choose", "bench", "engines",
                           "sweep", "sweep plan", "prove", "trust", "report", "site", "new"})
    CHECK(says(made, ".SS " + std::string(verb) + "\n"));
  CHECK(says(made, ".TP\n.B \\-\\-horizon TIME=10\n"));
  CHECK_FALSE(says(made, ODDITY_SOURCE "/"));
}

TEST_CASE("a command reports its missing needs once its arguments are valid, and does nothing",
          "[terminal]") {
  const ScratchFolder scratch;
  const std::string out = (scratch.path() / "out").string();
  CHECK(run("--needs").output ==
        "package clang\npackage lld\npackage libc++-dev-wasm32\npackage libclang-rt-dev-wasm32\n"
        "target models_module\n");
  CHECK(run("--needs site --out " + out).output == run("--needs").output);
  CHECK(run("--needs prove 3.5 --out " + out).output ==
        "package coq\npackage libcoq-interval\npackage libcoq-coquelicot\n");
  CHECK(says(run("--needs engines 3.5"), "npm extras/engines/adapters\ntarget engines\n"));
  CHECK(run("--needs choose 3.5 --error 1deg --bodies 10").output == "target oddity_lanes\n");
  CHECK(run("--needs bench --lanes 3.5").output == "target oddity_lanes\n");
  for (const char* nothing : {"engines 3.5 --kept", "choose 3.5 --error 1deg", "bench", "bench --verbs",
                              "list", "solve 3.5", "verify '[3.5]'", "new 3.2 spring_pendulum"}) {
    INFO(nothing);
    const Ran ran = run("--needs " + std::string(nothing));
    CHECK(ran.output.empty());
    CHECK(ran.status == 0);
  }
  for (const char* bad : {"prove 9.99", "engines 9.99", "engines --hz 61", "choose 3.5 --error x",
                          "choose 3.5 --bodies 10 a=x", "bench --lanes 9.99", "sweep merge " ODDITY_SOURCE,
                          "sweep merge /none --out map.txt", "site --nonsense"}) {
    INFO(bad);
    const Ran ran = run("--needs " + std::string(bad));
    CHECK(ran.status == 2);
    CHECK(ran.output.starts_with("oddity: "));
    CHECK_FALSE(says(ran, "package "));
  }
}

TEST_CASE("one body needs no lanes: every form of its answer comes from the program alone", "[terminal]") {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;  // as installed
  const fs::path prefix = scratch.path();
  fs::create_directories(prefix / "bin");
  fs::create_directories(prefix / "share/oddity");
  fs::copy(ODDITY_PROGRAM, prefix / "bin/oddity");
  fs::copy(ODDITY_SOURCE "/reference", prefix / "share/oddity/reference", fs::copy_options::recursive);
  const std::string choose =
      "HOME=" + prefix.string() + " " + (prefix / "bin/oddity").string() + " choose 3.5 --error 1deg ";
  for (const char* form : {"--json", "--csv", "--code", ""}) {
    INFO(form);
    const Ran ran = shell(choose + "--exclude closed " + form);
    CHECK(ran.status == 0);
    CHECK_FALSE(says(ran, "without its models in lanes"));
  }
  CHECK(says(shell(choose + "--bodies 10"), "without its models in lanes"));
}
