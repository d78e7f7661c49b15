#include "report/site/evidence_pages.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "reference/text.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/trust.hpp"
#include "report/site/page.hpp"
#include "report/study/settings.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

using html::element;

std::string title(const std::string& name, const std::string& asks) {
  return element("header", " class=\"title\"",
                 "\n" + element("h1", "", name) + "\n" + element("p", " class=\"asks\"", asks)) +
         "\n";
}

std::string page_link(const ExerciseResult& e, const std::string& section) {
  return html::link(to_string(e.number) + ".html#" + section, to_string(e.number) + " " + in_xml(e.title));
}

// ---- trust ------------------------------------------------------------------------------------------------

/// Explanations of the table's terms.
const std::map<std::string, std::string>& meanings() {
  static const std::map<std::string, std::string> all{
      {"judged",
       "The solutions were read line by line. Each assertion has its claims here, or a reason why none "
       "judges it."},
      {"proved",
       "A computer-checked proof: the proof assistant Coq has followed each step, for all values that the "
       "statement allows."},
      {"provable", "A proof is possible; nobody has written it yet."},
      {"computed", "Two independent computations agree at random samples, and changed formulas do not."},
      {"unclassed", "Nobody has decided yet whether it can be proved."},
      {"wording", "The claim is about words; it was read."},
      {"enclosed", "An interval that is computed with all its roundings holds the value."},
      {"agreed", "No such interval is known: two methods that share nothing agree in 60 digits."},
      {"as typeset", "The formula on the page is read and computed; it is not a copy of the code."},
      {"witnessed", "Another program, with separate formulas, finds the same fault."},
      {"killed", "Mutants: the sources were changed in one place at a time, and the tests noticed."},
      {"fuzzed", "Random and broken input was read without a crash."},
      {"survived", "Runs were killed and disks filled; no file was left half written."}};
  return all;
}

std::string text_of(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return in_xml(*text);
  if (const auto* count = std::get_if<long>(&cell)) return std::to_string(*count);
  return format_shortest(std::get<double>(cell));
}

std::string trust_rows(const Results& results, const Trust& trust) {
  html::Table table{"How the verdicts are checked",
                    {"what", "how many", "of", "subject", "means", "rests on"}};
  std::string part;
  for (const auto& row : trust_table(results, trust).rows) {
    if (std::get<std::string>(row[0]) == part) continue;  // shares of a part that has its own row
    part = std::get<std::string>(row[0]);
    const auto found = meanings().find(part);
    table.rows.push_back(html::row({in_xml(part), text_of(row[2]), text_of(row[3]),
                                    text_of(row[1]) + (text_of(row[4]).empty() ? "" : ": " + text_of(row[4])),
                                    found == meanings().end() ? "" : found->second, text_of(row[7])},
                                   "12"));
  }
  return html::table(table);
}

// ---- stability --------------------------------------------------------------------------------------------

/// The algorithms that most scenes have, in the order of the first scene that has them all.
std::vector<std::string> common_algorithms(const Results& results) {
  std::map<std::string, int> scenes;
  std::vector<std::string> order;
  for (const ExerciseResult& e : results.exercises)
    if (e.stability)
      for (const Limit& l : e.stability->limits)
        if (scenes[l.algorithm]++ == 0) order.push_back(l.algorithm);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](const std::string& name) { return scenes[name]; });
  if (order.size() > 6) order.resize(6);
  return order;
}

std::string limit_cell(const Stability& s, const std::string& model, const std::string& algorithm) {
  const auto found = std::ranges::find_if(
      s.limits, [&](const Limit& l) { return l.model == model && l.algorithm == algorithm; });
  if (found == s.limits.end()) return "";
  return in_xml(shown_step(*found)) + " <small>" +
         (found->within ? "enough to " + with_powers(format_significant(found->within->setting, 3))
                        : "never enough") +
         "</small>";
}

std::string amount(double size, const std::string& unit) {
  return with_powers(format_significant(size, 3)) + (unit.empty() || unit == "1" ? "" : " " + in_xml(unit));
}

std::string stability_rows(const Results& results) {
  const std::vector<std::string> algorithms = common_algorithms(results);
  html::Table table{"The longest stable steps", {"scene", "model", "steps in", "needed"}};
  for (const std::string& name : algorithms) table.head.push_back(in_xml(name));
  for (const ExerciseResult& e : results.exercises) {
    if (!e.stability) continue;
    std::vector<std::string> models;
    for (const Limit& l : e.stability->limits)
      if (std::ranges::find(models, l.model) == models.end()) models.push_back(l.model);
    for (const std::string& model : models) {
      std::vector<std::string> cells{page_link(e, "stability"), html::text(model),
                                     in_xml(e.stability->time_unit),
                                     amount(e.stability->close, e.stability->unit)};
      for (const std::string& name : algorithms) cells.push_back(limit_cell(*e.stability, model, name));
      table.rows.push_back(html::row(cells));
    }
  }
  return html::table(table);
}

// ---- engines ----------------------------------------------------------------------------------------------

std::string times_the_need(double error) {
  return std::isfinite(error) ? with_powers(format_significant(error, 2)) : "no motion";
}

std::string engine_rows(const Results& results, const EngineContest& contest) {
  html::Table table{contest.title, {"engine", "settings", "error in needs", "steps a second", "enough from"}};
  for (const EngineSeries& series : contest.series) {
    if (series.trials.empty()) {
      table.rows.push_back(html::row({in_xml(series.engine + " " + series.version), in_xml(series.variant),
                                      "cannot: " + html::text(series.cannot), "", ""}));
      continue;
    }
    const EngineTrial* enough = series.first_enough();
    table.rows.push_back(html::row(
        {in_xml(series.engine + " " + series.version), in_xml(series.variant),
         times_the_need(series.trials.front().in_needs),
         format_shortest(series.trials.front().steps_per_frame * contest.frames_per_second),
         enough ? format_shortest(enough->steps_per_frame * contest.frames_per_second) + " Hz" : "never"},
        "234"));
  }
  std::string needed;
  for (std::size_t i = 0; i < contest.needs.size(); ++i)
    needed += (i == 0 ? "" : ", ") + amount(contest.needs[i], contest.units[i]);
  const auto scene = std::ranges::find_if(
      results.exercises, [&](const ExerciseResult& e) { return to_string(e.number) == contest.scene; });
  return "<section>\n" +
         element("h2", "",
                 scene == results.exercises.end() ? in_xml(contest.title) : page_link(*scene, "recipe")) +
         "\n" + element("p", "", "Needed: " + needed + ".") +
         (contest.differs.empty() ? "" : element("p", "", html::text(contest.differs))) + html::table(table) +
         "</section>\n";
}

}  // namespace

std::string trust_html(const Results& results, const Trust& trust) {
  return html::whole(
      {"Trust - oddity",
       title("How the verdicts are checked",
             "How much of it is proved, computed twice, changed on purpose and attacked. <code>" +
                 program_as_typed() + " trust --csv</code> has all figures.") +
           "<section>\n" + trust_rows(results, trust) + "</section>\n",
       {}});
}

std::string stability_html(const Results& results) {
  return html::whole(
      {"Stability - oddity",
       title(
           "Up to which step methods are stable",
           "Below its limit a method lets no small disturbance grow. Its motion may be far from the truth there: "
           "<em>enough</em> is the largest step that keeps the error within the needed one. Each scene's own page has "
           "theory, maps and cures.") +
           "<section>\n" + stability_rows(results) + "</section>\n",
       {}});
}

std::string engines_html(const Results& results, std::span<const EngineContest> contests) {
  std::string sections;
  for (const EngineContest& contest : contests) sections += engine_rows(results, contest);
  if (contests.empty())
    sections = "<section>" +
               element("p", "",
                       "No engine has run for this copy of the site: <code>" + program_as_typed() +
                           " engines</code> builds them and lets them run.") +
               "</section>\n";
  return html::whole(
      {"Engines - oddity",
       title("Physics engines on the book’s scenes",
             "Game engines on these scenes, with their own steps. An error above 1 exceeds the tolerance.") +
           sections,
       {}});
}

}  // namespace oddity
