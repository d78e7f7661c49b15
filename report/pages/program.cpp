#include "report/pages/program.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "chapters/listing.hpp"
#include "formula/program.hpp"
#include "reference/bad_input.hpp"
#include "reference/code_text.hpp"
#include "reference/text.hpp"
#include "report/pages/dialects.hpp"
#include "report/study/embedded.hpp"
#include "report/study/frames.hpp"
#include "report/study/recorded_model.hpp"
#include "report/text/readable.hpp"

namespace oddity {

namespace {

using Lines = std::vector<std::string>;

// ---- algorithms -------------------------------------------------------------------------------------------

struct Algorithm {
  std::string_view name, text;
};

constexpr std::string_view moved = R"(
static State Moved(State x, double h, State rate) {
  var y = copy(x);
  for (var i = 0; i < size(y); ++i) y[i] += h * rate[i];
  return y;
}
)";
constexpr std::string_view runge_kutta = R"(
static State RungeKutta(State x, State k1, double t, double h) {
  var k2 = Rates(Moved(x, h / 2, k1), t + h / 2);
  var k3 = Rates(Moved(x, h / 2, k2), t + h / 2);
  var k4 = Rates(Moved(x, h, k3), t + h);
  var y = copy(x);
  for (var i = 0; i < size(y); ++i) y[i] = x[i] + h / 6 * k1[i] + h / 3 * k2[i] + h / 3 * k3[i] + h / 6 * k4[i];
  return y;
}
)";

constexpr Algorithm algorithms[] = {
    {"explicit Euler", R"(
static State Step(State x, double t, double h) {
  return Moved(x, h, Rates(x, t));
}
)"},
    {"symplectic Euler", R"(
// The velocities first, then the places with the new ones.
static State Step(State x, double t, double h) {
  var y = copy(x);
  var n = size(x) / 2;
  var a = Acceleration(x);
  for (var i = 0; i < n; ++i) y[n + i] += h * a[i];
  for (var i = 0; i < n; ++i) y[i] += h * y[n + i];
  return y;
}
)"},
    {"semi-implicit Euler", R"(
// The velocities first, then the places with the new ones.
static State Step(State x, double t, double h) {
  var y = copy(x);
  var rate = Rates(x, t);
  foreach (var i in velocities) y[i] += h * rate[i];
$places  return y;
}
)"},
    {"velocity Verlet", R"(
static Half last;  // acceleration at the last state; whoever changes the state sets `started` to false
static bool started;

static State Step(State x, double t, double h) {
  if (!started) last = Acceleration(x);
  started = true;
  var y = copy(x);
  var n = size(x) / 2;
  for (var i = 0; i < n; ++i) y[i] = x[i] + h * x[n + i] + h / 2 * h * last[i];
  var a = Acceleration(y);
  for (var i = 0; i < n; ++i) y[n + i] = x[n + i] + h / 2 * last[i] + h / 2 * a[i];
  last = a;
  return y;
}
)"},
    {"Runge-Kutta 4", R"(
static State Step(State x, double t, double h) {
  return RungeKutta(x, Rates(x, t), t, h);
}
)"},
    {"modified midpoint", R"(
static State Step(State x, double t, double h) {
  var middle = Moved(x, h / 2, Rates(x, t));
  var end = Moved(x, h, Rates(middle, t + h / 2));
  var rate = Rates(end, t + h / 2 + h / 2);
  var y = copy(x);
  for (var i = 0; i < size(y); ++i) y[i] = middle[i] / 2 + end[i] / 2 + h / 2 / 2 * rate[i];
  return y;
}
)"},
    {"McLachlan 4", R"(
static readonly double third = 1.0 / 3, z = Math.Sqrt(7.0 / 8) / 3;
static readonly Weights drifts = new Weights {0.5 - z, -third + z, 2 * third, -third + z, 0.5 - z};
static readonly Weights kicks = new Weights {1.0, -0.5, -0.5, 1.0};

// Five drifts and four kicks between them.
static State Step(State x, double t, double h) {
  var y = copy(x);
  var n = size(x) / 2;
  for (var stage = 0; stage < 5; ++stage) {
    for (var i = 0; i < n; ++i) y[i] += drifts[stage] * h * y[n + i];
    if (stage == 4) break;
    var a = Acceleration(y);
    for (var i = 0; i < n; ++i) y[n + i] += kicks[stage] * h * a[i];
  }
  return y;
}
)"},
    {"Adams-Bashforth 4", R"(
static State f0, f1, f2, f3;  // the last rates, the newest first
static int known = 0;         // how many of them are: of another state or step none

static State Step(State x, double t, double h) {
  f3 = f2;
  f2 = f1;
  f1 = f0;
  f0 = Rates(x, t);
  if (++known < 4) return RungeKutta(x, f0, t, h);
  var y = copy(x);
  for (var i = 0; i < size(y); ++i)
    y[i] = x[i] + 55.0 / 24 * h * f0[i] - 59.0 / 24 * h * f1[i] + 37.0 / 24 * h * f2[i] - 3.0 / 8 * h * f3[i];
  return y;
}
)"},
};

std::string list_text(const std::string& name, const std::vector<int>& all) {
  std::string text;
  for (const int one : all) text += (text.empty() ? "" : ", ") + std::to_string(one);
  return "static readonly Places " + name + " = new Places {" + text + "};\n";
}

/// Which unknowns are velocities, and how the others follow.
std::string with_velocities(std::string text, const RecordedModel& model) {
  std::vector<int> velocities, places;
  for (std::size_t i = 0; i < model.is_velocity.size(); ++i)
    (model.is_velocity[i] ? velocities : places).push_back(static_cast<int>(i));
  const bool are_rates =
      std::ranges::all_of(places, [&](int i) { return model.velocity_of[static_cast<std::size_t>(i)] >= 0; });
  std::vector<int> rate_of(model.is_velocity.size(), 0);
  for (const int i : places)
    rate_of[static_cast<std::size_t>(i)] = model.velocity_of[static_cast<std::size_t>(i)];
  const std::string placeholder = "$places";
  text.replace(text.find(placeholder), placeholder.size(),
               are_rates
                   ? "  foreach (var i in places) y[i] += h * y[rate_of[i]];\n"
                   : "  var later = Rates(y, t + h);\n  foreach (var i in places) y[i] += h * later[i];\n");
  return "\n" + list_text("velocities", velocities) + list_text("places", places) +
         (are_rates ? list_text("rate_of", rate_of) : "") + text;
}

std::string algorithm_text(const std::string& name, const RecordedModel& model) {
  if (model.start.empty()) return "";
  const auto* found = std::ranges::find(algorithms, name, &Algorithm::name);
  if (found == std::end(algorithms)) throw BadInput("there is no such code for the algorithm " + name);
  std::string text(found->text);
  if (name == "semi-implicit Euler") text = with_velocities(text, model);
  if (text.find("Acceleration") != text.npos && model.acceleration.empty())
    throw BadInput("there is no such code for " + name + " on a model without accelerations alone");
  const bool has_runge_kutta = text.find("RungeKutta") != text.npos;
  if (has_runge_kutta) text = std::string(runge_kutta) + text;
  return (text.find("Moved") != text.npos ? std::string(moved) : "") + text;
}

// ---- the model --------------------------------------------------------------------------------------------

/// The listing's name of it: a closed form may have an algorithm of its own.
const Recorder* recorder_of(const Task& task, const Candidate& chosen) {
  for (const std::string& name : {chosen.model + ", " + chosen.algorithm, chosen.model})
    for (const Recorder& one : recorders())
      if (one.scene == task.entry->number && one.model == name) return &one;
  return nullptr;
}

bool is_as_at(const RecordedModel& model, const RecordedModel& at, double t) {
  const std::vector<double> values = model.record->values({{"t", t}});
  for (std::size_t i = 0; i < model.observed.size(); ++i) {
    const auto& one = model.observed[i];
    const double now = one.is_known() ? one.value() : values[static_cast<std::size_t>(one.at())];
    if (!(now == at.observed[i].value())) return false;
  }
  return true;
}

/// Of a closed form that goes on until it has settled: as at the frame where it goes on longest, which is to
/// have the same values at all others.
RecordedModel longest(const Recorder& recorder, ToRecord asked, const Need& need) {
  std::vector<RecordedModel> all;
  for (double frame = 1; frame <= need.frames(); ++frame) {
    asked.t = frame / need.frames_per_second;
    all.push_back(recorder.record(asked));
  }
  const auto most = std::ranges::max_element(
      all, {}, [](const RecordedModel& one) { return one.record->operations().size(); });
  double frame = 0;
  for (const RecordedModel& one : all)
    if (!is_as_at(*most, one, ++frame / need.frames_per_second))
      throw BadInput("its operations differ from frame to frame");
  return *most;
}

RecordedModel model_of(const Task& task, const Candidate& chosen, const Need& need) {
  const Recorder* recorder = recorder_of(task, chosen);
  if (!recorder)
    throw BadInput("the model '" + chosen.model + "' is in none of the listings that are recorded");
  ToRecord asked{task.entry->exercise.parameters, {}};
  for (const Parameter& p : task.entry->exercise.parameters) asked.values.push_back(task.parameters[p.name]);
  asked.t = 1 / need.frames_per_second;
  RecordedModel model = recorder->record(asked);
  if (model.branched_at_start || model.branched) {
    asked.with_letters = false;
    model = recorder->record(asked);
  }
  if (!model.branched) return model;
  if (!model.start.empty()) throw BadInput("the operations of its equations differ from state to state");
  return longest(*recorder, asked, need);
}

/// What stands above its type in its header.
Lines comment_of(const Listing& listing, std::string_view model) {
  static const std::regex type(R"(::(\w+)[<(])");
  std::string expression;
  for (const auto& [name, text] : listing.models)
    if (name == model) expression = text;
  std::smatch found;
  if (!std::regex_search(expression, found, type)) return {};
  const std::string head = "struct " + found[1].str() + " ";
  for (const EmbeddedFile& file : embedded_headers()) {
    if (std::ranges::find(listing.headers, file.path) == listing.headers.end()) continue;
    std::istringstream lines{std::string(file.text)};
    Lines comment;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("/// "))
        comment.push_back(line.substr(1));
      else if ((line + " ").starts_with(head))
        return comment;
      else if (!line.starts_with("template") && !line.starts_with("requires"))
        comment.clear();
    }
  }
  return {};
}

/// With the orientation as further unknowns, where the algorithm's steps are those of all unknowns.
void turn_along(RecordedModel& model, bool can_turn) {
  if (!can_turn) model.orientation.clear();
  if (model.orientation.empty()) return;
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(model.start, model.orientation_at_start);
  append(model.rates, model.turning);
  append(model.observed, model.orientation);
}

/// Terms with commas between, as many a line as it has room for.
std::string terms_text(const Lines& terms, std::size_t first) {
  constexpr std::size_t line_length = 96;
  std::string text;
  std::size_t length = first;
  for (const std::string& term : terms) {
    if (!text.empty()) text += ",";
    const bool fits = text.empty() || length + term.size() + 2 <= line_length;
    text += text.empty() ? "" : fits ? " " : "\n    ";
    length = (fits ? length + 2 : 4) + term.size();
    text += term;
  }
  return text;
}

std::string function_text(const std::string& head, const std::string& type, const formula::Statements& made) {
  std::string text = "\nstatic " + type + " " + head + " {\n";
  for (const std::string& line : made.lines) text += "  " + line + "\n";
  const std::string returned = "  return new " + type + " {";
  return text + returned + terms_text(made.terms, returned.size()) + "};\n}\n";
}

std::string parameters_text(const Task& task, const std::string& code) {
  std::string text;
  for (const Parameter& p : task.entry->exercise.parameters)
    if (mentions(code, p.name))
      text += "const double " + std::string(p.name) + " = " + format_shortest(task.parameters[p.name]) +
              ";  // " + (p.unit.empty() || p.unit == "1" ? "" : std::string(p.unit) + ": ") +
              in_comment(readable(std::string(p.says))) + "\n";
  return text;
}

std::set<std::string> taken_names(const Task& task) {
  std::set<std::string> taken{"t", "x", "q", "h", "z", "third", "known", "last", "places", "velocities"};
  for (const char* in_c : {"atan2", "exp2", "exp10", "log2", "log10"}) taken.insert(in_c);  // its header's
  for (const Parameter& p : task.entry->exercise.parameters) taken.insert(std::string(p.name));
  return taken;
}

/// Parameters, constants and the functions of the model.
std::string model_text(const Task& task, const RecordedModel& model, const std::string& name,
                       bool by_forces) {
  std::set<std::string> moving{"t"};
  for (std::size_t i = 0; i < model.start.size(); ++i) {
    moving.insert(state_letter('x', i));
    moving.insert(state_letter('q', i));
  }
  formula::Program program(*model.record, moving,
                           {model.observed, by_forces ? model.acceleration : model.rates}, taken_names(task));
  std::string constants, text;
  for (const std::string& line : program.constants()) constants += line + "\n";
  for (const std::string& line : comment_of(task.entry->exercise.scene->listing, name)) text += line + "\n";
  if (!text.empty()) text = "\n" + text;
  if (model.start.empty()) {
    text +=
        function_text("At(double t)", "Seen", program.function(model.observed)).substr(text.empty() ? 0 : 1);
  } else {
    text += function_text("Start()", "State", program.function(model.start)).substr(text.empty() ? 0 : 1);
    text += by_forces ? function_text("Acceleration(State q)", "Half", program.function(model.acceleration))
                      : function_text("Rates(State x, double t)", "State", program.function(model.rates));
    text += function_text("Observe(State x, double t)", "Seen", program.function(model.observed));
  }
  return parameters_text(task, constants + text) + (constants.empty() ? "" : "\n" + constants) + text;
}

// ---- the program around it --------------------------------------------------------------------------------

/// Functions that a language's library has not.
struct Helper {
  Language language;
  std::string_view name, text;
};
constexpr Helper helpers[] = {
    {Language::c_sharp, "Hypot", R"(
static double Hypot(double x, double y) {
  return Math.Sqrt(x * x + y * y);
}
)"},
    {Language::c_sharp, "Expm1", R"(
static double Expm1(double x) {
  var u = Math.Exp(x);
  return u == 1 ? x : u == 0 ? -1 : (u - 1) * x / Math.Log(u);
}
)"},
    {Language::c_sharp, "Asinh", R"(
static double Asinh(double x) {
  var a = Math.Abs(x);
  var less = a + a * a / (1 + Math.Sqrt(1 + a * a));
  var u = 1 + less;
  return u == 1 ? x : Math.Sign(x) * Math.Log(u) * less / (u - 1);
}
)"},
    {Language::c_sharp, "Copysign", R"(
static double Copysign(double size, double sign) {
  return sign < 0 ? -Math.Abs(size) : Math.Abs(size);
}
)"},
    {Language::javascript, "copysign", R"(
function copysign(size, sign) {
  return sign < 0 ? -Math.abs(size) : Math.abs(size);
}
)"},
    {Language::javascript, "remainder", R"(
function remainder(x, y) {
  return x - y * Math.round(x / y);
}
)"},
};

/// A main function, and what stands in it where a motion is stepped, or is a closed form.
struct Main {
  std::string_view text, start, stepped, at;
};
constexpr Main mains[] = {
    {R"(
template <class Numbers>
void print_row(double t, const Numbers& observed) {
  std::printf("%.17g", t);
  for (const double x : observed) std::printf(",%.17g", x);
  std::printf("\n");
}

int main() {
  const int frames = $frames$steps;
  const double frames_per_second = $rate;
  std::printf("$names\n");
$start  for (int frame = 1; frame <= frames; ++frame) {
$frame  }
}
)",
     "  auto x = start();\n",
     R"(    const double t0 = (frame - 1) / frames_per_second, t1 = frame / frames_per_second;
    const double h = (t1 - t0) / steps_per_frame;
    for (int i = 0; i < steps_per_frame; ++i) x = step(x, t0 + i * h, h);
    print_row(t1, observe(x, t1));
)",
     R"(    const double t = frame / frames_per_second;
    print_row(t, at(t));
)"},
    {R"(
static void PrintRow(double t, double[] observed) {
  var row = t.ToString("R", CultureInfo.InvariantCulture);
  foreach (var x in observed) row += "," + x.ToString("R", CultureInfo.InvariantCulture);
  Console.WriteLine(row);
}

static void Main() {
  const int frames = $frames$steps;
  const double frames_per_second = $rate;
  Console.WriteLine("$names");
$start  for (int frame = 1; frame <= frames; ++frame) {
$frame  }
}
)",
     "  var x = Start();\n",
     R"(    double t0 = (frame - 1) / frames_per_second, t1 = frame / frames_per_second;
    var h = (t1 - t0) / steps_per_frame;
    for (int i = 0; i < steps_per_frame; ++i) x = Step(x, t0 + i * h, h);
    PrintRow(t1, Observe(x, t1));
)",
     R"(    var t = frame / frames_per_second;
    PrintRow(t, At(t));
)"},
    {R"(
const frames = $frames$steps;
const frames_per_second = $rate;
console.log("$names");
$startfor (let frame = 1; frame <= frames; ++frame) {
$frame}
)",
     "let x = start();\n",
     R"(  const t0 = (frame - 1) / frames_per_second, t1 = frame / frames_per_second;
  const h = (t1 - t0) / steps_per_frame;
  for (let i = 0; i < steps_per_frame; ++i) x = step(x, t0 + i * h, h);
  console.log([t1, ...observe(x, t1)].join(","));
)",
     R"(  const t = frame / frames_per_second;
  console.log([t, ...at(t)].join(","));
)"},
};

void put(std::string& text, const std::string& placeholder, const std::string& what) {
  text.replace(text.find(placeholder), placeholder.size(), what);
}

std::string row_names(const Scene& scene, bool is_turning) {
  std::string line = "t [" + std::string(scene.axes.time) + "]";
  for (const std::string_view name : scene.axes.observables) line += "," + std::string(name);
  return line + (is_turning ? ",qw,qx,qy,qz" : "");
}

std::string main_text(Language language, const Task& task, const Candidate& chosen, const Need& need,
                      const RecordedModel& model) {
  const bool steps = !model.start.empty();
  const Main& main = mains[static_cast<std::size_t>(language)];
  std::string text(main.text);
  put(text, "$frames", format_shortest(need.frames()));
  put(text, "$steps",
      steps ? ", steps_per_frame = " +
                  format_shortest(std::round(1 / (chosen.setting * need.frames_per_second)))
            : "");
  put(text, "$rate", format_shortest(need.frames_per_second));
  put(text, "$names", row_names(*task.entry->exercise.scene, !model.orientation.empty()));
  put(text, "$start", std::string(steps ? main.start : ""));
  put(text, "$frame", std::string(steps ? main.stepped : main.at));
  return text;
}

std::string indented(const std::string& text) {
  std::string all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) all += (line.empty() ? "" : "  " + line) + "\n";
  return all;
}

std::string whole(Language language, const std::string& code) {
  if (language == Language::c_sharp)
    return "using System;\nusing System.Globalization;\n\nstatic class Motion {\n" + indented(code) + "}\n";
  if (language == Language::javascript) return code;
  const bool has_pi = code.find("std::numbers") != code.npos;
  return "#include <array>\n#include <cmath>\n#include <cstddef>\n#include <cstdio>\n" +
         std::string(has_pi ? "#include <numbers>\n" : "") + "\n" + code;
}

/// How each language's program is run.
constexpr std::string_view runs[] = {"Compiled by c++ -std=c++20 -O2 -ffp-contract=off",
                                     "Compiled by mcs or csc", "Run by node"};

}  // namespace

std::string as_comment(const std::string& text) {
  std::string comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    comment += line.empty() ? "//\n" : "// " + in_comment(line) + "\n";
  return comment;
}

Language language_of(std::string_view name) {
  const auto lower = [](std::string_view text) {
    std::string all;
    for (const char c : text) all += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return all;
  };
  std::string known;
  for (std::size_t i = 0; i < std::size(language_names); ++i) {
    if (lower(language_names[i]) == lower(name)) return static_cast<Language>(i);
    known += (known.empty() ? "" : ", ") + std::string(language_names[i]);
  }
  throw BadInput("there is no code in '" + std::string(name) + "'; there is in " + known);
}

std::string program_in(Language language, const Task& task, const Candidate& chosen, const Need& need,
                       const std::string& about) {
  const std::string name(language_names[static_cast<std::size_t>(language)]);
  const auto refuse = [&](const std::string& why) {
    throw BadInput("there is no code in " + name + " for this choice: " + why +
                   "; leave out --language for C++");
  };
  if (task.entry->exercise.scene->listing.text) refuse("it is a problem's file");
  if (chosen.precision == Precision::in_float) refuse("it is in float");
  if (need.frame_times) refuse("its frames are of different lengths");
  if (need.lockstep) refuse("it is asked to run in lockstep");
  try {
    RecordedModel model = model_of(task, chosen, need);
    const std::string algorithm = algorithm_text(std::string(without_stepping(chosen.algorithm)), model);
    const bool by_forces = algorithm.find("Acceleration(") != algorithm.npos;
    turn_along(model, !by_forces && algorithm.find("velocities") == algorithm.npos);
    const Dialect dialect{model.start.size(), model.observed.size()};
    std::string code = dialect.in(language, model_text(task, model, chosen.model, by_forces) + algorithm);
    for (const Helper& helper : helpers)
      if (helper.language == language && mentions(code, helper.name)) code += helper.text;
    code += main_text(language, task, chosen, need, model);
    return as_comment(about + "\n" + std::string(runs[static_cast<std::size_t>(language)]) +
                      " it prints oddity's own numbers, but for roundings.") +
           "\n" + whole(language, code);
  } catch (const BadInput& why) {
    refuse(why.what());
  }
  return "";
}

}  // namespace oddity
