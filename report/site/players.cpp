#include "report/site/players.hpp"

#include <set>

#include "chapters/contents.hpp"
#include "chapters/listing.hpp"
#include "chapters/scene.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/site/example.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity {

namespace {

std::string literal_of(std::string_view text) { return "R\"oddity(" + std::string(text) + ")oddity\""; }

/// The expression of a model, in a number type, with parameters from `values`.
std::string in_numbers(std::span<const Parameter> parameters, std::string_view expression,
                       const std::string& number) {
  std::string letters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (mentions(expression, parameters[i].name))
      letters += "    const auto " + std::string(parameters[i].name) + " = static_cast<" + number +
                 ">(values[" + std::to_string(i) + "]);\n";
  return "[&] {\n" + letters + "    return " + in_number_type(expression, number) + ";\n  }()";
}

/// A listing names a closed form with its own algorithm as "model, algorithm".
std::pair<std::string, std::string> model_and_algorithm(const Quantity& motion, std::string_view listed) {
  for (const Method& m : motion.methods)
    if (m.model + ", " + m.algorithm == listed) return {m.model, m.algorithm};
  return {std::string(listed), ""};
}

std::string function_of(Number number, std::size_t model) {
  return "model_" + std::to_string(number.chapter) + "_" + std::to_string(number.index) + "_" +
         std::to_string(model);
}

/// The folder of a path, with its slash.
std::string folder_of(std::string_view path) { return std::string(path.substr(0, path.rfind('/') + 1)); }

/// The namespace of the scene's models.
std::string namespace_of(const Listing& listing) {
  const std::string_view expression = listing.models.front().second;
  return std::string(expression.substr(0, expression.find("::")));
}

std::set<std::string> headers_of(const Scene& scene) {
  std::set<std::string> headers(scene.listing.headers.begin(), scene.listing.headers.end());
  if (scene.draw) headers.insert(folder_of(scene.listing.headers.front()) + "drawing.hpp");
  return headers;
}

/// The listed models by name, with the expressions that construct them.
std::vector<std::pair<std::string_view, std::string_view>> played_models(const Scene& scene) {
  auto models = scene.listing.models;
  models.insert(models.end(), scene.listing.with_events.begin(), scene.listing.with_events.end());
  return models;
}

/// Functions that make the scene's models.
std::string models_text(const Entry& entry) {
  std::string text;
  const auto models = played_models(*entry.exercise.scene);
  for (std::size_t i = 0; i < models.size(); ++i)
    text += "std::unique_ptr<const Model> " + function_of(entry.number, i) +
            "(std::span<const double> values) {\n  return model(" +
            in_numbers(entry.exercise.parameters, models[i].second, "double") + ", " +
            in_numbers(entry.exercise.parameters, models[i].second, "float") + ");\n}\n\n";
  return text;
}

/// The scene as a value of module::Scene.
std::string scene_text(const Entry& entry) {
  const Scene& scene = *entry.exercise.scene;
  const Quantity moving = motion(scene, Parameters(entry.exercise.parameters), Reference::nothing());
  std::string letters, models;
  for (const Parameter& p : entry.exercise.parameters)
    letters += "{" + literal_of(p.name) + ", " + format_shortest(p.value) + "}, ";
  const auto played = played_models(scene);
  for (std::size_t i = 0; i < played.size(); ++i) {
    const auto [model, algorithm] = model_and_algorithm(moving, played[i].first);
    models += "\n       {" + literal_of(model) + ", " + literal_of(algorithm) + ", " +
              function_of(entry.number, i) + "},";
  }
  const std::string draw =
      scene.draw ? namespace_of(scene.listing) + "::draw<module::Parameters>" : std::string("nullptr");
  return "      {" + literal_of(to_string(entry.number)) + ", " +
         std::to_string(scene.axes.observables.size()) + ",\n       {" + letters + "},\n      {" + models +
         "},\n       " + draw + "},\n";
}

bool has_models(const Entry& entry) {
  return entry.exercise.scene && !entry.exercise.scene->listing.models.empty();
}

std::string file_text(const std::vector<const Entry*>& entries, std::size_t nth, std::size_t files) {
  std::set<std::string> headers;
  std::string models, scenes;
  for (const Entry* entry : entries) {
    headers.merge(headers_of(*entry->exercise.scene));
    models += models_text(*entry);
    scenes += scene_text(*entry);
  }
  std::string text;
  for (const std::string& header : headers) text += "#include \"" + header + "\"\n";
  text += "#include \"report/site/module/scene.hpp\"\n\nnamespace oddity::module {\n\nnamespace {\n\n" +
          models + "}  // namespace\n\nstd::vector<Scene> scenes_" + std::to_string(nth) +
          "() {\n  return {\n" + scenes + "  };\n}\n\n";
  if (nth == 0) {
    std::string declared, added;
    for (std::size_t i = 0; i < files; ++i) {
      declared += "std::vector<Scene> scenes_" + std::to_string(i) + "();\n";
      added += "    for (const Scene& scene : scenes_" + std::to_string(i) + "()) all.push_back(scene);\n";
    }
    text += declared +
            "\nconst std::vector<Scene>& scenes() {\n  static const std::vector<Scene> scenes = [] {\n"
            "    std::vector<Scene> all;\n" +
            added + "    return all;\n  }();\n  return scenes;\n}\n\n";
  }
  return text + "}  // namespace oddity::module\n";
}

}  // namespace

std::vector<std::string> module_source(std::size_t files) {
  std::vector<std::vector<const Entry*>> parts(files);
  std::size_t next = 0;
  for (const Entry& entry : registry())
    if (has_models(entry)) parts[next++ % files].push_back(&entry);
  for (const Entry* entry : {&example(), &lesson_scene()}) parts[next++ % files].push_back(entry);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < files; ++i) texts.push_back(file_text(parts[i], i, files));
  return texts;
}

namespace {

std::filesystem::path own_file() { return module_file().replace_filename("own.js"); }

std::string script_of(const std::filesystem::path& file) {
  if (!has_module()) return "oddity.module(null);\n";
  require_own(file);
  return read_whole(file);
}

}  // namespace

bool has_module() { return std::filesystem::exists(module_file()) && std::filesystem::exists(own_file()); }
std::string module_script() { return script_of(module_file()); }
std::string own_script() { return script_of(own_file()); }

}  // namespace oddity
