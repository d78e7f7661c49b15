#include <algorithm>
#include <cmath>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/cheapest_models_view.hpp"
#include "report/pages/markdown.hpp"
#include "report/study/candidate.hpp"
#include "report/study/cheapest_models.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

std::string with_unit(const std::string& number, const std::string& unit) {
  return with_powers(number) + (unit.empty() || unit == "1" ? "" : " " + escaped(typeset_unit(unit)));
}

std::string error_of(const Candidate& candidate, const Need& need, const CheapestModels& cheapest_models) {
  if (need.relative) return with_powers(shown_error(candidate.error * need.error)) + " of the motion";
  std::string text;
  for (std::size_t i = 0; i < candidate.errors.size(); ++i)
    text +=
        (text.empty() ? "" : ", ") + with_unit(shown_error(candidate.errors[i]), cheapest_models.units.at(i));
  return text;
}

/// The model's error in float, and whether it is within the need.
std::string in_float(const CheapestModel& row, const CheapestModels& cheapest_models) {
  if (!row.in_float) return "in double only";
  return error_of(*row.in_float, row.need, cheapest_models) +
         (row.in_float->holds() ? ", holds" : ", **" + std::string(name_of(row.in_float->outcome)) + "**");
}

std::vector<std::string> least_row(const CheapestModel& row, const CheapestModels& cheapest_models) {
  if (!row.least) return {escaped(row.says), "*none here*", "", "", "", "", ""};
  return {escaped(row.says),
          escaped(row.least->model),
          escaped(row.least->algorithm),
          with_powers(escaped(shown_setting(*row.least, row.need))),
          error_of(*row.least, row.need, cheapest_models),
          format_significant(row.least->evaluations_per_frame, 3),
          in_float(row, cheapest_models)};
}

/// "up to 0.21", "from 109 on", "between 3 and 4".
std::string interval_text(const Interval& enough, const BreakEven& b) {
  const bool from_start = enough.from == b.looked.from, to_end = enough.to == b.looked.to;
  if (from_start) return "up to " + with_unit(format_significant(enough.to, 3), b.parameter_unit);
  if (to_end) return "from " + with_unit(format_significant(enough.from, 3), b.parameter_unit) + " on";
  return "between " + format_significant(enough.from, 4) + " and " +
         with_unit(format_significant(enough.to, 4), b.parameter_unit);
}

/// Objections to the borders found: errors by the reference that disagree with them.
std::string reservations(const BreakEven& b) {
  constexpr double roundings = 0.02;  // relative; borders are known to one in a thousand
  std::string text;
  const auto disagree = [&](const char* side, double error) {
    text += " The reference disagrees: where the model " + std::string(side) + ", its error is " +
            format_significant(error, 3) + " times the allowed one.";
  };
  long missing = 0;
  for (double error : b.holding) {
    missing += std::isnan(error);
    if (error > 1 + roundings) disagree("should hold", error);
  }
  for (double error : b.failing) {
    missing += std::isnan(error);
    if (error < 1 - roundings) disagree("should fail", error);
  }
  if (b.coarse) text += " An end is known less exactly: no algorithm here solves the models near it.";
  if (missing > 0) text += " The reference takes too long to be made at these ends.";
  return text;
}

std::string break_even_text(const BreakEven& b) {
  std::string where;
  for (std::size_t i = 0; i < b.enough.size(); ++i)
    where += (i == 0 ? " " : i + 1 == b.enough.size() ? " and " : ", ") + interval_text(b.enough[i], b);
  return "- *" + escaped(b.model) + "* is enough for " + code(b.parameter) + where + " (of " +
         with_powers(format_significant(b.looked.from, 3)) + " to " +
         with_powers(format_significant(b.looked.to, 3)) + ")." +
         (b.why.empty() ? "" : " Outside it gives no motion (" + escaped(b.why) + ").") + reservations(b) +
         "\n";
}

std::string never_text(const std::vector<std::string>& models) {
  std::string names;
  for (const std::string& model : models) names += (names.empty() ? "*" : ", *") + escaped(model) + "*";
  return models.empty() ? "" : "- Enough nowhere searched: " + names + ".\n";
}

std::string section(const ExerciseResult& e) {
  const CheapestModels& cheapest_models = *e.cheapest_models;
  std::vector<std::vector<std::string>> rows;
  for (const CheapestModel& row : cheapest_models.least) rows.push_back(least_row(row, cheapest_models));
  std::string text =
      "## " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" +
      table({"for", "model", "algorithm", "setting", "error", "evaluations per frame", "in float"}, rows,
            "5");
  for (const BreakEven& b : cheapest_models.break_evens) text += break_even_text(b);
  return text + never_text(cheapest_models.never) + "\n";
}

}  // namespace

std::string cheapest_models_page(const Results& results) {
  std::string text =
      "# The cheapest sufficient model\n\n"
      "For each scene the simplest of its models that holds at every frame over 10 s at 60 "
      "frames per second. The horizon is 10 years if the scene's time is in years. There is a row for a "
      "game's tolerance, one centimetre and one degree, and one for ten digits. Each has the model's "
      "algorithm with the least counted work, and its error in float at the same setting. Below are the "
      "values of a parameter for which a model, solved exactly, is enough for the game, with the searched "
      "range in brackets. Each border is known to one in a thousand. `oddity choose` adds times on your "
      "machine, your starts and a margin.\n\n";
  for (const ExerciseResult& e : results.exercises)
    if (e.cheapest_models) text += section(e);
  return text + "[All exercises](README.md)\n";
}

}  // namespace oddity
