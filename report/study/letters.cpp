#include "report/study/letters.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <regex>
#include <sstream>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/quantity_text.hpp"
#include "reference/truth.hpp"
#include "report/study/embedded.hpp"

namespace oddity {

std::string exchanged_letters(std::string_view models, std::span<const Parameter> parameters) {
  const std::string text(models);
  static const std::regex head(R"(struct Given \{)"),
      member(R"(^ *(?:std::array<T, (\d+)>|T) ([A-Za-z_]\w*(?:, \w+)*);)"), word(R"(\w+)");
  std::smatch given;
  if (!std::regex_search(text, given, head)) return "";
  const std::string body = given.suffix().str().substr(0, given.suffix().str().find("\n};"));
  std::string before;
  std::ptrdiff_t last = -1;
  const auto place = [&](const std::string& letter) {
    return std::ranges::find(parameters, letter, &Parameter::name) - parameters.begin();
  };
  std::istringstream lines(body);
  for (std::string line; std::getline(lines, line);) {
    std::smatch declared;
    if (!std::regex_search(line, declared, member)) continue;
    const std::string names = declared[2];
    for (std::sregex_iterator name(names.begin(), names.end(), word), end; name != end; ++name)
      for (int i = 1, count = declared[1].matched ? std::stoi(declared[1]) : 1; i <= count; ++i) {
        const std::string letter = name->str() + (declared[1].matched ? std::to_string(i) : "");
        const auto at = place(letter);
        if (at == std::ranges::ssize(parameters)) continue;
        if (at < last) return before + " before " + letter;
        last = at;
        before = letter;
      }
  }
  return "";
}

std::string exchanged_letters(const Entry& entry) {
  const std::filesystem::path folder = std::filesystem::path(entry.file).parent_path();
  const std::filesystem::path models =
      "chapters" / folder.parent_path().filename() / folder.filename() / "models.hpp";
  for (const EmbeddedFile& header : embedded_headers())
    if (header.path == models.generic_string())
      return exchanged_letters(header.text, entry.exercise.parameters);
  return "";
}

namespace {

/// "20.2" for 20_02_ball.
std::string of_table(const std::string& name) {
  return std::to_string(std::stoi(name.substr(0, 2))) + "." + std::to_string(std::stoi(name.substr(3, 2)));
}

/// Whether two units measure the same by different numbers.
bool other_size(std::string_view unit, std::string_view other) {
  if (!is_unit(unit) || !is_unit(other)) return false;
  try {
    return in_unit("1" + std::string(unit), other) != 1;
  } catch (const BadInput&) {
    return false;
  }
}

/// Another value in the parameter's range.
double another(const Parameter& p) {
  const double step = p.whole ? 1 : p.value == 0 ? 1e-3 : p.value / 64;
  const auto fits = [&](double x) { return p.least <= x && x <= p.most; };
  for (const double x : {p.value + step, p.value - step, p.most, p.least})
    if (fits(x) && x != p.value) return x;
  return p.value;
}

/// All judged values, as text; empty if the parameters are refused.
std::optional<std::string> judged_at(const Exercise& exercise, const Parameters& p, const Reference& truth) {
  try {
    const Findings found = exercise.study(p, truth);
    ExerciseResult result;
    for (const Claim& claim : found.claims) result.claims.push_back({claim, verdict(claim)});
    std::string text = to_json(Results{{result}});
    for (const Quantity& q : found.quantities)
      for (const Method& m : q.methods) {
        for (double x : run(q, m, m.resolution.settings.front()).answer.value)
          text += ' ' + format_shortest(x);
      }
    return text;
  } catch (const BadInput&) {
    return {};
  }
}

/// The scene's motion by every method at its coarsest setting.
std::optional<std::vector<Value>> moved_at(const Exercise& exercise, const Parameters& p) {
  if (!exercise.scene) return std::vector<Value>();
  try {
    std::vector<Value> all;
    const Quantity q = motion(*exercise.scene, p, Reference::nothing());
    for (const Method& m : q.methods) all.push_back(run(q, m, m.resolution.settings.front()).answer.value);
    return all;
  } catch (const BadInput&) {
    return {};
  }
}

bool same(const std::optional<std::vector<Value>>& a, const std::optional<std::vector<Value>>& b) {
  return a && b && std::ranges::equal(*a, *b, [](const Value& x, const Value& y) {
           return std::ranges::equal(x, y, [](double s, double t) { return s == t || (s != s && t != t); });
         });
}

}  // namespace

std::vector<std::string> unused_parameters(const Entry& entry, const Reference& truth) {
  const Exercise& exercise = entry.exercise;
  const Parameters usual(exercise.parameters);
  const auto motion = moved_at(exercise, usual);
  std::optional<std::string> judged, known;
  std::vector<std::string> unused;
  for (const Parameter& p : exercise.parameters) {
    Parameters changed = usual;
    changed.set(p.name, another(p));
    if (!same(moved_at(exercise, changed), motion)) continue;
    if (!judged) judged = judged_at(exercise, usual, Reference::nothing());
    if (judged_at(exercise, changed, Reference::nothing()) != judged) continue;
    if (!known) known = judged_at(exercise, usual, truth);
    if (judged_at(exercise, changed, truth) == known) unused.emplace_back(p.name);
  }
  return unused;
}

std::vector<std::string> other_units(const Entry& entry, const Findings& found) {
  std::vector<std::string> all;
  for (const truth::Entry& generator : truth::registry()) {
    const std::string name(generator.name);
    if (exercise_number(of_table(name)) != entry.number) continue;
    const truth::Truth table = generator.make();
    std::string units;
    for (const truth::Component& c : table.components) units += (units.empty() ? "" : ", ") + c.unit;
    for (const Quantity& q : found.quantities) {
      const std::string& by = q.reference.by;
      if (by.find("table " + name + ".csv") == by.npos &&
          by.find(table.first_route + "; and " + table.second_route) == by.npos)
        continue;
      for (const std::string_view unit : q.units())
        if (std::ranges::any_of(table.components, [&](const auto& c) { return other_size(unit, c.unit); }))
          all.push_back(q.name + " is in " + std::string(unit) + ", its table " + name + " in " + units);
    }
  }
  return all;
}

}  // namespace oddity
