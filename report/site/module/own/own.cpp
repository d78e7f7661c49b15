// Reads a problem's file typed into the page: reports its errors, or makes its models into the scene that the
// module runs.

#include <algorithm>
#include <cmath>
#include <exception>

#include "problem/code.hpp"
#include "problem/file.hpp"
#include "problem/model.hpp"
#include "reference/quantity_text.hpp"
#include "reference/text.hpp"
#include "report/site/module/json.hpp"
#include "report/site/module/own/played.hpp"

namespace oddity::module {

namespace {

using problem::File, problem::ModelText, problem::ObservableText, problem::ParameterText;

/// The last valid text, and its models.
struct Own {
  std::unique_ptr<const File> file;
  std::vector<problem::Model> models;
};

Own own;
std::vector<Scene> all_scenes;
std::string answer;

Own own_of(const std::string& text) {
  Own made{problem::read("this file", text), {}};
  problem::require_parameters(*made.file);
  for (const ModelText& model : made.file->models) {
    made.models.emplace_back(*made.file, model);
    if (!made.models.back().is_closed()) problem::require_start(*made.file, model, made.models.back());
  }
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

/// A model as C++; or nothing where it cannot be printed.
ODDITY_EXPORT(code) const char* code_of(std::size_t index) {
  answer.clear();
  const problem::Model& model = own.models[index];
  std::vector<double> values;
  for (const ParameterText& p : own.file->parameters) values.push_back(p.value);
  try {
    if (!model.has_events())
      answer = problem::comment_of(*own.file, own.file->models[index]) +
               model.code(*own.file, model.with(values).partitioned).text;
  } catch (const BadInput&) {
    answer.clear();
  }
  return answer.c_str();
}

}  // namespace oddity::module
