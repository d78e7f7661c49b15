#include "report/study/limit_records.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <regex>
#include <string_view>

#include "reference/csv.hpp"
#include "reference/text.hpp"

namespace oddity {

char letter_of(Outcome outcome) {
  constexpr std::string_view letters_in_order = "oidXNSERCG";
  return letters_in_order[static_cast<std::size_t>(std::ranges::find(outcomes_of_a_map, outcome) -
                                                   outcomes_of_a_map.begin())];
}

std::optional<Outcome> outcome_of(char letter) {
  const auto found = std::ranges::find(outcomes_of_a_map, letter, letter_of);
  return found == outcomes_of_a_map.end() ? std::nullopt : std::optional(*found);
}

std::string letters(const MapRow& row) {
  std::string text;
  for (Outcome outcome : row.outcomes) text += letter_of(outcome);
  return text;
}

std::string fragile_cells(const MapRow& row) {
  std::string text;
  for (bool fragile : row.fragile) text += fragile ? '*' : '.';
  return row.fragile.end() == std::ranges::find(row.fragile, true) ? "" : text;
}

std::string shown_tongues(const Limit& l) {
  std::string text;
  for (const ode::Tongue& t : l.tongues) {
    if (!text.empty()) text += ", ";
    const std::string from = t.from == 0 ? "" : format_significant(t.from, 3);
    if (std::isinf(t.to))
      text += t.from == 0 ? "every step" : "from " + from;
    else
      text += t.from == 0 ? "to " + format_significant(t.to, 3) : from + " to " + format_significant(t.to, 3);
  }
  return text.empty() ? "no step" : text;
}

std::optional<std::vector<ode::Tongue>> tongues_shown_as(std::string_view text) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<ode::Tongue> all;
  if (text == "no step") return all;
  if (text == "every step") return std::vector<ode::Tongue>{{0, infinity}};
  static const std::regex one(R"((?:, )?(?:from (\S+)|to ([^\s,]+)|([0-9.e+-]+) to ([^\s,]+)))");
  for (std::cmatch found; !text.empty(); text.remove_prefix(static_cast<std::size_t>(found.length()))) {
    const auto how = std::regex_constants::match_continuous;
    if (!std::regex_search(text.data(), text.data() + text.size(), found, one, how)) return {};
    const auto number = [&](int part) { return std::strtod(found.str(part).c_str(), nullptr); };
    if (found[1].matched) all.push_back({number(1), infinity});
    if (found[2].matched) all.push_back({0, number(2)});
    if (found[3].matched) all.push_back({number(3), number(4)});
  }
  return all;
}

std::optional<Between> soft_shown_as(std::string_view text) {
  const std::string ends(text);
  Between soft{};
  const bool is_read = std::sscanf(ends.c_str(), "%lf to %lf", &soft.least, &soft.most) == 2;
  return is_read && shown_soft(soft) == text ? std::optional(soft) : std::nullopt;
}

std::string beyond(const Limit& l) { return l.broken ? std::string(name_of(l.broken->outcome)) : "stable"; }

std::string shown_soft(const Between& soft) {
  return format_significant(soft.least, 3) + " to " + format_significant(soft.most, 3);
}

namespace {

std::string step_cell(double step) { return format_significant(step, 3); }

}  // namespace

std::string limit_row(const ExerciseResult& e, const Limit& l) {
  return to_string(e.number) + "," + csv_cell(l.model) + "," + csv_cell(l.algorithm) + "," +
         step_cell(l.step()) + "," + step_cell(l.theory()) + "," + csv_cell(shown_tongues(l)) + "," +
         (l.goes_on || std::isinf(l.step()) ? "" : step_cell(l.watched)) + "," +
         (l.soft ? shown_soft(*l.soft) : "") + "," + (l.at ? format_significant(l.at->error, 2) : "") + "," +
         (l.within ? step_cell(l.within->setting) : "") + "," + beyond(l) + "," + csv_cell(l.why) + "\n";
}

std::string limit_rows(const Results& results) {
  std::string rows;
  for (const ExerciseResult& e : results.exercises)
    if (e.stability)
      for (const Limit& l : e.stability->limits) rows += limit_row(e, l);
  return rows;
}

std::string map_row(const ExerciseResult& e, const MapRow& row) {
  return to_string(e.number) + "," + csv_cell(row.model) + "," + csv_cell(row.algorithm) + "," +
         format_shortest(row.value) + "," + letters(row) + "," + fragile_cells(row) + "\n";
}

std::string map_rows(const Results& results) {
  std::string rows;
  for (const ExerciseResult& e : results.exercises)
    if (e.stability)
      for (const MapRow& row : e.stability->map) rows += map_row(e, row);
  return rows;
}

}  // namespace oddity
