#include "report/study/earlier_results.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/table.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

bool is_declared(const ParameterValue& a, const Parameter& b) {
  return a.name == b.name && a.value == b.value && a.unit == b.unit && a.says == b.says;
}

/// Whether the motion can be drawn but has no trajectory.
bool lacks_trajectory(const QuantityResult& q) {
  return !q.trajectory && std::ranges::any_of(q.methods, [](const MethodResult& m) {
    return m.trials.back().outcome == Outcome::ok;
  });
}

}  // namespace

std::string undeclared(const ExerciseResult& e) {
  const auto entry = std::ranges::find(registry(), e.number, &Entry::number);
  if (entry == registry().end()) return "which this program does not have";
  const Exercise& declared = entry->exercise;
  if (e.title != declared.title || e.asks != declared.asks || e.scene != declared.scene.has_value())
    return "whose title or question is another";
  if (!std::ranges::equal(e.parameters, declared.parameters, is_declared))
    return "whose parameters are not the suite's";
  if (!e.scene || !e.failure.empty()) return "";
  const Parameters parameters(declared.parameters);
  const std::string name =
      declared.scene->motion(parameters, {declared.scene->horizon}, Reference::nothing()).name;
  const auto motion = std::ranges::find(e.quantities, name, &QuantityResult::name);
  if (motion == e.quantities.end()) return "whose motion is missing";
  return lacks_trajectory(*motion) ? "whose trajectory is missing" : "";
}

std::string checksum_of_program() {
  return checksum(read_whole("/proc/self/exe", std::numeric_limits<std::size_t>::max()));
}

std::string made_by(const fs::path& reference_folder) {
  return "program " + checksum_of_program() + ", tables " + checksum_of_tables(reference_folder);
}

Results earlier_results(const fs::path& file, const std::string& made_by) {
  Results results = read_results(file);
  if (results.made_by != made_by)
    throw BadInput(file.string() + ": made by (" + results.made_by + "), and here is (" + made_by +
                   "): results are judged by the program and the tables that made them");
  for (const ExerciseResult& e : results.exercises)
    if (const std::string what = undeclared(e); !what.empty())
      throw BadInput(file.string() + ": it has exercise " + to_string(e.number) + ", " + what);
  return results;
}

Results merged_results(const std::vector<fs::path>& files, const std::vector<Number>& exercises,
                       const std::string& made_by) {
  std::map<Number, std::pair<ExerciseResult, fs::path>> parts;
  for (const fs::path& file : files)
    for (ExerciseResult& e : earlier_results(file, made_by).exercises)
      if (const auto [before, fresh] = parts.try_emplace(e.number, std::move(e), file); !fresh)
        throw BadInput("exercise " + to_string(before->first) + " is there twice: in " +
                       before->second.second.string() + " and in " + file.string());
  Results results{{}, not_a_number, made_by};
  for (const Number& number : exercises) {
    const auto part = parts.find(number);
    if (part == parts.end()) throw BadInput("exercise " + to_string(number) + " is in none of the files");
    results.exercises.push_back(std::move(part->second.first));
  }
  return results;
}

}  // namespace oddity
