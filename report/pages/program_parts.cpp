#include "report/pages/program_parts.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <string_view>
#include <vector>

#include "chapters/listing.hpp"
#include "reference/bad_input.hpp"

namespace oddity::program_parts {

namespace {

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
/// The rest of a function that has k1.
constexpr std::string_view runge_kutta = R"(  var k2 = Rates(Moved(x, h / 2, k1), t + h / 2);
  var k3 = Rates(Moved(x, h / 2, k2), t + h / 2);
  var k4 = Rates(Moved(x, h, k3), t + h);
  var y = copy(x);
  for (var i = 0; i < size(y); ++i)
    y[i] = x[i] + h / 6 * k1[i] + h / 3 * k2[i] + h / 3 * k3[i] + h / 6 * k4[i];
  return y;
}
)";

/// Steps of a model that tests whether it comes to rest.
constexpr std::string_view stick_test = R"(
// Friction may stop the motion within a step: it then comes to rest at a steady deceleration.
static State Step(State x, double t, double h) {
  if (Speed(x) == 0) return x;
  var rate = Rates(x, t);
  if (Speed(x) <= h * Braking(x, rate)) return Coasted(x, rate);
$step}
)";
constexpr Algorithm stick_test_steps[] = {
    {"explicit midpoint", "  return Moved(x, h, Rates(Moved(x, h / 2, rate), t + h / 2));\n"},
    {"semi-implicit Euler", R"(  var y = copy(x);
  var n = size(x) / 2;
  for (var i = 0; i < n; ++i) y[n + i] += h * rate[n + i];
  for (var i = 0; i < n; ++i) y[i] += h * y[n + i];
  return y;
)"},
};

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
  var accel = Acceleration(x);
  for (var i = 0; i < n; ++i) y[n + i] += h * accel[i];
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
  var accel = Acceleration(y);
  for (var i = 0; i < n; ++i) y[n + i] = x[n + i] + h / 2 * last[i] + h / 2 * accel[i];
  last = accel;
  return y;
}
)"},
    {"Runge-Kutta 4", R"(
static State Step(State x, double t, double h) {
  var k1 = Rates(x, t);
$runge_kutta)"},
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
    var accel = Acceleration(y);
    for (var i = 0; i < n; ++i) y[n + i] += kicks[stage] * h * accel[i];
  }
  return y;
}
)"},
    {"Adams-Bashforth 4", R"(
static State RungeKutta(State x, State k1, double t, double h) {
$runge_kutta
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

void put(std::string& text, std::string_view placeholder, std::string_view what) {
  if (const auto at = text.find(placeholder); at != text.npos) text.replace(at, placeholder.size(), what);
}

std::string with_moved(const std::string& text) {
  return (text.find("Moved") != text.npos ? std::string(moved) : "") + text;
}

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
  put(text, "$places",
      are_rates ? "  foreach (var i in places) y[i] += h * y[rate_of[i]];\n"
                : "  var later = Rates(y, t + h);\n  foreach (var i in places) y[i] += h * later[i];\n");
  return "\n" + list_text("velocities", velocities) + list_text("places", places) +
         (are_rates ? list_text("rate_of", rate_of) : "") + text;
}

/// Functions that a language's library lacks.
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
  const size = Math.abs(y), r = Math.abs(x) % (2 * size);
  const nearest = r <= size / 2 ? r : r - size < size / 2 ? r - size : r - 2 * size;
  return x < 0 ? -nearest : nearest;
}
)"},
};

constexpr Main mains[] = {
    {R"(
int main() {
  const int frames = $frames$steps;
  const double frames_per_second = $rate;
  std::printf("$names\n");
$start  for (int frame = 1; frame <= frames; ++frame) {
$frame    std::printf("\n");
  }
}
)",
     "  auto x = start();\n",
     R"(    const double t0 = (frame - 1) / frames_per_second, t1 = frame / frames_per_second;
    const double h = (t1 - t0) / steps_per_frame;
    for (int i = 0; i < steps_per_frame; ++i) x = step(x, t0 + i * h, h);
    std::printf("%.17g", t1);
    for (const double seen : observe(x, t1)) std::printf(",%.17g", seen);
)",
     R"(    const double t = frame / frames_per_second;
    std::printf("%.17g", t);
    for (const double seen : at(t)) std::printf(",%.17g", seen);
)"},
    {R"(
static void Main() {
  const int frames = $frames$steps;
  const double frames_per_second = $rate;
  Console.WriteLine("$names");
$start  for (int frame = 1; frame <= frames; ++frame) {
$frame    Console.WriteLine(row);
  }
}
)",
     "  var x = Start();\n",
     R"(    double t0 = (frame - 1) / frames_per_second, t1 = frame / frames_per_second;
    var h = (t1 - t0) / steps_per_frame;
    for (int i = 0; i < steps_per_frame; ++i) x = Step(x, t0 + i * h, h);
    var row = t1.ToString("R", CultureInfo.InvariantCulture);
    foreach (var seen in Observe(x, t1)) row += "," + seen.ToString("R", CultureInfo.InvariantCulture);
)",
     R"(    var t = frame / frames_per_second;
    var row = t.ToString("R", CultureInfo.InvariantCulture);
    foreach (var seen in At(t)) row += "," + seen.ToString("R", CultureInfo.InvariantCulture);
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

/// Keywords of the three languages, and the names outside the program that it refers to.
// clang-format off
constexpr std::string_view keywords[] = {
    "abstract", "alignas", "alignof", "and", "and_eq", "arguments", "as", "asm", "async", "auto", "await",
    "base", "bitand", "bitor", "bool", "break", "byte", "case", "catch", "char", "char8_t", "char16_t",
    "char32_t", "checked", "class", "co_await", "co_return", "co_yield", "compl", "concept", "const",
    "const_cast", "consteval", "constexpr", "constinit", "continue", "debugger", "decimal", "decltype",
    "default", "delegate", "delete", "do", "double", "dynamic_cast", "else", "enum", "eval", "event",
    "explicit", "export", "extends", "extern", "false", "finally", "fixed", "float", "for", "foreach",
    "friend", "function", "goto", "if", "implements", "implicit", "import", "in", "inline", "instanceof",
    "int", "interface", "internal", "is", "let", "lock", "long", "mutable", "namespace", "new",
    "noexcept", "not", "not_eq", "null", "nullptr", "object", "operator", "or", "or_eq", "out",
    "override", "package", "params", "private", "protected", "public", "readonly", "ref", "register",
    "reinterpret_cast", "requires", "return", "sbyte", "sealed", "short", "signed", "sizeof",
    "stackalloc", "static", "static_assert", "static_cast", "string", "struct", "super", "switch",
    "template", "this", "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "typeof",
    "uint", "ulong", "unchecked", "undefined", "union", "unsafe", "unsigned", "ushort", "using", "var",
    "virtual", "void", "volatile", "wchar_t", "while", "with", "xor", "xor_eq", "yield", "std", "printf",
    "linux", "unix"};
// clang-format on
/// Functions of C's <math.h>, <stdlib.h> and <stdio.h>, which <cmath> and <cstdio> may declare outside std.
constexpr std::string_view c_functions[] = {
    "abort",  "abs",     "acos",   "acosh",     "asin",      "asinh",    "atan",     "atan2",   "atanh",
    "atexit", "atof",    "atoi",   "atol",      "cbrt",      "ceil",     "copysign", "cos",     "cosh",
    "div",    "drem",    "ecvt",   "erf",       "erfc",      "exit",     "exp",      "exp10",   "exp2",
    "expm1",  "fabs",    "fdim",   "finite",    "floor",     "fma",      "fmax",     "fmin",    "fmod",
    "free",   "frexp",   "gamma",  "getc",      "gets",      "getw",     "hypot",    "ilogb",   "isinf",
    "isnan",  "j0",      "j1",     "jn",        "labs",      "ldexp",    "ldiv",     "lgamma",  "llabs",
    "llrint", "llround", "log",    "log10",     "log1p",     "log2",     "logb",     "lrint",   "lround",
    "malloc", "modf",    "nan",    "nearbyint", "nextafter", "pow",      "putc",     "puts",    "putw",
    "qsort",  "rand",    "random", "realloc",   "remainder", "remove",   "remquo",   "rename",  "rewind",
    "rint",   "round",   "scalb",  "scalbn",    "select",    "setstate", "signbit",  "signgam", "significand",
    "sin",    "sincos",  "sinh",   "sqrt",      "srand",     "stderr",   "stdin",    "stdout",  "system",
    "tan",    "tanh",    "tgamma", "trunc",     "y0",        "y1",       "yn"};

void add_words(std::string text, std::set<std::string>& names) {
  static const std::regex comment_or_string(R"(//[^\n]*|"[^"\n]*")"), word(R"([A-Za-z_]\w*)");
  text = std::regex_replace(text, comment_or_string, "");
  for (std::sregex_iterator found(text.begin(), text.end(), word), none; found != none; ++found)
    names.insert(found->str());
}

}  // namespace

std::string algorithm_text(const std::string& name, const RecordedModel& model) {
  if (model.start.empty()) return "";
  if (const auto* step = std::ranges::find(stick_test_steps, name, &Algorithm::name);
      !model.coasted.empty() && step != std::end(stick_test_steps)) {
    std::string text(stick_test);
    put(text, "$step", step->text);
    return with_moved(text);
  }
  const auto* found = std::ranges::find(algorithms, name, &Algorithm::name);
  if (found == std::end(algorithms)) throw BadInput("there is no such code for the algorithm " + name);
  std::string text(found->text);
  if (name == "semi-implicit Euler") text = with_velocities(text, model);
  if (text.find("Acceleration") != text.npos && model.acceleration.empty())
    throw BadInput("there is no such code for " + name + " on a model without accelerations alone");
  put(text, "$runge_kutta", runge_kutta);
  return with_moved(text);
}

const Main& main_of(Language language) { return mains[static_cast<std::size_t>(language)]; }

std::string helpers_for(Language language, const std::string& code) {
  std::string text;
  for (const Helper& helper : helpers)
    if (helper.language == language && mentions(code, helper.name)) text += helper.text;
  return text;
}

const std::set<std::string>& reserved_names() {
  static const std::set<std::string> all = [] {
    std::set<std::string> names;
    names.insert(std::begin(keywords), std::end(keywords));
    names.insert(std::begin(c_functions), std::end(c_functions));
    for (const std::string_view text : {moved, runge_kutta, stick_test}) add_words(std::string(text), names);
    for (const Algorithm& algorithm : algorithms) add_words(std::string(algorithm.text), names);
    for (const Main& main : mains)
      for (const std::string_view text : {main.text, main.start, main.stepped, main.at})
        add_words(std::string(text), names);
    for (const Helper& helper : helpers) names.insert(std::string(helper.name));
    for (const char* of_the_model : {"q", "rate_of", "velocities", "Start", "Observe", "At"})
      names.insert(of_the_model);
    return names;
  }();
  return all;
}

}  // namespace oddity::program_parts
