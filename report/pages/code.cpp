#include "report/pages/code.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include "chapters/listing.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/pages/choose_view.hpp"
#include "report/pages/code_text.hpp"
#include "report/study/embedded.hpp"
#include "report/study/frames.hpp"
#include "report/text/screen.hpp"
#include "report/text/used_code.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

/// An algorithm with a loop in report/plain.
struct Plain {
  std::string_view algorithm, header, type;
};

constexpr Plain plain_algorithms[] = {
    {"explicit Euler", "report/plain/explicit_euler.hpp", "ExplicitEuler"},
    {"symplectic Euler", "report/plain/symplectic_euler.hpp", "SymplecticEuler"},
    {"semi-implicit Euler", "report/plain/semi_implicit_euler.hpp", "SemiImplicitEuler"},
    {"velocity Verlet", "report/plain/velocity_verlet.hpp", "VelocityVerlet"},
    {"Runge-Kutta 4", "report/plain/runge_kutta_4.hpp", "RungeKutta4"},
    {"modified midpoint", "report/plain/modified_midpoint.hpp", "ModifiedMidpoint"},
    {"McLachlan 4", "report/plain/mclachlan_4.hpp", "McLachlan4"},
    {"Adams-Bashforth 4", "report/plain/adams_bashforth_4.hpp", "AdamsBashforth4"},
};
constexpr Plain own_steps{"", "report/plain/own_steps.hpp", "OwnSteps"};
constexpr std::string_view closed_form = "closed form";
constexpr std::string_view lockstep_header = "report/plain/lockstep.hpp";

std::string listed(const std::vector<std::string_view>& names) {
  std::string all;
  for (std::string_view name : names) all += (all.empty() ? "" : "; ") + std::string(name);
  return all.empty() ? "none" : all;
}

/// The code of a method: an expression that constructs the model, and the algorithm; nullptr for a closed
/// form.
struct Printed {
  std::string_view model;
  const Plain* algorithm;
};

template <class Pairs>
const std::string_view* find(const Pairs& pairs, std::string_view name) {
  for (const auto& [key, value] : pairs)
    if (key == name) return &value;
  return nullptr;
}

/// The algorithm's name without " in float".
std::string in_double(const std::string& algorithm) {
  const std::string_view suffix = " in float";
  return algorithm.ends_with(suffix) ? algorithm.substr(0, algorithm.size() - suffix.size()) : algorithm;
}

/// Throws BadInput if there is no code; the message does not suggest models that are shown to be wrong.
Printed printed(const Scene& scene, const std::string& model, const std::string& algorithm) {
  const Listing& listing = scene.listing;
  if (const auto* own = find(listing.models, model + ", " + algorithm)) return {*own, nullptr};
  if (const auto* own = find(listing.with_own_steps, model + ", " + algorithm)) return {*own, &own_steps};
  const Plain* found = std::ranges::find(plain_algorithms, algorithm, &Plain::algorithm);
  if (algorithm != closed_form && found == std::end(plain_algorithms))
    throw BadInput("there is no code to print for the algorithm " + algorithm +
                   "; there is for: " + listed(printable_algorithms()) + " (choose among these with --only)");
  const auto* expression = find(listing.models, model);
  if (!expression) {
    const auto* why = find(listing.not_printable, model);
    std::vector<std::string_view> printable;
    for (const auto& entry : listing.models)
      if (std::ranges::find(scene.faulted, entry.first) == scene.faulted.end())
        printable.push_back(entry.first);
    throw BadInput("there is no code to print for the model '" + model + "'" +
                   (why ? ", " + std::string(*why) : "") + "; there is for: " + listed(printable) +
                   " (choose among these with --only)");
  }
  return {*expression, algorithm == closed_form ? nullptr : found};
}

std::string_view text_of(std::string_view path) {
  for (const EmbeddedFile& header : embedded_headers())
    if (header.path == path) return header.text;
  throw std::logic_error("the program does not carry " + std::string(path));
}

/// Headers joined into one text, each once, after the headers that it includes.
class Joined {
 public:
  void add(std::string_view path) {
    if (!seen_.insert(std::string(path)).second) return;
    std::string own;
    std::istringstream lines{std::string(text_of(path))};
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("#include \""))
        add(line.substr(10, line.find('"', 10) - 10));
      else if (line.starts_with("#include <"))
        standard_.insert(line.substr(10, line.find('>') - 10));
      else if (line != "#pragma once" && !(line.empty() && own.ends_with("\n\n")))
        own += line + "\n";
    }
    text_ += "\n" + own.substr(own.find_first_not_of('\n'));
  }
  void add_standard(const std::string& header) { standard_.insert(header); }

  /// #include lines of the standard headers that the code needs.
  std::string includes(std::string_view code) const {
    std::string text;
    for (const std::string& name : standard_)
      if (needs_standard(name, code)) text += "#include <" + name + ">\n";
    return text;
  }
  const std::string& text() const { return text_; }

 private:
  std::set<std::string> seen_, standard_;
  std::string text_;
};

std::string literal(double x, const std::string& number) {
  return number == "double" ? format_shortest(x) : number + "(" + format_shortest(x) + ")";
}

/// The parameters and the model made of them.
std::string model_text(const Task& task, std::string_view expression, const std::string& number) {
  std::string text = "namespace oddity::asked {\n\nusing Number = " + number + ";\n\n";
  for (const Parameter& p : task.entry->exercise.parameters)
    if (mentions(expression, p.name))
      text += parameter_line(p, number, p.name, literal(task.parameters[p.name], number));
  return text + "\nauto model() { return " + in_number_type(expression, number) +
         "; }\n\n}  // namespace oddity::asked\n";
}

constexpr std::string_view print_row = R"(
void print_row(double t, const auto& observables) {
  std::printf("%.17g", t);
  for (double x : observables) std::printf(",%.17g", x);
  std::printf("\n");
}
)";

/// Prints a row, and keeps a hash of the bits of all rows and states.
constexpr std::string_view print_row_in_lockstep = R"(
oddity::BitsHash all;

void print_row(oddity::Lockstep<double> t, const auto& observables) {
  std::printf("%.17g", t.value());
  for (const auto& x : observables) std::printf(",%.17g", static_cast<double>(x.value()));
  std::printf("\n");
  all.add(observables);
}
)";
constexpr std::string_view ask_machine =
    R"(  if (!oddity::is_in_lockstep()) {
    std::fputs("compiled such that operations are not rounded each for itself: leave out -ffp-contract=fast\n", stderr);
    return 1;
  }
)";
constexpr std::string_view print_hash =
    R"(  std::printf("bits of all states and observables, as FNV-1a: %016llx\n", all.value());
)";

/// Rejects compiler options that break IEEE 754, and turns contraction off.
constexpr std::string_view one_rounding_each =
    R"(#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST)
#error "the bits of this program are those of IEEE 754: compile it without -ffast-math and its parts"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

)";
constexpr std::string_view no_wider_numbers =
    R"(static_assert(FLT_EVAL_METHOD == 0 && std::numeric_limits<double>::is_iec559,
              "every operation has to round to its type: on i386 compile with -msse2 -mfpmath=sse");
)";

/// Words with a dollar are placeholders.
constexpr std::string_view closed_form_main = R"(
int main() {
  constexpr int frames = $frames;
  constexpr double frames_per_second = $rate;
  const auto model = oddity::asked::model();
  std::printf("$names\n");
  for (int frame = 1; frame <= frames; ++frame) {
    const double t = frame / frames_per_second;
    print_row(t, model.at(oddity::asked::Number(t)));
  }
}
)";
constexpr std::string_view stepping_main = R"(
int main() {
  constexpr int frames = $frames, steps_per_frame = $steps;
  constexpr double frames_per_second = $rate;
  using oddity::asked::Number;
  auto model = oddity::asked::model();
  auto x = model.start();
  oddity::plain::$algorithm<decltype(model)> algorithm;
  std::printf("$names\n");
  for (int frame = 1; frame <= frames; ++frame) {
    const double t0 = (frame - 1) / frames_per_second, t1 = frame / frames_per_second;
    const double h = (t1 - t0) / steps_per_frame;
    for (int i = 0; i < steps_per_frame; ++i) algorithm.step(model, x, Number(t0 + i * h), Number(h))$seen;
    print_row(t1, model.observe(x, Number(t1)));
  }
}
)";

/// For frames of different lengths; a game would use the times of its clock instead.
constexpr std::string_view frames_main = R"(
const double frames[] = {$times};

int main() {
  using oddity::asked::Number;
  auto model = oddity::asked::model();
$before  std::printf("$names\n");
  for (const double t : frames) {
$frame  }
}
)";
constexpr std::string_view before_steps = R"(  constexpr double step = $step;
  auto x = model.start();
  oddity::plain::$algorithm<decltype(model)> algorithm;
)";
constexpr std::string_view divided =
    R"(    const double steps = std::fmax(1, std::ceil((t - before) * (1 - 1e-12) / step)), h = (t - before) / steps;
    for (int i = 0; i < steps; ++i) algorithm.step(model, x, Number(before + i * h), Number(h))$seen;
    print_row(t, model.observe(x, Number(t)));
    before = t;
)";
constexpr std::string_view accumulated =
    R"(    for (; static_cast<double>(done + 1) * step <= t * (1 + 1e-12); ++done) {
      before = x;
      algorithm.step(model, x, Number(static_cast<double>(done) * step), Number(step))$seen;
    }
    [[maybe_unused]] const double late = t - static_cast<double>(done) * step;
    auto drawn = x;
)";
constexpr std::string_view interpolated = R"(    for (std::size_t i = 0; i < x.size() && done > 0; ++i)
      drawn[i] = before[i] + Number(late / step) * (x[i] - before[i]);
)";
constexpr std::string_view extrapolated = R"(    auto rate = x;
    model(x, rate, Number(t - late));
    for (std::size_t i = 0; i < x.size(); ++i) drawn[i] += Number(late) * rate[i];
)";

/// Prints the CPU time of a frame, the best of several trials. seen() uses the results, so that no compiler
/// drops their computation.
constexpr std::string_view timed_main = R"(
template <class Numbers>
bool seen(const Numbers& numbers) {
  auto sum = numbers[0];
  for (std::size_t i = 1; i < numbers.size(); ++i) sum = sum + numbers[i];
  return sum < 0;
}

int main() {
  using oddity::asked::Number;
  volatile bool kept = false;
  double best = 1;
  long passes = 1;
  for (int trial = 0; trial < 9;) {
    const std::clock_t begun = std::clock();
    for (long pass = 0; pass < passes; ++pass) {
      const auto model = oddity::asked::model();
$pass    }
    const double seconds = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    if (seconds < 0.005) {
      passes *= 2;
      continue;
    }
    ++trial;
    best = std::fmin(best, seconds / static_cast<double>(passes));
  }
  std::printf("%.17g\n", best / $frames);
}
)";
constexpr std::string_view timed_steps = R"(      auto x = model.start();
      oddity::plain::$algorithm<std::remove_const_t<decltype(model)>> algorithm;
      for (int i = 0; i < $all_steps; ++i) algorithm.step(model, x, Number($step) * Number(i), Number($step));
      kept = seen(x);
)";
constexpr std::string_view timed_closed_form =
    R"(      for (int i = 1; i <= $frames; ++i) kept = seen(model.at(Number($step) * Number(i)));
)";

/// Replaces a word of C++, except in comments.
std::string with_word(const std::string& code, const std::string& word, const std::string& in_its_place) {
  std::string text;
  std::istringstream lines(code);
  const std::regex whole(word);
  for (std::string line; std::getline(lines, line);)
    text += (line.starts_with("///") ? line : std::regex_replace(line, whole, in_its_place)) + "\n";
  return text;
}

/// Replaces double and the functions of std by those of lockstep.
std::string in_lockstep_numbers(const std::string& code) {
  return with_word(with_word(code, R"(\bdouble\b)", "oddity::Lockstep<double>"),
                   R"(\bstd::(?=(?!printf)\w+\())", "oddity::lockstep::");
}

/// Headers without using-declarations of the C library's functions, which mention all of them. Lockstep's are
/// found by their arguments.
std::string without_library_functions(std::string headers) {
  if (const auto at = headers.find("using std::abs, "); at != headers.npos)
    headers.erase(at, headers.find(';', at) + 1 - at);
  return headers;
}

std::string before_text(Stepping stepping) {
  return std::string(before_steps) + (stepping == Stepping::divided
                                          ? "  double before = 0;\n"
                                          : "  long done = 0;\n  auto before = x;\n");
}

/// Body of the loop over frames, for a way to fit steps to frames.
std::string frame_text(Stepping stepping) {
  if (stepping == Stepping::divided) return std::string(divided);
  return std::string(accumulated) +
         std::string(stepping == Stepping::interpolated   ? interpolated
                     : stepping == Stepping::extrapolated ? extrapolated
                                                          : "") +
         "    print_row(t, model.observe(drawn, Number(t)));\n";
}

std::string times_text(const Need& need) {
  std::string times;
  for (std::size_t k = 0; k < static_cast<std::size_t>(need.frames()); ++k)
    times += (k == 0 ? "" : k % 6 == 0 ? ",\n    " : ", ") + format_shortest(need.frame_times->at[k]);
  return times;
}

std::string timed_text(const Need& need, const Plain* algorithm, double step) {
  const int steps =
      algorithm ? std::max(1, static_cast<int>(std::round(1 / (step * need.frames_per_second)))) : 1;
  const int frames = static_cast<int>(std::min(need.frames(), 1000.0));
  std::string text(timed_main);
  const auto put = [&](const std::string& placeholder, const std::string& what) {
    for (auto at = text.find(placeholder); at != std::string::npos; at = text.find(placeholder))
      text.replace(at, placeholder.size(), what);
  };
  put("$pass", std::string(algorithm ? timed_steps : timed_closed_form));
  put("$frames", std::to_string(frames));
  put("$all_steps", std::to_string(frames * steps));
  put("$step", format_shortest(1 / (need.frames_per_second * steps)));
  if (algorithm) put("$algorithm", std::string(algorithm->type));
  return text;
}

std::string main_text(const Task& task, const Need& need, const Plain* algorithm, double step,
                      Stepping stepping) {
  const bool differ = need.frame_times != nullptr;
  const auto in_its_numbers = [&](const std::string& code) {
    return need.lockstep ? in_lockstep_numbers(code) : code;
  };
  std::string text = in_its_numbers(std::string(differ      ? frames_main
                                                : algorithm ? stepping_main
                                                            : closed_form_main));
  const auto put = [&](const std::string& placeholder, const std::string& what) {
    text.replace(text.find(placeholder), placeholder.size(), what);
  };
  put("$names", header_line(*task.entry->exercise.scene));
  if (differ) {
    put("$times", times_text(need));
    put("$before", algorithm ? in_its_numbers(before_text(stepping)) : "");
    put("$frame",
        algorithm ? in_its_numbers(frame_text(stepping)) : "    print_row(t, model.at(Number(t)));\n");
  } else {
    put("$frames", integer_text(need.frames()));
    put("$rate", format_shortest(need.frames_per_second));
  }
  if (algorithm && differ) {
    put("$step", format_shortest(step));
    put("$algorithm", std::string(algorithm->type));
  } else if (algorithm) {
    put("$steps", integer_text(1 / (step * need.frames_per_second)));
    put("$algorithm", std::string(algorithm->type));
  }
  if (algorithm) put("$seen", need.lockstep ? ", all.add(x)" : "");
  if (!need.lockstep) return text;
  const std::string started = "  auto x = model.start();\n";
  if (algorithm) text.insert(text.find(started) + started.size(), "  all.add(x);\n");
  const std::string_view begun = "int main() {\n";
  text.insert(text.find(begun) + begun.size(), ask_machine);
  return text.insert(text.rfind('}'), print_hash);
}

}  // namespace

std::vector<std::string_view> printable_algorithms() {
  std::vector<std::string_view> all{closed_form};
  for (const Plain& p : plain_algorithms) all.push_back(p.algorithm);
  return all;
}

namespace {

/// The program without its heading comment.
std::string program_of(const Task& task, const Candidate& chosen, const Need& need, bool is_timed) {
  const Exercise& exercise = task.entry->exercise;
  const Listing& listing = exercise.scene->listing;
  const bool single = chosen.precision == Precision::in_float;
  if (single && listing.text)
    throw BadInput("there is no code in float for a problem's file: ask with --precision double");
  const auto [model, algorithm] =
      printed(*exercise.scene, chosen.model, in_double(std::string(without_stepping(chosen.algorithm))));
  Joined headers;
  if (need.lockstep) headers.add(lockstep_header);
  for (std::string_view header : listing.headers) headers.add(header);
  if (algorithm) headers.add(algorithm->header);
  headers.add_standard("cstdio");
  if (need.frame_times) headers.add_standard("cmath"), headers.add_standard("cstddef");
  if (listing.text) headers.add_standard("array"), headers.add_standard("cmath");
  if (need.lockstep) headers.add_standard("cfloat");
  if (is_timed)
    for (const char* header : {"cmath", "cstddef", "ctime", "type_traits"}) headers.add_standard(header);
  std::string of_file = listing.text ? listing.text(task.parameters, chosen.model) + "\n" : "";
  if (need.lockstep) of_file = in_lockstep_numbers(of_file);
  const std::string number = single ? "float" : "double";
  std::string own =
      of_file + model_text(task, model, need.lockstep ? "oddity::Lockstep<" + number + ">" : number);
  if (is_timed)
    own += timed_text(need, algorithm, chosen.setting);
  else
    own += std::string(need.lockstep ? print_row_in_lockstep : print_row) +
           main_text(task, need, algorithm, chosen.setting, stepping_of(chosen.algorithm));
  if (need.lockstep) own = std::string(no_wider_numbers) + "\n" + own;
  const std::string all = need.lockstep ? without_library_functions(headers.text()) : headers.text();
  std::string code = used_code(all, own) + "\n" + own;
  code.erase(1, code.find_first_not_of('\n') - 1);
  return std::string(need.lockstep ? one_rounding_each : "") + headers.includes(code) + code;
}

/// How to compile the program, and how exactly it reproduces oddity's numbers.
std::string compiling_of(const Listing& listing, const Candidate& chosen, const Need& need) {
  if (need.lockstep)
    return "\nCompiled by any compiler for C++20, whatever its optimization, it prints the same hash of its bits on "
           "every machine.\nCompile it without -ffast-math, and for i386 with -msse2 -mfpmath=sse.";
  return "\nCompiled by c++ -std=c++20 -O2 -ffp-contract=off it prints oddity's own numbers" +
         std::string(
             chosen.precision == Precision::in_float
                 ? ", except for the observables' roundings: oddity observes a motion in float in double."
             : listing.text || need.frame_times ? ", except for roundings."
                                                : ".");
}

/// Functions of <cmath> that lockstep does not implement.
const std::regex& not_in_lockstep() {
  static const std::regex names(
      R"(\b(pow|cbrt|atan|tanh|acosh|atanh|exp2|log2|log10|log1p|fma|erfc?|[tl]gamma|ellint_\w+|complex)\s*[(<])");
  return names;
}

/// The model's code, with the parts of the headers that it needs.
std::string model_code_of(const Task& task, std::string_view model, std::string_view expression) {
  const Listing& listing = task.entry->exercise.scene->listing;
  Joined headers;
  for (std::string_view header : listing.headers) headers.add(header);
  const std::string own = (listing.text ? listing.text(task.parameters, std::string(model)) : "") +
                          "auto model = " + std::string(expression) +
                          "; model.start(), model.observe, model.at, model.acceleration, model.step;";
  return used_code(headers.text(), own) + own;
}

/// Names of functions that are called in code, each once.
std::vector<std::string> called_in(const std::string& code, const std::regex& names) {
  std::set<std::string> all;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    const std::string statement = line.substr(0, line.find("//"));
    for (std::sregex_iterator found(statement.begin(), statement.end(), names), end; found != end; ++found)
      all.insert((*found)[1].str());
  }
  return {all.begin(), all.end()};
}

}  // namespace

std::string why_not_in_lockstep(const Task& task, const std::string& model, const std::string& algorithm) {
  const std::string plainly = in_double(std::string(without_stepping(algorithm)));
  const Listing& listing = task.entry->exercise.scene->listing;
  if (listing.text && plainly != without_stepping(algorithm))
    return "is in float, in which a problem's file has no code";
  const auto* expression = find(listing.models, model + ", " + plainly);
  if (!expression) expression = find(listing.with_own_steps, model + ", " + plainly);
  if (!expression) {
    const auto algorithms = printable_algorithms();
    if (std::ranges::find(algorithms, plainly) == algorithms.end()) {
      const auto known = std::ranges::find(ode::catalog(), plainly, &ode::CatalogEntry::name);
      if (known == ode::catalog().end()) return "has a loop that --code does not print";
      if (known->library == ode::Facts::own) return "has a loop that --code does not print";
      return "calls " + std::string(known->library);
    }
    expression = find(listing.models, model);
    const auto* why = find(listing.not_printable, model);
    if (!expression) return "has a model " + (why ? std::string(*why) : "that --code does not print");
  }
  const std::vector<std::string> foreign =
      called_in(model_code_of(task, model, *expression), not_in_lockstep());
  return foreign.empty() ? "" : "has a model that calls the C library's " + foreign.front();
}

std::vector<std::string> functions_in_lockstep(const Task& task, const Candidate& chosen) {
  static const std::regex names(
      R"(\b(sin|cos|tan|asin|acos|atan2|exp|expm1|log|sinh|cosh|asinh|hypot)\s*\()");
  const auto [model, algorithm] = printed(*task.entry->exercise.scene, chosen.model,
                                          in_double(std::string(without_stepping(chosen.algorithm))));
  return called_in(model_code_of(task, chosen.model, model), names);
}

std::string timing_code_of(const Task& task, const Candidate& chosen, Need need, bool lockstep) {
  need.lockstep = lockstep;
  return program_of(task, chosen, need, true);
}

namespace {

/// The models' own source, with templates and all.
std::string with_source(const Task& task, const Candidate& chosen, const Need& need,
                        const std::string& about) {
  const std::string program = program_of(task, chosen, need, false);
  return as_comment(about + compiling_of(task.entry->exercise.scene->listing, chosen, need)) + "\n" + program;
}

}  // namespace

std::string program_template(std::string_view algorithm) {
  const Plain* plain = std::ranges::find(plain_algorithms, algorithm, &Plain::algorithm);
  Joined headers;
  for (const char* header : {"array", "cmath", "cstdio"}) headers.add_standard(header);
  std::string main(closed_form_main);
  if (plain != std::end(plain_algorithms)) {
    headers.add(plain->header);
    main = stepping_main;
    main.replace(main.find("$algorithm"), std::string_view("$algorithm").size(), plain->type);
    main.erase(main.find("$seen"), std::string_view("$seen").size());
  }
  const std::string own = "$model" + std::string(print_row) + main;
  std::string code = used_code(headers.text(), own) + "\n" + own;
  code.erase(1, code.find_first_not_of('\n') - 1);
  return headers.includes("std::array sqrt" + code) + code;
}

long lines_of_code(const std::string& program) {
  std::istringstream lines(program);
  long count = 0;
  for (std::string line; std::getline(lines, line);)
    if (const auto first = line.find_first_not_of(' '); first != line.npos)
      count += !line.substr(first).starts_with("//");
  return count;
}

std::string code_of(const Task& task, const Candidate& chosen, const Need& need, const std::string& about,
                    Language language) {
  if (language != Language::cpp) return program_in(language, task, chosen, need, about);
  const std::string whole = with_source(task, chosen, need, about);
  if (lines_of_code(whole) <= most_lines_of_source) return whole;
  try {
    const std::string shorter = program_in(language, task, chosen, need, about);
    return lines_of_code(shorter) < lines_of_code(whole) ? shorter : whole;
  } catch (const BadInput&) {
    return whole;
  }
}

std::string code_of(const Task& task, const Choice& choice, const std::string& command, Language language) {
  const Screen page{107};
  if (!choice.chosen) throw BadInput("nothing here meets the need, and there is no code to print");
  return code_of(task, *choice.chosen, choice.need,
                 wrapped(to_string(task.entry->number) + " " + std::string(task.entry->exercise.title) +
                             ": " + asked_text(choice) + "\n\n" + answer_text(choice),
                         page, 4) +
                     "\nThe observables at every frame, by\n  " + command,
                 language);
}

}  // namespace oddity
