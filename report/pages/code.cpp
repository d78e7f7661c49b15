#include "report/pages/code.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/pages/choose_view.hpp"
#include "report/study/embedded.hpp"
#include "report/study/frames.hpp"
#include "report/text/readable.hpp"
#include "report/text/used_code.hpp"

namespace oddity {

namespace {

/// One that report/plain has.
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

std::string listed(const std::vector<std::string_view>& names) {
  std::string all;
  for (std::string_view name : names) all += (all.empty() ? "" : "; ") + std::string(name);
  return all.empty() ? "none" : all;
}

/// How a method is printed: the expression that constructs its model, and its algorithm; none for a closed
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

/// Without " in float".
std::string in_double(const std::string& algorithm) {
  const std::string_view suffix = " in float";
  return algorithm.ends_with(suffix) ? algorithm.substr(0, algorithm.size() - suffix.size()) : algorithm;
}

/// Of models that are shown to be wrong there is none to choose.
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

/// Headers put one behind the other, each once, after those that it includes.
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

  /// Those that the code needs.
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

/// A backslash at the end of a comment, which may be anybody's text, would join the next line to it.
std::string with_lines_apart(std::string code) {
  for (auto at = code.find("\\\n"); at != std::string::npos; at = code.find("\\\n", at))
    code.insert(at + 1, ".");
  return code;
}

std::string as_comment(const std::string& text) {
  std::string comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) comment += line.empty() ? "//\n" : "// " + line + "\n";
  return comment;
}

std::string literal(double x, const std::string& number) {
  return number == "double" ? format_shortest(x) : number + "(" + format_shortest(x) + ")";
}

/// The parameters and the model that they make.
std::string model_text(const Task& task, std::string_view expression, const std::string& number) {
  std::string text = "namespace oddity::asked {\n\nusing Number = " + number + ";\n\n";
  for (const Parameter& p : task.entry->exercise.parameters)
    if (mentions(expression, p.name))
      text += number + " " + std::string(p.name) + " = " + literal(task.parameters[p.name], number) +
              ";  // " + (p.unit.empty() || p.unit == "1" ? "" : std::string(p.unit) + ": ") +
              readable(std::string(p.says)) + "\n";
  return text + "\nauto model() { return " + in_number_type(expression, number) +
         "; }\n\n}  // namespace oddity::asked\n";
}

std::string header_line(const Scene& scene) {
  std::string line = "t [" + std::string(scene.axes.time) + "]";
  for (std::string_view name : scene.axes.observables) line += "," + std::string(name);
  return line;
}

constexpr std::string_view print_row = R"(
template <class Observables>
void print_row(double t, const Observables& observables) {
  std::printf("%.17g", t);
  for (double x : observables) std::printf(",%.17g", x);
  std::printf("\n");
}
)";

/// The words with a dollar are placeholders.
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
    for (int i = 0; i < steps_per_frame; ++i) algorithm.step(model, x, Number(t0 + i * h), Number(h));
    print_row(t1, model.observe(x, Number(t1)));
  }
}
)";

/// Frames of different lengths: a program of one's own has its clock's in their place.
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
    for (int i = 0; i < steps; ++i) algorithm.step(model, x, Number(before + i * h), Number(h));
    print_row(t, model.observe(x, Number(t)));
    before = t;
)";
constexpr std::string_view accumulated =
    R"(    for (; static_cast<double>(done + 1) * step <= t * (1 + 1e-12); ++done) {
      before = x;
      algorithm.step(model, x, Number(static_cast<double>(done) * step), Number(step));
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

std::string before_text(Stepping stepping) {
  return std::string(before_steps) + (stepping == Stepping::divided
                                          ? "  double before = 0;\n"
                                          : "  long done = 0;\n  auto before = x;\n");
}

/// The loop's body for the way in which steps meet frames.
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

std::string main_text(const Task& task, const Need& need, const Plain* algorithm, double step,
                      Stepping stepping) {
  const bool differ = need.frame_times != nullptr;
  std::string text(differ ? frames_main : algorithm ? stepping_main : closed_form_main);
  const auto put = [&](const std::string& placeholder, const std::string& what) {
    text.replace(text.find(placeholder), placeholder.size(), what);
  };
  put("$names", header_line(*task.entry->exercise.scene));
  if (differ) {
    put("$times", times_text(need));
    put("$before", algorithm ? before_text(stepping) : "");
    put("$frame", algorithm ? frame_text(stepping) : "    print_row(t, model.at(Number(t)));\n");
  } else {
    put("$frames", format_shortest(need.frames()));
    put("$rate", format_shortest(need.frames_per_second));
  }
  if (algorithm && differ) {
    put("$step", format_shortest(step));
    put("$algorithm", std::string(algorithm->type));
  } else if (algorithm) {
    put("$steps", format_shortest(std::round(1 / (step * need.frames_per_second))));
    put("$algorithm", std::string(algorithm->type));
  }
  return text;
}

}  // namespace

bool mentions(std::string_view expression, std::string_view name) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (auto at = expression.find(name); at != std::string_view::npos; at = expression.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || !in_word(expression[at - 1])) && (end == expression.size() || !in_word(expression[end])))
      return true;
  }
  return false;
}

std::string in_number_type(std::string_view expression, std::string_view number) {
  constexpr std::string_view old = "double";
  std::string text(expression);
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + number.size()))
    text.replace(at, old.size(), number);
  return text;
}

std::vector<std::string_view> printable_algorithms() {
  std::vector<std::string_view> all{closed_form};
  for (const Plain& p : plain_algorithms) all.push_back(p.algorithm);
  return all;
}

std::string code_of(const Task& task, const Candidate& chosen, const Need& need, const std::string& about) {
  const Exercise& exercise = task.entry->exercise;
  const Listing& listing = exercise.scene->listing;
  const bool single = chosen.precision == Precision::in_float;
  if (single && listing.text)
    throw BadInput("there is no code in float for a problem's file: ask with --precision double");
  const auto [model, algorithm] =
      printed(*exercise.scene, chosen.model, in_double(std::string(without_stepping(chosen.algorithm))));
  Joined headers;
  for (std::string_view header : listing.headers) headers.add(header);
  if (algorithm) headers.add(algorithm->header);
  headers.add_standard("cstdio");
  if (need.frame_times) headers.add_standard("cmath"), headers.add_standard("cstddef");
  if (listing.text) headers.add_standard("array"), headers.add_standard("cmath");
  const std::string compiled =
      "\nCompiled by c++ -std=c++20 -O2 -ffp-contract=off it prints oddity's own numbers" +
      std::string(single
                      ? ", but for the observables' roundings: oddity observes a motion in float in double."
                  : listing.text || need.frame_times ? ", but for roundings."
                                                     : ".");
  const std::string own = (listing.text ? listing.text(task.parameters, chosen.model) + "\n" : "") +
                          model_text(task, model, single ? "float" : "double") + std::string(print_row) +
                          main_text(task, need, algorithm, chosen.setting, stepping_of(chosen.algorithm));
  std::string code = used_code(headers.text(), own) + "\n" + own;
  code.erase(1, code.find_first_not_of('\n') - 1);
  return with_lines_apart(as_comment(about + compiled) + "\n" + headers.includes(code) + code);
}

std::string code_of(const Task& task, const Choice& choice, const std::string& command) {
  if (!choice.chosen) throw BadInput("nothing here meets the need, and there is no code to print");
  return code_of(task, *choice.chosen, choice.need,
                 to_string(task.entry->number) + " " + std::string(task.entry->exercise.title) + ": " +
                     asked_text(choice) + "\n\n" + answer_text(choice) +
                     "\nThe observables at every frame, by\n  " + command);
}

}  // namespace oddity
