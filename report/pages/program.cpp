#include "report/pages/program.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "chapters/listing.hpp"
#include "formula/program.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/pages/code.hpp"
#include "report/pages/code_text.hpp"
#include "report/pages/dialects.hpp"
#include "report/pages/program_parts.hpp"
#include "report/study/embedded.hpp"
#include "report/study/frames.hpp"
#include "report/study/recorded_model.hpp"

namespace oddity {

namespace {

using Lines = std::vector<std::string>;

// ---- the model --------------------------------------------------------------------------------------------

/// Their own, with a suffix where a program needs that name itself.
std::vector<std::string> parameter_names(const Task& task) {
  std::set<std::string> taken = program_parts::reserved_names();
  std::vector<std::string> names;
  for (const Parameter& p : task.entry->exercise.parameters)
    names.push_back(formula::free_name(std::string(p.name), taken));
  return names;
}

/// Finds the model in the listing, where a closed form may be named with its algorithm.
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

/// Records a closed form that iterates until it has settled, as at the frame with the most operations. These
/// must give the same values at all other frames.
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

/// A model as its program computes it, and a note on that for the program's head.
struct Written {
  std::string_view name;  ///< in the listing
  RecordedModel model;
  std::string note = {};
};

Written written(const Task& task, const Candidate& chosen, const Need& need) {
  const Recorder* recorder = recorder_of(task, chosen);
  if (!recorder)
    throw BadInput("the model '" + chosen.model + "' is in none of the listings that are recorded");
  ToRecord asked{parameter_names(task), {}};
  for (const Parameter& p : task.entry->exercise.parameters) asked.values.push_back(task.parameters[p.name]);
  asked.t = 1 / need.frames_per_second;
  RecordedModel model = recorder->record(asked);
  if (!model.branched_at_start && !model.branched) return {recorder->model, model};
  const std::string note = "\nThe parameters are worked in: other values need another program.";
  asked.with_letters = false;
  model = recorder->record(asked);
  if (!model.branched) return {recorder->model, model, note};
  if (!model.start.empty()) throw BadInput("the operations of its equations differ from state to state");
  return {
      recorder->model, longest(*recorder, asked, need),
      note + "\nIts iterations are written out, as many as these frames need: other frames may need more."};
}

/// The comment on a type in a header; empty if it has none there.
std::string comment_in(const EmbeddedFile& header, const std::string& type) {
  std::istringstream lines{std::string(header.text)};
  std::string comment;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("/// "))
      comment += line.substr(1) + "\n";
    else if ((line + " ").starts_with("struct " + type + " "))
      return comment;
    else if (!line.starts_with("template") && !line.starts_with("requires"))
      comment.clear();
  }
  return "";
}

/// The comment on a model's type in the listing's headers, or in those that they include.
std::string comment_of(const Listing& listing, std::string_view model) {
  static const std::regex type(R"(::(\w+)[<(])");
  std::string expression;
  for (const auto& models : {listing.models, listing.with_own_steps})
    for (const auto& [name, made] : models)
      if (name == model) expression = made;
  std::smatch found;
  if (!std::regex_search(expression, found, type)) return "";
  std::string comment, of_included;
  for (const EmbeddedFile& own : embedded_headers()) {
    if (std::ranges::find(listing.headers, own.path) == listing.headers.end()) continue;
    if (comment.empty()) comment = comment_in(own, found[1]);
    for (const EmbeddedFile& header : embedded_headers())
      if (own.text.find("#include \"" + std::string(header.path) + "\"") != own.text.npos &&
          of_included.empty())
        of_included = comment_in(header, found[1]);
  }
  return comment.empty() ? of_included : comment;
}

/// The comment on the member function in the listing's headers whose part is this helper.
std::string comment_of_helper(const Listing& listing, const std::string& name) {
  for (const EmbeddedFile& header : embedded_headers()) {
    const auto at = header.text.find("as_function(\"" + name + "(");
    if (at == header.text.npos || std::ranges::find(listing.headers, header.path) == listing.headers.end())
      continue;
    std::istringstream lines{std::string(header.text.substr(0, at))};
    std::string comment;
    bool goes_on = false;
    for (std::string line; std::getline(lines, line);) {
      const auto text = line.find("/// ");
      const bool is_comment = text != line.npos && line.find_first_not_of(' ') == text;
      if (is_comment && !goes_on) comment.clear();
      goes_on = is_comment;
      if (is_comment) comment += line.substr(text + 1) + "\n";
    }
    return comment;
  }
  return "";
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
  constexpr std::size_t line_length = 106;
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

/// Meaning of an orientation's columns.
constexpr std::string_view about_orientation = R"(
// The last four numbers, the quaternion (w, x, y, z), turn the body's axes into space's: the body's x axis is
// (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)).
)";

std::string function_text(const std::string& head, const std::string& type, const formula::Statements& made) {
  std::string text = "\nstatic " + type + " " + head + " {\n";
  for (const std::string& line : made.lines) text += "  " + line + "\n";
  if (type == "double") return text + "  return " + made.terms.front() + ";\n}\n";
  const std::string returned = "  return new " + type + " {";
  return text + returned + terms_text(made.terms, returned.size()) + "};\n}\n";
}

/// The functions of a model whose steps test whether it comes to rest.
std::string stick_test_text(formula::Program& program, const RecordedModel& model) {
  return function_text("Speed(State x)", "double", program.function(model.speed)) +
         function_text("Braking(State x, State r)", "double", program.function(model.braking)) +
         function_text("Coasted(State x, State r)", "State", program.function(model.coasted));
}

constexpr std::string_view helper_mark = "// Helper ";

/// The helpers of a program, each with its constants and tables.
std::string helpers_text(const Listing& listing, const std::vector<formula::Program::Helper>& helpers) {
  std::string text;
  for (const auto& [name, arguments, constants, body] : helpers) {
    std::string head = name, parameters, letters;
    head.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(head.front())));
    for (const std::string& letter : arguments) {
      letters += (letters.empty() ? "" : ", ") + letter;
      parameters += (parameters.empty() ? "double " : ", double ") + letter;
    }
    text += "\n" + std::string(helper_mark) + head + "(" + letters + ")\n" + comment_of_helper(listing, name);
    for (const std::string& line : constants) text += line + "\n";
    text += function_text(head + "(" + parameters + ")", "Array" + std::to_string(body.terms.size()), body)
                .substr(constants.empty() ? 1 : 0);
  }
  return text;
}

/// Declares the parameters among the letters; neighbors of one meaning together.
std::string parameters_text(const Task& task, const std::set<std::string>& letters) {
  const std::vector<std::string> names = parameter_names(task);
  const auto& all = task.entry->exercise.parameters;
  std::string text;
  for (std::size_t i = 0; i < names.size();) {
    const Parameter& first = all[i];
    std::string declared, last;
    for (; i < names.size() && all[i].says == first.says && all[i].unit == first.unit; ++i) {
      if (!letters.contains(names[i])) continue;
      declared += last + (last.empty() ? "" : ", ") + names[i] + " = ";
      last = format_shortest(task.parameters[all[i].name]);
    }
    if (!last.empty())
      text += parameter_line(first, "static readonly double", declared.substr(0, declared.size() - 3), last);
  }
  return text;
}

/// Parameters, constants and the functions of the model.
std::string model_text(const Task& task, const RecordedModel& model, std::string_view name, bool by_forces,
                       bool may_stick) {
  std::set<std::string> moving{"t"}, taken = program_parts::reserved_names();
  for (std::size_t i = 0; i < model.start.size(); ++i) {
    moving.insert(state_letter('x', i));
    moving.insert(state_letter('q', i));
    moving.insert(state_letter('r', i));
  }
  for (const std::string& parameter : parameter_names(task)) taken.insert(parameter);
  const auto& moves = by_forces ? model.acceleration : model.rates;
  formula::Program program(*model.record, moving, {model.observed, moves, model.speed, model.braking}, taken,
                           {model.start, model.coasted});
  const Listing& listing = task.entry->exercise.scene->listing;
  std::string constants, bodies;
  for (const std::string& line : program.constants()) constants += line + "\n";
  if (model.start.empty()) {
    bodies = function_text("At(double t)", "Seen", program.function(model.observed));
  } else {
    bodies = function_text("Start()", "State", program.function(model.start)) +
             (by_forces ? function_text("Acceleration(State q)", "Half", program.function(moves))
                        : function_text("Rates(State x, double t)", "State", program.function(moves))) +
             (may_stick ? stick_test_text(program, model) : "") +
             std::string(model.orientation.empty() ? "" : about_orientation) +
             function_text("Observe(State x, double t)", "Seen", program.function(model.observed))
                 .substr(model.orientation.empty() ? 0 : 1);
  }
  const std::string comment = comment_of(listing, name);
  if (!comment.empty()) bodies = "\n" + comment + bodies.substr(1);
  const std::string parameters = parameters_text(
      task, formula::letters_of(*model.record, {model.start, moves, model.observed, model.braking}));
  const std::string text = parameters + (constants.empty() ? "" : "\n" + constants) +
                           helpers_text(listing, program.helpers()) + bodies;
  return text.substr(text.find_first_not_of('\n'));
}

// ---- the program around it --------------------------------------------------------------------------------

void put(std::string& text, const std::string& placeholder, const std::string& what) {
  text.replace(text.find(placeholder), placeholder.size(), what);
}

std::string main_text(Language language, const Task& task, const Candidate& chosen, const Need& need,
                      const RecordedModel& model) {
  const bool steps = !model.start.empty();
  const program_parts::Main& main = program_parts::main_of(language);
  std::string text(main.text);
  put(text, "$frames", integer_text(need.frames()));
  put(text, "$steps",
      steps ? ", steps_per_frame = " + integer_text(1 / (chosen.setting * need.frames_per_second)) : "");
  put(text, "$rate", format_shortest(need.frames_per_second));
  put(text, "$names",
      header_line(*task.entry->exercise.scene) + (model.orientation.empty() ? "" : ",qw,qx,qy,qz"));
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

std::string_view name_of(Language language) { return language_names[static_cast<std::size_t>(language)]; }

/// Reason why no choice for the need has a program; empty if a choice may have one.
std::string why_without_program(const Task& task, const Need& need, bool single) {
  if (task.entry->exercise.scene->listing.text) return "it is a problem's file";
  if (single) return "it is in float";
  if (need.frame_times) return "its frames are of different lengths";
  return need.lockstep ? "it is asked to run in lockstep" : "";
}

[[noreturn]] void refuse(Language language, const std::string& why) {
  throw BadInput("there is no code in " + std::string(name_of(language)) + " for this choice: " + why +
                 "; leave out --language for C++");
}

}  // namespace

Language language_of(std::string_view name) {
  constexpr std::string_view short_names[] = {"cpp", "cs", "js"};
  const auto lower = [](std::string_view text) {
    std::string all;
    for (const char c : text) all += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return all;
  };
  std::string known;
  for (std::size_t i = 0; i < std::size(language_names); ++i) {
    if (lower(name) == lower(language_names[i]) || lower(name) == short_names[i])
      return static_cast<Language>(i);
    known += (known.empty() ? "" : ", ") + std::string(language_names[i]) + " (" +
             std::string(short_names[i]) + ")";
  }
  throw BadInput("there is no code in '" + std::string(name) + "'; there is in " + known);
}

void require_language(Language language, const Task& task, const Need& need) {
  if (language == Language::cpp) return;
  if (const std::string why = why_without_program(task, need, !need.in_double); !why.empty())
    refuse(language, why);
}

std::vector<PrintedHelper> helpers_in(const std::string& code) {
  std::vector<PrintedHelper> all;
  std::istringstream lines(code);
  std::string end;  // the last line of the helper that is read; empty: of none
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find_first_not_of(' ');
    if (at == line.npos) continue;
    if (const std::string text = line.substr(at); text.starts_with(helper_mark)) {
      const auto name = helper_mark.size();
      all.push_back({text.substr(name, text.find('(') - name), 0});
      end = std::string(at, ' ') + "}";
    } else if (!end.empty()) {
      all.back().lines += lines_of_code(line);
      if (line == end) end.clear();
    }
  }
  return all;
}

std::string program_in(Language language, const Task& task, const Candidate& chosen, const Need& need,
                       const std::string& about) {
  if (const std::string why = why_without_program(task, need, chosen.precision == Precision::in_float);
      !why.empty())
    refuse(language, why);
  try {
    auto [name, model, note] = written(task, chosen, need);
    const std::string algorithm =
        program_parts::algorithm_text(std::string(without_stepping(chosen.algorithm)), model);
    const bool by_forces = algorithm.find("Acceleration(") != algorithm.npos;
    const bool may_stick = algorithm.find("Coasted(") != algorithm.npos;
    if (!may_stick) model.speed.clear(), model.braking.clear(), model.coasted.clear();
    turn_along(model, !by_forces && algorithm.find("velocities") == algorithm.npos);
    const Dialect dialect{model.start.size(), model.observed.size()};
    std::string code = dialect.in(language, model_text(task, model, name, by_forces, may_stick) + algorithm);
    code += program_parts::helpers_for(language, code);
    code += main_text(language, task, chosen, need, model);
    const std::string head = about + "\n" + std::string(runs[static_cast<std::size_t>(language)]) +
                             " it prints oddity's own numbers, except for roundings." + note;
    return as_comment(head) + "\n" + whole(language, code);
  } catch (const BadInput& why) {
    refuse(language, why.what());
  }
}

}  // namespace oddity
