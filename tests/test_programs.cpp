// The short programs of `choose --code`, in each language, run beside the program itself.

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "chapters/scene.hpp"
#include "report/pages/code.hpp"
#include "report/study/recorded_model.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/printed.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::printed;

namespace {

struct Case {
  std::string says, code;
  Value value;
};

/// Every method of the scenes that has a program, and why others have none.
struct All {
  std::vector<Case> cases;
  std::map<std::string, int> refused;
};
All all_in(Language language) {
  All all;
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Task task = task_beside(entry);
    const Quantity second =
        motion(*entry.exercise.scene, task.parameters, {1, 1, frames_per_second}, Reference::nothing());
    for (const Method& method : second.methods) {
      if (!method.knob.name.empty() && method.knob.name != "step") continue;
      Candidate chosen{method.model, method.algorithm, method.knob.name};
      chosen.setting = method.knob.name == "step" ? 1 / (frames_per_second * steps) : 0;
      Case one{to_string(entry.number) + ", " + method.model + ", " + method.algorithm, "", {}};
      const std::string why =
          complaint([&] { one.code = program_in(language, task, chosen, need_of_a_second(), one.says); });
      if (why != "nothing") {
        ++all.refused[why.substr(why.find("choice: ") + 8)];
        continue;
      }
      const Trial trial = run(second, method, chosen.setting);
      if (trial.outcome == Outcome::raised) continue;
      one.value = trial.answer.value;
      all.cases.push_back(std::move(one));
    }
  }
  return all;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  if (const auto at = text.find(from); at != text.npos) text.replace(at, from.size(), to);
  return text;
}

/// All programs as one, which says "case" before each.
std::string together(Language language, const std::vector<Case>& cases) {
  std::set<std::string> heads;
  std::string text, calls;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::string n = std::to_string(i);
    std::string own;
    std::istringstream lines(cases[i].code);
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("#") || line.starts_with("using System"))
        heads.insert(line);
      else
        own += line + "\n";
    if (language == Language::javascript) {
      text += "console.log('case');\n{\n" + own + "}\n";
    } else if (language == Language::c_sharp) {
      text += replaced(replaced(own, "class Motion", "class Motion" + n), "static void Main",
                       "public static void Run");
      calls += "Console.WriteLine(\"case\"); Motion" + n + ".Run();\n";
    } else {
      text += "namespace case_" + n + " {\n" + replaced(own, "int main()", "void run()") + "}\n";
      calls += "std::printf(\"case\\n\"); case_" + n + "::run();\n";
    }
  }
  std::string head;
  for (const std::string& line : heads) head += line + "\n";
  if (language == Language::c_sharp) calls = "static class All { static void Main() {\n" + calls + "} }\n";
  if (language == Language::cpp) calls = "int main() {\n" + calls + "}\n";
  return head + text + calls;
}

struct Runs {
  std::string file, compile, run;
};
Runs runs_of(Language language, const std::string& folder) {
  const std::string file = folder + "/all";
  if (language == Language::javascript) return {file + ".js", "true", "node " + file + ".js"};
  if (language == Language::c_sharp)
    return {file + ".cs", "mcs -nologo -warnaserror -out:" + file + ".exe " + file + ".cs",
            "mono " + file + ".exe"};
  return {file + ".cpp",
          std::string(ODDITY_COMPILER) + " -std=c++20 -O1 -ffp-contract=off -Wall -Wextra -Werror -o " +
              file + ".out " + file + ".cpp",
          file + ".out"};
}

/// Runs all programs of a language. A language's library may round functions in its own way.
void check(Language language, double allowed) {
  const All all = all_in(language);
  for (const auto& [why, times] : all.refused) UNSCOPED_INFO(times << " times no program: " << why);
  CHECK(all.cases.size() > 200);
  const ScratchFolder scratch;
  const Runs runs = runs_of(language, scratch.path().string());
  std::ofstream(runs.file) << together(language, all.cases);
  REQUIRE(output_of(runs.compile) == "");
  const auto printed = observables(output_of(runs.run));
  REQUIRE(printed.size() == all.cases.size());
  for (std::size_t i = 0; i < all.cases.size(); ++i) {
    INFO(all.cases[i].says);
    REQUIRE(printed[i].size() >= all.cases[i].value.size());
    CHECK(largest_difference(all.cases[i].value, printed[i]) <= allowed);
  }
}

}  // namespace

TEST_CASE("a short program has the program's numbers, for every scene's models", "[code][programs]") {
  check(Language::cpp, 1e-12);
}

// By the leg `languages`, which installs what runs them.
TEST_CASE("a program in C# has the program's numbers", "[.][languages]") { check(Language::c_sharp, 1e-9); }
TEST_CASE("a program in JavaScript has the program's numbers", "[.][languages]") {
  check(Language::javascript, 1e-9);
}

TEST_CASE("a language is known by its name", "[code][programs]") {
  CHECK(language_of("c#") == Language::c_sharp);
  CHECK(complaint([] { language_of("Lua"); }) ==
        "there is no code in 'Lua'; there is in C++, C#, JavaScript");
}

TEST_CASE("a top's program prints its orientation, whose axis is the one observed", "[code][programs]") {
  std::vector<std::vector<double>> ends;
  for (const char* model : {"one angle, precession by quadrature", "axis and angular momentum"}) {
    Candidate chosen{model, "Runge-Kutta 4", "step"};
    chosen.setting = 1 / (frames_per_second * 8);
    const ScratchFolder scratch;
    const Runs runs = runs_of(Language::cpp, scratch.path().string());
    const Entry& top = *std::ranges::find(registry(), Number{3, 33}, &Entry::number);
    std::ofstream(runs.file) << program_in(Language::cpp, Task(top), chosen, need_of_a_second(), "");
    REQUIRE(output_of(runs.compile) == "");
    std::istringstream last(output_of(runs.run + " | tail -n 1"));
    ends.emplace_back();
    for (std::string cell; std::getline(last, cell, ',');)
      ends.back().push_back(std::strtod(cell.c_str(), nullptr));
    REQUIRE(ends.back().size() == 8);
    const double* axis = &ends.back()[1];
    const double *q = &ends.back()[4], x = 2 * (q[1] * q[3] + q[0] * q[2]),
                 y = 2 * (q[2] * q[3] - q[0] * q[1]);
    CHECK(std::abs(axis[0] - x) < 1e-6);
    CHECK(std::abs(axis[1] - y) < 1e-6);
  }
  for (std::size_t i = 4; i < 8; ++i) CHECK(std::abs(ends[0][i] - ends[1][i]) < 1e-5);
}
