// The code printed by `choose --code`, compiled, run and compared with the program.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>

#include "chapters/scene.hpp"
#include "problem/scene.hpp"
#include "report/pages/code.hpp"
#include "report/study/embedded.hpp"
#include "report/study/frames.hpp"
#include "report/text/used_code.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/printed.hpp"
#include "tests/properties.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::printed;

namespace {

/// A scene's method as a choice for one second, or one of the scene's units of time.
struct Case {
  Task task;
  Choice choice;
  Value value;             ///< by the program
  double allowed = 1e-12;  ///< relative to the largest value so far
};

std::string says(const Case& c) {
  return to_string(c.task.entry->number) + ", " + c.choice.chosen->model + ", " + c.choice.chosen->algorithm;
}

Choice choice_of(const Method& method) {
  Choice choice;
  choice.need = need_of_a_second();
  choice.quantity = "motion";
  choice.time_unit = "s";
  choice.chosen = Candidate{method.model, method.algorithm, method.resolution.name};
  choice.chosen->setting = method.resolution.name == "step" ? 1 / (frames_per_second * steps) : 0;
  choice.chosen->unseen_error = 0.5;
  choice.chosen->precision = method.precision;
  return choice;
}

Quantity second_of(const Task& task) {
  return motion(*task.entry->exercise.scene, task.parameters, {1, 1, frames_per_second},
                Reference::nothing());
}

std::string complaint_of(const Task& task, const Method& method) {
  return complaint([&] { code_of(task, choice_of(method), ""); });
}

bool steps_equally(const Method& m) { return m.resolution.name.empty() || m.resolution.name == "step"; }

/// The scenes of the book and of the examples' files.
std::vector<const Entry*> all_scenes() {
  std::vector<const Entry*> all;
  for (const Entry& entry : registry())
    if (entry.exercise.scene) all.push_back(&entry);
  const auto folder = std::filesystem::path(ODDITY_SOURCE) / "chapters" / "examples" / "problems";
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().extension() == ".toml")
      if (const Entry& entry = problem::entry_of_file(file.path().string()); entry.exercise.scene)
        all.push_back(&entry);
  return all;
}

/// Possible growth of roundings of a file's parameters: its code computes in another order.
double grown_rounding(const Case& c, const Method& method) {
  Task nudged = c.task;
  for (const Parameter& p : nudged.entry->exercise.parameters)
    if (!p.whole) nudged.parameters.set(p.name, c.task.parameters[p.name] * (1 - 0x1p-52));
  const Quantity second = second_of(nudged);
  for (const Method& m : second.methods)
    if (m.model == method.model && m.algorithm == method.algorithm) {
      const Value value = run(second, m, c.choice.chosen->setting).answer.value;
      std::vector<double> other;
      for (std::size_t k = 0; k < value.size(); ++k) other.push_back(value[k]);
      return 1000 * largest_difference(c.value, other);
    }
  return 0;
}

/// Every method that can be printed, of every scene.
std::vector<Case> all_cases() {
  std::vector<Case> all;
  for (const Entry* entry : all_scenes()) {
    const Task task = task_of_source(*entry);
    std::set<std::pair<std::string, std::string>> seen;
    const Quantity second = second_of(task);
    std::vector<Method> methods = second.methods;
    methods.insert(methods.end(), second.methods_in_float.begin(), second.methods_in_float.end());
    for (const Method& method : methods) {
      if (complaint_of(task, method) != "nothing" || !steps_equally(method)) continue;
      if (!seen.insert({method.model, method.algorithm}).second) continue;
      Case c{task, choice_of(method), {}};
      const Trial trial = run(second, method, c.choice.chosen->setting);
      if (trial.outcome == Outcome::raised) continue;
      c.value = trial.answer.value;
      if (method.precision == Precision::in_float) c.allowed = 0x1p-20;
      if (entry->exercise.scene->listing.text) c.allowed = std::max(c.allowed, grown_rounding(c, method));
      all.push_back(c);
    }
  }
  return all;
}

/// The file in a separate namespace, without its includes.
struct Part {
  std::set<std::string> includes;
  std::string text;
};

Part part(const std::string& code, std::size_t number) {
  Part part{{}, "namespace case_" + std::to_string(number) + " {\n"};
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#"))
      part.includes.insert(line);
    else
      part.text += (line == "int main() {" ? "void main() {" : line) + "\n";
  part.text += "}\n";
  return part;
}

std::string program(const std::vector<Case>& cases) {
  std::set<std::string> includes;
  std::string text, calls;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Part one = part(code_of(cases[i].task, cases[i].choice, "oddity"), i);
    includes.insert(one.includes.begin(), one.includes.end());
    text += one.text;
    calls += "  std::printf(\"case\\n\");\n  case_" + std::to_string(i) + "::main();\n";
  }
  std::string all;
  for (const std::string& include : includes) all += include + "\n";
  return all + text + "int main() {\n" + calls + "}\n";
}

std::string compiled(const std::filesystem::path& file, const std::string& options) {
  return output_of(std::string(ODDITY_COMPILER) +
                   " -std=c++20 -ffp-contract=off -Wall -Wextra -Werror -Wno-missing-braces " + options +
                   " -o " + file.string() + ".out " + file.string());
}

/// Requires that the printed code of each case has its value.
void check_printed(const std::vector<Case>& cases) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "all.cpp";
  std::ofstream(file) << program(cases);
  REQUIRE(compiled(file, "-O2") == "");
  const auto printed = observables(output_of(file.string() + ".out"));
  REQUIRE(printed.size() == cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    INFO(says(cases[i]));
    const Value& value = cases[i].value;
    REQUIRE(value.size() > 0);
    REQUIRE(printed[i].size() >= value.size());
    CHECK(largest_difference(value, printed[i]) <= cases[i].allowed);
  }
}

/// Every printable method of the scenes at frames of different lengths, with one step a frame and with
/// shorter ones.
std::vector<Case> cases_at_frames(std::initializer_list<std::string_view> scenes) {
  std::vector<Case> all;
  Need need = need_of_a_second();
  need.frame_times = oddity::frame_times({.jitter = 0.3, .drop = 0.1}, frames_per_second, need.horizon);
  for (const std::string_view scene : scenes) {
    const Task task(properties::entry_of(scene));
    const Quantity second = motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need),
                                             Reference::nothing());
    for (const Method& method : second.methods)
      for (const double setting : {need.frame_times->longest, 1 / (frames_per_second * steps)}) {
        Case c{task, choice_of(method), {}, 1e-9};
        c.choice.need = need;
        if (method.resolution.name == "step") c.choice.chosen->setting = setting;
        if (!steps_equally(method) || complaint([&] { code_of(task, c.choice, ""); }) != "nothing") continue;
        c.value = run(second, method, c.choice.chosen->setting).answer.value;
        all.push_back(std::move(c));
      }
  }
  return all;
}

}  // namespace

TEST_CASE("the printed code has the program's numbers, for every scene, model and algorithm", "[code]") {
  const std::vector<Case> cases = all_cases();
  check_printed(cases);
  CHECK(std::ranges::count(cases, Precision::in_float,
                           [](const Case& c) { return c.choice.chosen->precision; }) > 100);
}

TEST_CASE("the printed code has the program's numbers at frames of different lengths", "[code][frames]") {
  const std::vector<Case> cases = cases_at_frames({"3.5", "3.9"});
  check_printed(cases);
  for (const Stepping stepping : {Stepping::last_step, Stepping::interpolated, Stepping::extrapolated})
    CHECK(std::ranges::count(cases, stepping,
                             [](const Case& c) { return stepping_of(c.choice.chosen->algorithm); }) > 10);
}

TEST_CASE("headers that are printed need the standard library only", "[code]") {
  REQUIRE(embedded_headers().size() > 8);
  for (const EmbeddedFile& header : embedded_headers()) {
    std::istringstream lines{std::string(header.text)};
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("#include <")) {
        INFO(header.path << ": " << line);
        CHECK(line.find_first_of("/.") == std::string::npos);
      }
  }
}

TEST_CASE("standard headers of a printed one are recognized by their functions", "[code]") {
  for (const EmbeddedFile& header : embedded_headers()) {
    std::istringstream lines{std::string(header.text)};
    std::string code;
    std::vector<std::string> included;
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("#include <"))
        included.push_back(line.substr(10, line.find('>') - 10));
      else
        code += line + "\n";
    for (const std::string& standard : included) {
      INFO(header.path << ": " << standard);
      CHECK(needs_standard(standard, code));
    }
  }
}

TEST_CASE("every model of a scene can be printed, or gives a reason", "[code]") {
  for (const Entry* of_scene : all_scenes()) {
    const Entry& entry = *of_scene;
    const Listing& listing = entry.exercise.scene->listing;
    const Quantity second = second_of(Task(entry));
    const auto has = [](const auto& pairs, const std::string& name) {
      return std::ranges::any_of(pairs, [&](const auto& pair) { return pair.first == name; });
    };
    for (const Method& m : second.methods) {
      INFO(to_string(entry.number) << ", " << m.model << ", " << m.algorithm);
      const auto algorithms = printable_algorithms();
      if (std::ranges::find(algorithms, m.algorithm) != algorithms.end())
        CHECK(has(listing.models, m.model) + has(listing.not_printable, m.model) +
                  has(listing.with_own_steps, m.model + ", " + m.algorithm) ==
              1);
    }
    for (const auto& pairs : {listing.models, listing.not_printable, listing.with_own_steps})
      for (const auto& [name, what] : pairs) {
        INFO(to_string(entry.number) << " has no model '" << name << "'");
        CHECK(std::ranges::any_of(second.methods, [&, &name = name](const Method& m) {
          return m.model == name || m.model + ", " + m.algorithm == name;
        }));
      }
  }
}

TEST_CASE("the printed file is complete, with the question, the answer and the command", "[code]") {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "pendulum.cpp";
  const std::string code = output_of(std::string(ODDITY_PROGRAM) +
                                     " choose 3.5 a=1 --error 1deg --horizon 1 --only 'Runge-Kutta 4' "
                                     "--exclude Cartesian --code 2>/dev/null");
  std::ofstream(file) << code;
  CHECK(code.starts_with("// 3.5 Pendulum from 30 degrees: swing within "));
  for (const char* part : {"\n// Take one angle by Runge-Kutta 4, ",
                           "\n//   margin: ", "double a = 1;  // rad: angle at release\n",
                           "//   ./oddity choose 3.5 a=1 --error 1deg --horizon 1 --only 'Runge-Kutta 4' "
                           "--exclude Cartesian --code\n"}) {
    INFO(code);
    CHECK(code.find(part) != std::string::npos);
  }
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#")) CHECK(line.find_first_of("\"./") == std::string::npos);
  REQUIRE(compiled(file, "-O2 -Wpedantic -Wconversion -Wshadow") == "");
  const std::string rows = output_of(file.string() + ".out");
  CHECK(rows.starts_with("t [s],theta\n0.016666666666666666,"));
  CHECK(std::ranges::count(rows, '\n') == 61);
}

TEST_CASE("a request for code that cannot be printed is refused with the methods that can", "[code]") {
  const auto of = [](const Number& exercise, const std::string& model, const std::string& algorithm) {
    const Entry& entry = *std::ranges::find(registry(), exercise, &Entry::number);
    Method method{model, algorithm, no_resolution(), {}};
    return complaint_of(Task(entry), method);
  };
  CHECK(of({3, 5}, "one angle", "Fehlberg 7(8)")
            .starts_with("there is no code to print for the algorithm Fehlberg 7(8); there is for: closed "
                         "form; explicit Euler; "));
  CHECK(of({2, 7}, "matrix, orthonormalized", "Runge-Kutta 4")
            .find("'matrix, orthonormalized', which repairs the orientation after each step; there is for: "
                  "frame; ") != std::string::npos);
  CHECK(of({3, 31}, "stopped by event", "Runge-Kutta 4")
            .find("which needs a search for events; there is for: ") != std::string::npos);
  CHECK(of({3, 19}, "no such model", "Runge-Kutta 4").find("published equations") == std::string::npos);
  CHECK(of({3, 19}, "normal modes", "closed form") == "nothing");
  CHECK(of({3, 31}, "steps with a stick test", "explicit midpoint") == "nothing");
  CHECK(of({3, 5}, "one angle", "Runge-Kutta 4") == "nothing");
}

TEST_CASE("a comment that ends in a backslash does not swallow the next line", "[code]") {
  const std::string name = "test.toml";
  const Entry& entry = problem::entry_of_text(name, R"toml(title = "x"
[parameters]
k = { value = "3 1/s^2", says = "ends so \\" }
[given]
z = "k \\"
[model.a]
equations = ["y'' = -k y"]
start = { y = "1 m", "y'" = 0 }
[observe]
y = "m"
)toml");
  const Task task(entry);
  const Quantity second = second_of(task);
  const Method& method = *method_of(second, "a", "Runge-Kutta 4");
  const std::string code = code_of(task, choice_of(method), "oddity");
  CHECK(code.find("\\\n") == std::string::npos);
  CHECK(code.find("\\.\n") != std::string::npos);
}
