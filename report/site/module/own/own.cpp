// Reads a problem's file typed into the page: reports its errors, or makes its models into the scene that the
// module runs.

#include <algorithm>
#include <cmath>
#include <exception>

#include "problem/claims.hpp"
#include "problem/code.hpp"
#include "problem/file.hpp"
#include "problem/model.hpp"
#include "problem/staging.hpp"
#include "reference/code_text.hpp"
#include "reference/quantity_text.hpp"
#include "reference/text.hpp"
#include "report/site/module/json.hpp"
#include "report/site/module/own/played.hpp"
#include "report/text/readable.hpp"

namespace oddity::module {

namespace {

using problem::File, problem::ModelText, problem::ObservableText, problem::ParameterText;

/// The last valid text, and its models.
struct Own {
  std::unique_ptr<const File> file;
  std::vector<problem::Model> models;
  std::unique_ptr<const problem::Sheet> sheet;
};

Own own;
std::vector<Scene> all_scenes;
std::string answer;

Own own_of(const std::string& text) {
  Own made{problem::read("this file", text), {}, nullptr};
  problem::require_parameters(*made.file);
  for (const ModelText& model : made.file->models) {
    made.models.emplace_back(*made.file, model);
    if (!made.models.back().is_closed()) problem::require_start(*made.file, model, made.models.back());
  }
  made.sheet = std::make_unique<const problem::Sheet>(*made.file, "file");
  if (made.file->staged) problem::Staged{*made.file};  // for its errors
  return made;
}

Scene scene_of(const Own& of) {
  Scene scene{"own", of.file->observables.size(), {}, {}, nullptr};
  for (const ParameterText& p : of.file->parameters) scene.letters.push_back({p.name, p.value});
  for (const problem::Model& model : of.models)
    scene.models.push_back(
        {model.name(), "", [&model](std::span<const double> values) { return played(model, values); }});
  return scene;
}

// ---- the answer, as JSON ----------------------------------------------------------------------------------

std::string text_of(double x) { return std::isfinite(x) ? format_shortest(x) : "null"; }

std::string text_of(const ParameterText& p) {
  return "{\"name\":" + quoted(p.name) + ",\"says\":" + quoted(p.says == p.name ? "" : p.says) +
         ",\"unit\":" + quoted(p.unit) + ",\"value\":" + text_of(p.value) + ",\"least\":" + text_of(p.least) +
         ",\"most\":" + text_of(p.most) + ",\"whole\":" + flag(p.whole) + "}";
}

std::string text_of(const ObservableText& o) {
  return "{\"name\":" + quoted(o.name) + ",\"unit\":" + quoted(o.unit) + ",\"point\":" + quoted(o.point) +
         "}";
}

/// The accepted units, by the unit of each parameter, and of the time.
std::string units_of(const File& file) {
  std::vector<std::string> units{"s"};
  for (const ParameterText& p : file.parameters)
    if (std::find(units.begin(), units.end(), p.unit) == units.end()) units.push_back(p.unit);
  std::string all;
  for (const std::string& unit : units) {
    std::string like;
    for (const auto& [name, size] : units_like(unit))
      like += (like.empty() ? "" : ",") + quoted(name) + ":" + text_of(size);
    all += (all.empty() ? "" : ",") + quoted(unit) + ":{" + like + "}";
  }
  return "{" + all + "}";
}

std::string text_of(const File& file) {
  return "{\"title\":" + quoted(file.title) + ",\"question\":" + quoted(file.question) +
         ",\"parameters\":" + listed(file.parameters, [](const auto& p) { return text_of(p); }) +
         ",\"observables\":" + listed(file.observables, [](const auto& o) { return text_of(o); }) +
         ",\"errors\":" + listed(file.errors, [](double x) { return text_of(x); }) +
         ",\"horizon\":" + text_of(file.end) + ",\"fps\":" + text_of(in_unit(file.frames_per_second, "1/s")) +
         ",\"sweep\":" + quoted(file.sweep) + ",\"claims\":" + std::to_string(file.claims.size()) +
         ",\"units\":" + units_of(file) + "}";
}

/// JSON of a reading's check: both values with their routes, as a readable line.
std::string text_of(const std::string& reading, const Check& check) {
  const auto side = [](const Route& route) {
    const std::string value = route.value.size() == 1 ? format_significant(route.value[0], 6) : "";
    return value + (value.empty() ? "" : " ") + "(" + readable(route.by) + ")";
  };
  return "{\"reading\":" + quoted(reading) + ",\"holds\":" + flag(check.holds()) +
         ",\"text\":" + quoted(side(check.left) + " against " + side(check.right)) +
         ",\"where\":" + quoted(check.where) + "}";
}

std::string text_of(const Claim& claim, const problem::ClaimText& text, const std::string& expected) {
  std::string checks;
  const auto add = [&](const std::string& name, const Reading& reading) {
    for (const Check& one : reading.checks) checks += (checks.empty() ? "" : ",") + text_of(name, one);
  };
  add("printed", claim.printed), add("meant", claim.meant), add("corrected", claim.corrected);
  for (const Reading& near : claim.near_misses)
    if (near.holds()) add("the near miss " + readable(near.text), near);
  return "{\"says\":" + quoted(text.says) + ",\"printed\":" + quoted(text.printed->text) +
         ",\"verdict\":" + quoted(name_of(verdict(claim))) + ",\"expected\":" + quoted(expected) +
         ",\"why\":" + quoted(readable(claim.why)) + ",\"checks\":[" + checks + "]}";
}

/// The parameters that a model's code needs, and the model that they make.
std::string construction_of(const File& file, const problem::Model::Code& code, const double* values) {
  std::string letters, members;
  for (const std::string& name : code.members) {
    members += (members.empty() ? "" : ", ") + name;
    const auto p = std::ranges::find(file.parameters, name, &ParameterText::name);
    letters += "double " + name + " = " + format_shortest(values[p - file.parameters.begin()]) + ";  // " +
               (p->unit.empty() || p->unit == "1" ? "" : p->unit + ": ") + in_comment(readable(p->says)) +
               "\n";
  }
  return "namespace oddity::asked {\n\nusing Number = double;\n\n" + letters +
         "\nauto model() { return problem::" + code.type + "{" + members +
         "}; }\n\n}  // namespace oddity::asked\n";
}

std::string wrong(std::size_t line, std::size_t column, const std::string& reason, const std::string& all) {
  return "{\"wrong\":{\"line\":" + std::to_string(line) + ",\"column\":" + std::to_string(column) +
         ",\"reason\":" + quoted(reason) + ",\"message\":" + quoted(all) + "}}";
}

}  // namespace

const std::vector<Scene>& scenes() { return all_scenes; }

/// Reads a text of so many bytes; keeps the previous one if this one is wrong. Returns {"wrong": {line,
/// column, reason, message}}, with lines and columns from 1, or 0 if the place is unknown; or {"file": ...}.
ODDITY_EXPORT(take) const char* take(const char* text, std::size_t size) {
  try {
    Own made = own_of(std::string(text, size));
    answer = "{\"file\":" + text_of(*made.file) + "}";
    forget_models();
    all_scenes.clear();
    own = std::move(made);
    if (!own.models.empty()) all_scenes.push_back(scene_of(own));
  } catch (const problem::WrongFile& error) {
    answer = wrong(error.place().line, error.place().column, error.reason(), error.what());
  } catch (const std::exception& error) {
    answer = wrong(0, 0, error.what(), error.what());
  }
  return answer.c_str();
}

/// A model with these values of the parameters as C++, and a function that returns it; or nothing where it
/// cannot be printed.
ODDITY_EXPORT(code) const char* code_of(std::size_t index, const double* values) {
  answer.clear();
  const problem::Model& model = own.models[index];
  if (model.has_events()) return answer.c_str();
  try {
    const std::vector<double> given(values, values + own.file->parameters.size());
    const problem::Model::Code code = model.code(*own.file, model.with(given).partitioned);
    answer = "namespace oddity::problem {\n\n" + problem::comment_of(*own.file, own.file->models[index]) +
             code.text + "\n}  // namespace oddity::problem\n\n" + construction_of(*own.file, code, values);
  } catch (const BadInput&) {
    answer.clear();
  }
  return answer.c_str();
}

/// Judgement of the file's claim at this place: `{says, printed, verdict, expected, why, checks: [{reading,
/// holds, text, where}]}`; or `{wrong: the reason}` if it cannot be judged.
ODDITY_EXPORT(claim) const char* claim_of(std::size_t place) {
  try {
    const Claim claim = own.sheet->judged(place);
    answer = text_of(claim, own.file->claims[place], own.sheet->stated().at(claim.id));
  } catch (const std::exception& error) {
    answer = "{\"wrong\":" + quoted(error.what()) + "}";
  }
  return answer.c_str();
}

}  // namespace oddity::module
