#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reference/text.hpp"
#include "report/markup.hpp"
#include "report/stability.hpp"
#include "report/text_view.hpp"

namespace oddity {

namespace {

constexpr std::string_view definition =
    "A run is stable when it reaches its end and stays finite, its error is at most ten times the size of "
    "the "
    "true motion, and a conserved quantity has changed by no more than itself.";

std::string shown_theory(double theory) { return std::isinf(theory) ? "every step" : rounded(theory, 3); }

std::string shown_agreement(const Limit& limit) {
  const double ratio = agreement(limit);
  return ratio == 1 ? "within" : std::isfinite(ratio) && ratio > 0 ? rounded(ratio, 3) : "-";
}

std::string in_unit(const std::string& value, const std::string& unit) {
  return unit.empty() || unit == "1" ? value : value + " " + unit;
}

std::string quantity_line(const ExerciseResult& e) {
  const Stability& s = *e.stability;
  return code(s.quantity) + " over " + rounded(s.horizon, 4) + " " + escaped(s.time_unit) + "; close is " +
         escaped(in_unit(rounded(s.close, 3), s.unit));
}

std::vector<std::string> header(const Stability& s) {
  const std::string unit = " [" + s.time_unit + "]";
  return {"model",         "algorithm",       "stable to" + unit, "breaks at" + unit,
          "theory" + unit, "measured/theory", "how it breaks",    "cure there"};
}

std::vector<std::string> limit_cells(const Stability& s, const Limit& l) {
  return {l.model,
          l.algorithm,
          shown_step(l),
          l.broken ? rounded(l.broken->setting, 3) : "-",
          shown_theory(l.theory),
          shown_agreement(l),
          how_it_breaks(l, s.unit),
          shown_cure(l, s.unit)};
}

/// The limits in columns, each model named above its own.
std::string limits_text(const Stability& s) {
  const auto names = header(s);
  std::vector<std::vector<std::string>> rows{{names.begin() + 1, names.end()}};
  const std::string* model = nullptr;
  for (const Limit& l : s.limits) {
    if (!model || *model != l.model) rows.push_back({l.model + ":"});
    model = &l.model;
    const auto cells = limit_cells(s, l);
    rows.emplace_back(cells.begin() + 1, cells.end());
    rows.back().front().insert(0, "  ");
  }
  return aligned(rows);
}

/// Reasons why theory and measurement differ, the same ones together.
std::vector<std::pair<std::string, std::string>> reasons(const Stability& s) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Limit& l : s.limits) {
    if (l.why.empty()) continue;
    const std::string name = l.model + ", " + l.algorithm;
    const auto same = std::ranges::find(all, l.why, &std::pair<std::string, std::string>::first);
    if (same == all.end())
      all.emplace_back(l.why, name);
    else
      same->second += "; " + name;
  }
  return all;
}

/// The letters with a bar where theory's limit is: "XXd|ddiioooo".
std::string letters_and_theory(const MapRow& row, const std::vector<double>& steps) {
  std::string text = letters(row);
  if (std::isinf(row.theory)) return "|" + text;
  const auto above = std::ranges::count_if(steps, [&](double step) { return step > row.theory; });
  return text.insert(static_cast<std::size_t>(above), "|");
}

std::string map_text(const Stability& s) {
  std::string text = "\nmap: each letter a step, " + rounded(s.steps.front(), 3) + " " + s.time_unit +
                     " and its halves to " + rounded(s.steps.back(), 3) + " " + s.time_unit +
                     "; the bar is theory's limit\n ";
  for (Outcome outcome : outcomes_of_a_map)
    text += " " + std::string(1, letter_of(outcome)) + " " + std::string(name_of(outcome));
  std::vector<std::vector<std::string>> rows{
      {"model", "algorithm", s.parameter, "steps from coarse to fine"}};
  for (const MapRow& row : s.map) {
    const bool first =
        &row == s.map.data() || (&row)[-1].model != row.model || (&row)[-1].algorithm != row.algorithm;
    rows.push_back({first ? row.model : "", first ? row.algorithm : "",
                    in_unit(rounded(row.value, 4), s.parameter_unit), letters_and_theory(row, s.steps)});
  }
  return text + "\n" + aligned(rows);
}

/// A cell of a CSV file, quoted where it has to be.
std::string cell(const std::string& text) {
  return text.find(',') == std::string::npos ? text : "\"" + text + "\"";
}

std::string step_cell(double step) { return rounded(step, 3); }

std::string stability_of_scene(const ExerciseResult& e) {
  const Stability& s = *e.stability;
  std::string text =
      "## " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" + quantity_line(e) + ".\n\n";
  std::vector<std::vector<std::string>> rows;
  for (const Limit& l : s.limits) {
    std::vector<std::string> cells;
    for (const std::string& text_of_cell : limit_cells(s, l))
      cells.push_back(with_powers(escaped(text_of_cell)));
    rows.push_back(std::move(cells));
  }
  std::vector<std::string> columns;
  for (const std::string& name : header(s)) columns.push_back(escaped(name));
  text += table(columns, rows, "2345");
  if (const auto why = reasons(s); !why.empty()) {
    text += "Where theory and measurement differ by more than a factor of two:\n\n";
    for (const auto& [reason, names] : why)
      text += "- " + escaped(names, false) + ": " + escaped(reason, false) + ".\n";
    text += "\n";
  }
  for (const QuantityResult& q : e.quantities)
    if (q.name == s.quantity)
      for (const BreakdownResult& b : q.breakdowns) text += prose(b.says) + "\n\n";
  return text + "![outcome over step and " + escaped(s.parameter, false) + "](" + map_file(e) + ")\n\n";
}

}  // namespace

char letter_of(Outcome outcome) {
  constexpr std::string_view letters_in_order = "oidXNSER";
  return letters_in_order[static_cast<std::size_t>(std::ranges::find(outcomes_of_a_map, outcome) -
                                                   outcomes_of_a_map.begin())];
}

std::string letters(const MapRow& row) {
  std::string text;
  for (Outcome outcome : row.outcomes) text += letter_of(outcome);
  return text;
}

std::string shown_step(const Limit& l) {
  if (!l.stable) return "none above " + rounded(l.broken->setting, 3);
  return (l.broken ? "" : "at least ") + rounded(l.stable->setting, 3);
}

std::string beyond(const Limit& l) { return l.broken ? std::string(name_of(l.broken->outcome)) : "stable"; }

std::string how_it_breaks(const Limit& l, const std::string& unit) {
  if (!l.broken) return "";
  const TimedTrial& t = *l.broken;
  if (!t.message.empty()) return beyond(l) + ": " + t.message;
  if (t.outcome == Outcome::drifted)
    return "drifted: a conserved quantity changed by " + rounded(t.drift, 3) + " times its size; error " +
           in_unit(shown_error(t.error), unit);
  return beyond(l) + ": error " + in_unit(shown_error(t.error), unit);
}

std::string shown_cure(const Limit& l, const std::string& unit) {
  if (!l.cure) return l.broken ? "none found" : "";
  const TimedTrial& t = *l.cure;
  return (t.model == l.model ? "" : t.model + ", ") + t.algorithm +
         (t.setting == l.broken->setting ? "" : ", " + shown_knob(t)) + ": error " +
         in_unit(shown_error(t.error), unit) + ", " + std::to_string(t.evaluations) + " evaluations";
}

double agreement(const Limit& l) {
  const double low = l.stable ? l.stable->setting : 0;
  if (l.theory < low) return low / l.theory;
  if (l.broken && l.theory > l.broken->setting) return l.broken->setting / l.theory;
  return 1;
}

std::string stability_text(const ExerciseResult& e) {
  const Stability& s = *e.stability;
  std::string text = "Exercise " + to_string(e.number) + ": " + e.title + "\n" + s.quantity + " over " +
                     rounded(s.horizon, 4) + " " + s.time_unit + "; close is " +
                     in_unit(rounded(s.close, 3), s.unit) + "\n\n";
  text += limits_text(s);
  for (const auto& [reason, names] : reasons(s)) text += "\n  " + names + ": " + reason + "\n";
  return text + map_text(s);
}

std::string limit_row(const ExerciseResult& e, const Limit& l) {
  return to_string(e.number) + "," + cell(l.model) + "," + cell(l.algorithm) + "," + step_cell(l.step()) +
         "," + step_cell(l.theory) + "," + beyond(l) + "," + cell(l.why) + "\n";
}

std::string limit_rows(const Results& results) {
  std::string rows;
  for (const ExerciseResult& e : results.exercises)
    if (e.stability)
      for (const Limit& l : e.stability->limits) rows += limit_row(e, l);
  return rows;
}

std::string map_row(const ExerciseResult& e, const MapRow& row) {
  return to_string(e.number) + "," + cell(row.model) + "," + cell(row.algorithm) + "," + shortest(row.value) +
         "," + letters(row) + "\n";
}

std::string map_rows(const Results& results) {
  std::string rows;
  for (const ExerciseResult& e : results.exercises)
    if (e.stability)
      for (const MapRow& row : e.stability->map) rows += map_row(e, row);
  return rows;
}

std::string stability_page(const Results& results) {
  std::string text =
      "# Where methods break\n\nThe largest stable step of every method of fixed step, by bisection, "
      "beside the limit of linear theory. " +
      std::string(definition) +
      " Steps divide the interval between two looks at the motion evenly, so a limit is known to lie "
      "between the two steps given, 1 % apart or one step more an interval. Theory is the largest "
      "step up to which disturbances, with the Jacobian frozen along the motion, grow less than "
      "tenfold beyond what they do in truth. *within*: theory's limit lies between the two steps. The "
      "cure is the cheapest method that is close enough at the step that breaks this one; where there "
      "is none, the cheapest with step control. The maps show how each method ends over the step and "
      "over the parameter that makes the scene hard.\n\n";
  for (const ExerciseResult& e : results.exercises)
    if (e.stability) text += stability_of_scene(e);
  return text + "[All chapters](README.md)\n";
}

std::string map_file(const ExerciseResult& e) { return "charts/" + to_string(e.number) + "_stability.svg"; }

}  // namespace oddity
