// Writes the recorders of the scenes' models, one file for each part: every model of a listing, made of
// numbers that record.

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "chapters/contents.hpp"
#include "chapters/listing.hpp"
#include "chapters/scene.hpp"

using namespace oddity;

namespace {

std::string name_of(const Entry& entry, std::size_t model) {
  return "recorded_" + std::to_string(entry.number.chapter) + "_" + std::to_string(entry.number.index) + "_" +
         std::to_string(model);
}

bool is_recorded(const Entry& entry) {
  return entry.exercise.scene && !entry.exercise.scene->listing.models.empty();
}

/// The models of a listing, then those that step themselves.
std::vector<std::pair<std::string_view, std::string_view>> models_of(const Entry& entry) {
  auto models = entry.exercise.scene->listing.models;
  const auto& more = entry.exercise.scene->listing.with_own_steps;
  models.insert(models.end(), more.begin(), more.end());
  return models;
}

std::string generator_of(const Entry& entry, std::size_t model) {
  const std::string_view expression = models_of(entry)[model].second;
  std::string text =
      "RecordedModel " + name_of(entry, model) +
      "(const ToRecord& asked) {\n  return recorded([](std::span<const formula::Recorded> values) {\n";
  for (std::size_t i = 0; i < entry.exercise.parameters.size(); ++i)
    if (const std::string name(entry.exercise.parameters[i].name); mentions(expression, name))
      text += "    const formula::Recorded& " + name + " = values[" + std::to_string(i) + "];\n";
  return text + "    return " + in_number_type(expression, "formula::Recorded") + ";\n  }, asked);\n}\n";
}

/// Entries with a listing, of the tree or of folders outside it.
std::vector<const Entry*> recorded_entries(bool outside) {
  std::vector<const Entry*> entries;
  for (const Entry& entry : registry())
    if (is_recorded(entry) && entry.file.starts_with('/') == outside) entries.push_back(&entry);
  return entries;
}

std::string text_of(const std::vector<const Entry*>& entries, std::size_t part, std::size_t parts) {
  std::set<std::string_view> headers;
  std::string generators;
  for (std::size_t next = part; next < entries.size(); next += parts) {
    const Listing& listing = entries[next]->exercise.scene->listing;
    headers.insert(listing.headers.begin(), listing.headers.end());
    for (std::size_t i = 0; i < models_of(*entries[next]).size(); ++i)
      generators += generator_of(*entries[next], i);
  }
  std::string text = "#include \"report/study/recorded_model.hpp\"\n";
  for (const std::string_view header : headers) text += "#include \"" + std::string(header) + "\"\n";
  return text + "\nnamespace oddity {\n\n" + generators + "\n}  // namespace oddity\n";
}

std::string register_text() {
  std::string declared, entries;
  for (const Entry& entry : registry()) {
    if (!is_recorded(entry)) continue;
    const auto models = models_of(entry);
    for (std::size_t i = 0; i < models.size(); ++i) {
      declared += "RecordedModel " + name_of(entry, i) + "(const ToRecord&);\n";
      entries += "      {{" + std::to_string(entry.number.chapter) + ", " +
                 std::to_string(entry.number.index) + "}, R\"oddity(" + std::string(models[i].first) +
                 ")oddity\", " + name_of(entry, i) + "},\n";
    }
  }
  return "#include \"report/study/recorded_model.hpp\"\n\nnamespace oddity {\n\n" + declared +
         "\nstd::span<const Recorder> recorders() {\n  static const Recorder all[] = {\n" + entries +
         "  };\n  return all;\n}\n\n}  // namespace oddity\n";
}

/// Leaves a file alone that has this text.
void write(const std::string& path, const std::string& text) {
  std::stringstream before;
  before << std::ifstream(path).rdbuf();
  if (before.str() != text) std::ofstream(path) << text;
}

}  // namespace

/// FOLDER PARTS: recorders.cpp, recorders_1.cpp and so on, and recorders_own.cpp.
int main(int count, char** arguments) {
  if (count != 3) return 2;
  const std::string folder = arguments[1];
  const std::size_t parts = std::stoul(arguments[2]);
  write(folder + "/recorders.cpp", register_text());
  for (std::size_t part = 0; part < parts; ++part)
    write(folder + "/recorders_" + std::to_string(part + 1) + ".cpp",
          text_of(recorded_entries(false), part, parts));
  write(folder + "/recorders_own.cpp", text_of(recorded_entries(true), 0, 1));
}
