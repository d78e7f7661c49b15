// The short programs of `choose --code`, in each language, against the program itself.

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"
#include "chapters/listing.hpp"
#include "chapters/numbers.hpp"
#include "chapters/scene.hpp"
#include "formula/program.hpp"
#include "report/pages/code.hpp"
#include "report/pages/dialects.hpp"
#include "report/pages/program_parts.hpp"
#include "report/plain/runge_kutta_4.hpp"
#include "report/study/frames.hpp"
#include "report/study/recorded_model.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/stability.hpp"
#include "tests/complaint.hpp"
#include "tests/printed.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
using namespace oddity::printed;

namespace {

/// Most lines of a program that `choose` may choose, without comments and blank ones.
constexpr long most_lines_of_code = 120;

struct Case {
  std::string says, code;
  Value value;
  bool may_be_chosen = true;  ///< unless asked for
};

const Candidate keplers_equation{"Kepler's equation", "Newton from M + 0.85 e", ""};

const Entry& scene(Number number) { return *std::ranges::find(registry(), number, &Entry::number); }

/// The top's rotation matrix by its Euler angles.
heavy_top::Matrix<double> top_after_a_second(const Parameters& p) {
  const heavy_top::EulerAngles<double> top{{p["m"], p["l"], p["mu1"], p["mu3"], p["g"], p["theta"], p["phi"],
                                            p["psi"], p["dtheta"], p["dphi"], p["dpsi"]}};
  plain::RungeKutta4<heavy_top::EulerAngles<double>> algorithm;
  auto x = top.start();
  for (int i = 0; i < 1000; ++i) algorithm.step(top, x, i * 1e-3, 1e-3);
  return heavy_top::rotation(x[0], x[1], x[2]);
}

/// Every method of the scenes that has a program, and why others have none.
struct All {
  std::vector<Case> cases;
  std::map<std::string, int> refused;
};
All all_in(Language language) {
  All all;
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Task task = task_of_source(entry);
    const Quantity second =
        motion(*entry.exercise.scene, task.parameters, {1, 1, frames_per_second}, Reference::nothing());
    for (const Method& method : second.methods) {
      if (!method.resolution.name.empty() && method.resolution.name != "step") continue;
      Candidate chosen{method.model, method.algorithm, method.resolution.name};
      chosen.setting = method.resolution.name == "step" ? 1 / (frames_per_second * steps) : 0;
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
      one.may_be_chosen = !ode::is_multistep(method.algorithm);
      all.cases.push_back(std::move(one));
    }
  }
  return all;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  if (const auto at = text.find(from); at != text.npos) text.replace(at, from.size(), to);
  return text;
}

/// All programs as one, which prints "case" before each.
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

std::string heads_of(const std::string& code) {
  std::string heads;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#")) heads += line + "\n";
  return heads;
}

/// Each program compiled by itself: `together` hides in namespaces which names of C's headers it takes.
void check_alone(const std::vector<Case>& cases) {
  const ScratchFolder scratch;
  const std::string folder = scratch.path().string(), head = folder + "/heads.hpp";
  for (std::size_t i = 0; i < cases.size(); ++i)
    std::ofstream(folder + "/" + std::to_string(i) + ".cpp") << cases[i].code;
  std::ofstream(head) << heads_of(together(Language::cpp, cases));
  const std::string compiler = std::string(ODDITY_COMPILER) + " -std=c++20 ";
  REQUIRE(output_of(compiler + "-x c++-header -o " + head + ".gch " + head) == "");
  CHECK(output_of(compiler + "-fsyntax-only -Wall -Wextra -Wshadow -Werror -include " + head + " " + folder +
                  "/*.cpp") == "");
}

/// Runs all programs of a language. A language's library may round functions in its own way.
void check(Language language, double allowed) {
  const All all = all_in(language);
  for (const auto& [why, times] : all.refused) UNSCOPED_INFO(times << " times no program: " << why);
  CHECK(std::ranges::count_if(all.cases, [](const Case& one) { return finite(one.value); }) > 200);
  const ScratchFolder scratch;
  const Runs runs = runs_of(language, scratch.path().string());
  std::ofstream(runs.file) << together(language, all.cases);
  REQUIRE(output_of(runs.compile) == "");
  const auto printed = observables(output_of(runs.run));
  REQUIRE(printed.size() == all.cases.size());
  for (std::size_t i = 0; i < all.cases.size(); ++i) {
    INFO(all.cases[i].says);
    if (all.cases[i].may_be_chosen) CHECK(lines_of_code(all.cases[i].code) <= most_lines_of_code);
    REQUIRE(printed[i].size() >= all.cases[i].value.size());
    CHECK(largest_difference(all.cases[i].value, printed[i]) <= allowed);
  }
}

}  // namespace

TEST_CASE("a short program has the program's numbers, for every scene's models", "[code][programs]") {
  check(Language::cpp, 1e-12);
}

TEST_CASE("a short program compiles with C's headers, and no name hides another", "[code][programs]") {
  check_alone(all_in(Language::cpp).cases);
}

TEST_CASE("a sum over a table is recorded as a loop", "[programs]") {
  using formula::Recorded;
  constexpr std::array<std::array<double, 2>, 3> table{{{1, 2}, {3, 5}, {-4, 7}}};
  const auto of = [&](const auto& x, const auto& y) {
    using X = std::decay_t<decltype(x)>;
    return sum_over(x, table, [&](const std::array<X, 2>& outer) {
      const auto inner = sum_over(x, table, [&](const std::array<X, 2>& row) {
        return std::array<X, 2>{row[0] * x * outer[1], row[1] * outer[0]};
      });
      return std::array<X, 2>{inner[0] * y, sin(inner[1]) + x};
    });
  };
  formula::Record record;
  const auto x = Recorded::letter(record, "x", 0.5), y = Recorded::letter(record, "y", -2);
  const std::array<Recorded, 2> sums = of(x, y);
  const std::array<double, 2> now = of(0.5, -2.0), later = of(3.0, 0.25);
  const auto later_values = record.values({{"x", 3}, {"y", 0.25}});
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(sums[i].value() == now[i]);
    CHECK(later_values[static_cast<std::size_t>(sums[i].at())] == later[i]);
    CHECK(of(Recorded(0.5), Recorded(-2.0))[i].value() == now[i]);
  }
  formula::Program program(record, {"x", "y"}, {{sums.begin(), sums.end()}}, {});
  const auto made = program.function({sums.begin(), sums.end()});
  CHECK(std::ranges::count_if(
            made.lines, [](const std::string& line) { return line.find("foreach (Row") != line.npos; }) == 2);
  CHECK(program.constants().size() == 2);
}

TEST_CASE("a part of a model that is called twice is printed once, as a function", "[programs]") {
  using formula::Recorded;
  constexpr std::array<std::array<double, 2>, 3> table{{{1, 2}, {3, 5}, {-4, 7}}};
  const auto of = [&](const auto& a, const auto& x, const auto& y) {
    using X = std::decay_t<decltype(x)>;
    const auto pull = [&](const X& left, const X& right) {
      return as_function("pull(a, b)", std::array<X, 2>{left, right}, [&](const std::array<X, 2>& at) {
        return either(
            at[0] > at[1],
            [&] {
              return sum_over(at[0], table, [&](const std::array<X, 2>& row) {
                return std::array<X, 2>{row[0] * at[0] * (a * a * a + 1), sin(row[1] * at[1])};
              });
            },
            [&] {
              return std::array<X, 2>{at[0] + a, at[1]};
            });
      });
    };
    const std::array<X, 2> one = pull(x, y);
    const std::array<X, 2> other = pull(X(2), one[0] * x);
    return std::array<X, 2>{one[0] + other[1], one[1] * other[0]};
  };
  formula::Record record;
  const auto a = Recorded::letter(record, "a", 3), x = Recorded::letter(record, "x[0]", 0.5),
             y = Recorded::letter(record, "x[1]", -2);
  const std::array<Recorded, 2> results = of(a, x, y);
  const std::array<double, 2> now = of(3.0, 0.5, -2.0), later = of(1.0, -3.0, 0.25);
  const auto later_values = record.values({{"a", 1}, {"x[0]", -3}, {"x[1]", 0.25}});
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(results[i].value() == now[i]);
    CHECK(later_values[static_cast<std::size_t>(results[i].at())] == later[i]);
    CHECK(of(Recorded(3), Recorded(0.5), Recorded(-2.0))[i].value() == now[i]);
  }
  CHECK(formula::letters_of(record, {{results.begin(), results.end()}}).contains("a"));

  formula::Program program(record, {"x[0]", "x[1]"}, {{results.begin(), results.end()}}, {"a"});
  CHECK(program.constants().empty());
  const auto helpers = program.helpers();
  REQUIRE(helpers.size() == 1);
  CHECK(helpers[0].arguments == std::vector<std::string>{"a_", "b"});
  CHECK(helpers[0].constants.size() == 3);
  const auto text_of = [](const std::string& head, const std::string& type, const formula::Statements& made) {
    std::string text = "static " + type + " " + head + " {\n";
    for (const std::string& line : made.lines) text += line + "\n";
    return text + "return new " + type + " {" + made.terms[0] + ", " + made.terms[1] + "};\n}\n";
  };
  std::string text = "static readonly double a = 1;\n";
  for (const std::string& line : helpers[0].constants) text += line + "\n";
  text += text_of("Pull(double a_, double b)", "Array2", helpers[0].body);
  text += text_of("Observe(State x, double t)", "Seen", program.function({results.begin(), results.end()}));
  const std::string code = Dialect{2, 2}.in(Language::cpp, text);
  INFO(code);
  static const std::regex call(R"(= pull\()");
  CHECK(std::distance(std::sregex_iterator(code.begin(), code.end(), call), std::sregex_iterator()) == 2);
  const ScratchFolder scratch;
  const Runs runs = runs_of(Language::cpp, scratch.path().string());
  std::ofstream(runs.file)
      << "#include <array>\n#include <cmath>\n#include <cstdio>\n"
      << code
      << "int main() { for (double one : observe({-3, 0.25}, 0)) std::printf(\"%.17g\\n\", "
         "one); }\n";
  REQUIRE(output_of(runs.compile) == "");
  std::istringstream printed(output_of(runs.run));
  for (const double expected : later) {
    double seen = 0;
    printed >> seen;
    CHECK(seen == expected);
  }
}

TEST_CASE("a function of a record depends on its arguments and the parameters alone", "[programs]") {
  using formula::Recorded;
  formula::Record record;
  const auto x = Recorded::letter(record, "x", 3), y = Recorded::letter(record, "y", 4);
  const auto with = [&](const Recorded& hidden) {
    return as_function("f(u)", std::array<Recorded, 1>{x}, [&](const std::array<Recorded, 1>& u) {
      return std::array<Recorded, 1>{u[0] * hidden};
    })[0];
  };
  CHECK(with(y).value() == 12);
  CHECK(with(y).at() == with(y).at());
  CHECK_THROWS_AS(with(x), std::logic_error);
}

TEST_CASE("friction is a separate function in the recipe of the rough box", "[code][programs]") {
  Candidate chosen{"steps with a stick test", "explicit midpoint", "step"};
  chosen.setting = 1 / frames_per_second;
  for (const Language language : {Language::cpp, Language::c_sharp, Language::javascript}) {
    const std::string code = program_in(language, Task(scene({3, 31})), chosen, need_of_a_second(), "");
    INFO(code);
    const auto helpers = helpers_in(code);
    REQUIRE(helpers.size() == 1);
    CHECK(helpers[0].name == (language == Language::c_sharp ? "Friction" : "friction"));
    CHECK(helpers[0].lines == 42);
    CHECK(lines_of_code(code) - helpers[0].lines <= 50 + 14);  // the second part prints
  }
}

TEST_CASE("a motion that loses its numbers alone is another motion", "[programs]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Value motion{1, 2, 4};
  CHECK(largest_difference(motion, std::vector{1.0, 2.0, 4.0}) == 0);
  CHECK(largest_difference(motion, std::vector{1.0, 2.0, 5.0}) == 0.25);
  CHECK(std::isinf(largest_difference(motion, std::vector{1.0, none, 4.0})));
  CHECK(std::isinf(largest_difference(Value{1, none, 4}, std::vector{1.0, 2.0, 4.0})));
  CHECK(std::isinf(largest_difference(motion, std::vector{1.0, none, none})));
  CHECK(largest_difference(Value{1, none, 4}, std::vector{1.0, none, 4.0}) == 0);
  CHECK(std::isinf(largest_difference(Value{0, 1}, std::vector{1.0, 1.0})));
}

// Run by the job `languages`, which installs their compilers.
TEST_CASE("a program in C# has the program's numbers", "[.][languages]") { check(Language::c_sharp, 1e-9); }
TEST_CASE("a program in JavaScript has the program's numbers", "[.][languages]") {
  check(Language::javascript, 1e-9);
}

TEST_CASE("a program in JavaScript has C's remainder, also halfway between two", "[.][languages]") {
  const std::string code =
      program_in(Language::javascript, Task(scene({3, 3})), keplers_equation, need_of_a_second(), "");
  const auto at = code.find("function remainder");
  REQUIRE(at != code.npos);
  std::string text = code.substr(at, code.find("\n}\n", at) + 3 - at);
  std::string expected;
  for (const double x : {0.0, 0.5, 1.0, 1.5, 2.5, 3.5, 1e3, 1e15, 1e300})
    for (const double y : {1.0, -1.0, 2 * std::numbers::pi, 0.3})
      for (const double signed_x : {x, -x}) {
        const std::string pair = format_shortest(signed_x) + ", " + format_shortest(y);
        text += "console.log(remainder(" + pair + ") === " + format_shortest(std::remainder(signed_x, y)) +
                " || '" + pair + "');\n";
        expected += "true\n";
      }
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "remainder.js") << text;
  CHECK(output_of("node " + (scratch.path() / "remainder.js").string()) == expected);
}

TEST_CASE("a language is known by its name", "[code][programs]") {
  for (const char* name : {"c#", "C#", "cs"}) CHECK(language_of(name) == Language::c_sharp);
  for (const char* name : {"c++", "cpp"}) CHECK(language_of(name) == Language::cpp);
  for (const char* name : {"javascript", "js", "JS"}) CHECK(language_of(name) == Language::javascript);
  CHECK(complaint([] { language_of("Lua"); }) ==
        "there is no code in 'Lua'; there is in C++ (cpp), C# (cs), JavaScript (js)");
}

TEST_CASE("a language without code for a need is refused before anything is chosen", "[code][programs]") {
  const Task pendulum(scene({3, 5}));
  const auto refused = [&](const Need& need) {
    return complaint([&] { require_language(Language::c_sharp, pendulum, need); });
  };
  Need need = need_of_a_second();
  CHECK(refused(need) == "nothing");
  need.lockstep = true;
  CHECK(refused(need).find("lockstep") != std::string::npos);
  CHECK(complaint([&] { require_language(Language::cpp, pendulum, need); }) == "nothing");
  need = need_of_a_second();
  need.in_double = false;
  CHECK(refused(need).find("in float") != std::string::npos);
  need = need_of_a_second();
  need.frame_times = frame_times({.jitter = 0.3, .drop = 0.1}, frames_per_second, need.horizon);
  CHECK(refused(need).find("different lengths") != std::string::npos);
}

TEST_CASE("a program counts its frames and steps in whole numbers", "[code][programs]") {
  Need need = need_of_a_second();
  need.horizon = 1e5 / frames_per_second;
  Candidate chosen{"one angle", "Runge-Kutta 4", "step"};
  chosen.setting = 1 / (frames_per_second * 1e5);
  for (const Language language : {Language::cpp, Language::c_sharp, Language::javascript})
    CHECK(program_in(language, Task(scene({3, 5})), chosen, need, "")
              .find("frames = 100000, steps_per_frame = 100000;") != std::string::npos);
  CHECK(code_of(Task(scene({3, 5})), chosen, need, "").find("frames = 100000, steps_per_frame = 100000;") !=
        std::string::npos);
}

TEST_CASE("a program's head names parameters that are worked in", "[code][programs]") {
  const auto head_of = [](Number number, const Candidate& chosen) {
    const std::string code = program_in(Language::cpp, Task(scene(number)), chosen, need_of_a_second(), "");
    return code.substr(0, code.find("#include"));
  };
  const std::string parameters = "The parameters are worked in",
                    iterations = "Its iterations are written out";
  Candidate stepped{"one angle", "Runge-Kutta 4", "step"};
  stepped.setting = 1 / frames_per_second;
  const std::string plain = head_of({3, 5}, stepped), unrolled = head_of({3, 3}, keplers_equation);
  CHECK(plain.find(parameters) == plain.npos);
  CHECK(plain.find(iterations) == plain.npos);
  CHECK(unrolled.find(parameters) != unrolled.npos);
  CHECK(unrolled.find(iterations) != unrolled.npos);
}

TEST_CASE("a program has the parameters that it uses", "[code][programs]") {
  static const std::regex parameter(R"(^const double (\w+) = [^;,]*;  // )");
  for (const Case& one : all_in(Language::cpp).cases) {
    INFO(one.says);
    std::istringstream lines(one.code);
    std::string code, line;
    std::vector<std::string> names;
    for (std::smatch found; std::getline(lines, line); code += line.substr(0, line.find("//")) + "\n")
      if (std::regex_search(line, found, parameter)) names.push_back(found[1]), line.clear();
    for (const std::string& name : names) {
      INFO(name);
      CHECK(mentions(code, name));
    }
  }
}

TEST_CASE("a parameter whose name a program needs gets a suffix", "[code][programs]") {
  std::set<std::string> taken = program_parts::reserved_names();
  for (const char* name : {"t", "h", "q", "gamma", "y1", "in", "let", "double"}) CHECK(taken.contains(name));
  for (const char* name : {"a", "g", "m", "L", "theta"}) CHECK_FALSE(taken.contains(name));
  CHECK(formula::free_name("t", taken) == "t_");
  CHECK(formula::free_name("t", taken) == "t__");
  CHECK(formula::free_name("mu", taken) == "mu");
}

TEST_CASE("a top's program prints its orientation, which turns the body's axes into space's",
          "[code][programs]") {
  std::vector<std::vector<double>> ends;
  for (const char* model : {"one angle, precession by quadrature", "axis and angular momentum"}) {
    Candidate chosen{model, "Runge-Kutta 4", "step"};
    chosen.setting = 1 / (frames_per_second * 8);
    const ScratchFolder scratch;
    const Runs runs = runs_of(Language::cpp, scratch.path().string());
    const std::string code = program_in(Language::cpp, Task(scene({3, 33})), chosen, need_of_a_second(), "");
    CHECK(
        code.find(
            "the body's x axis is\n// (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y))") !=
        code.npos);
    std::ofstream(runs.file) << code;
    REQUIRE(output_of(runs.compile) == "");
    std::istringstream last(output_of(runs.run + " | tail -n 1"));
    ends.emplace_back();
    for (std::string cell; std::getline(last, cell, ',');)
      ends.back().push_back(std::strtod(cell.c_str(), nullptr));
    REQUIRE(ends.back().size() == 8);
    const double w = ends.back()[4], x = ends.back()[5], y = ends.back()[6], z = ends.back()[7];
    const heavy_top::Matrix<double> r = top_after_a_second(Task(scene({3, 33})).parameters);
    const double x_axis[] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    const double z_axis[] = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs(x_axis[i] - r[i][0]) < 1e-5);
      CHECK(std::abs(z_axis[i] - r[i][2]) < 1e-5);
      CHECK(std::abs(z_axis[i] - ends.back()[1 + i]) < 1e-6);
    }
  }
  for (std::size_t i = 4; i < 8; ++i) CHECK(std::abs(ends[0][i] - ends[1][i]) < 1e-5);
}
