#include "reference/text.hpp"
#include "report/ledger.hpp"
#include "report/markdown.hpp"
#include "report/markup.hpp"
#include "report/text_view.hpp"
#include "report/tried.hpp"

namespace oddity {

namespace {

std::string with_unit(const std::string& number, const std::string& unit) {
  return with_powers(number) + (unit.empty() || unit == "1"           ? ""
                                : unit.find(',') == std::string::npos ? " " + escaped(unit)
                                                                      : " (" + escaped(unit) + ")");
}

std::string error_of(const LeastModel& row, const Ledger& ledger) {
  const std::string error = shown_error(row.least->error * row.need.error);
  return row.need.relative ? with_powers(error) + " of the motion" : with_unit(error, ledger.unit);
}

std::vector<std::string> least_row(const LeastModel& row, const Ledger& ledger) {
  if (!row.least) return {escaped(row.says), "*none here*", "", "", "", ""};
  return {escaped(row.says),
          escaped(row.least->model),
          escaped(row.least->algorithm),
          with_powers(escaped(shown_setting(*row.least, row.need))),
          error_of(row, ledger),
          rounded(row.least->evaluations_a_frame, 3)};
}

std::string break_even_text(const BreakEven& b, const Ledger& ledger) {
  return "- *" + escaped(b.model) + "* is enough " + (b.holds < b.fails ? "up to" : "from") + " " +
         code(b.parameter) + " = " + with_unit(rounded(b.holds, 3), b.parameter_unit) +
         (b.holds < b.fails ? "" : " on") + ", where it errs by " +
         with_unit(shown_error(b.error_holds), ledger.unit) + ".\n";
}

std::string never_text(const std::vector<std::string>& models) {
  std::string names;
  for (const std::string& model : models) names += (names.empty() ? "*" : ", *") + escaped(model) + "*";
  return models.empty() ? "" : "- Not enough wherever it was looked: " + names + ".\n";
}

std::string section(const ExerciseResult& e) {
  const Ledger& ledger = *e.ledger;
  std::vector<std::vector<std::string>> rows;
  for (const LeastModel& row : ledger.least) rows.push_back(least_row(row, ledger));
  std::string text =
      "## " + to_string(e.number) + " " + escaped(e.title, false) + "\n\n" +
      table({"for", "least model", "algorithm", "setting", "error", "evaluations a frame"}, rows, "5");
  for (const BreakEven& b : ledger.break_evens) text += break_even_text(b, ledger);
  return text + never_text(ledger.never) + "\n";
}

}  // namespace

std::string ledger_page(const Results& results) {
  std::string text =
      "# The least model\n\nFor each scene the first model of its ladder, from the least on, that holds over "
      "10 s at 60 frames a second (of a year, where the scene's time is in years): to one centimetre or one "
      "degree, which is what a game asks, and to ten digits. Of the model's algorithms the one with the "
      "least "
      "counted work is given; what is cheapest in time on a machine, and for starts beside this one, `oddity "
      "choose` says. A break-even is a value at which a model stops or begins to be enough for the game: of "
      "the parameter that makes the scene hard, or, where that has none, of one that differs from start to "
      "start, from a sixteenth of its value to four times it. It is looked for with the best method in place "
      "of the truth, to one in a thousand, and both of its sides are judged by the reference.\n\n";
  for (const ExerciseResult& e : results.exercises)
    if (e.ledger) text += section(e);
  return text + "[All chapters](README.md)\n";
}

}  // namespace oddity
