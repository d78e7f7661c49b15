#include "report/site/recipes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/code.hpp"
#include "report/pages/program_parts.hpp"
#include "report/site/claims_section.hpp"
#include "report/site/example.hpp"
#include "report/site/page.hpp"
#include "report/site/play_link.hpp"
#include "report/study/candidate.hpp"
#include "report/study/findings.hpp"
#include "report/study/picker.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/markup.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

using html::element;

const CheapestModel* recipe_of(const ExerciseResult& e) {
  if (!e.cheapest_models || !entry_of(e.number)) return nullptr;
  const CheapestModel& recipe = e.cheapest_models->recipe;
  return recipe.least ? &recipe : nullptr;
}

/// To its recipe, where it has one.
std::string scene_link(const ExerciseResult& e) {
  return html::link(to_string(e.number) + ".html" + (recipe_of(e) ? "#recipe" : ""),
                    "<b>" + to_string(e.number) + "</b> " + in_xml(e.title));
}

// ---- the least of each scene ------------------------------------------------------------------------------

std::string unit_after(const std::string& unit) {
  return unit.empty() || unit == "1" ? "" : " " + in_xml(typeset_unit(unit));
}

/// A game's tolerances in these units: "1 cm and 1°".
std::string allowed_text(const std::vector<std::string>& units) {
  std::string text;
  for (const std::string& unit : units) {
    const double allowed = game_error(unit);
    text += (text.empty() ? "" : " and ") +
            (unit == "rad" ? format_significant(allowed / degree, 2) + "°"
             : unit == "m" ? format_significant(allowed / centimeter, 2) + " cm"
                           : with_powers(format_significant(allowed, 2)) + unit_after(unit));
  }
  return text;
}

std::string ends_of(const BreakEven& b) {
  const auto with_unit = [&](double x) {
    return with_powers(format_significant(x, 3)) + unit_after(b.parameter_unit);
  };
  std::string text;
  for (const Interval& enough : b.enough) {
    const bool from_start = enough.from == b.looked.from, to_end = enough.to == b.looked.to;
    if (!text.empty()) text += " and ";
    text += from_start && to_end ? "everywhere"
            : from_start         ? "up to " + with_unit(enough.to)
            : to_end             ? "from " + with_unit(enough.from) + " on"
                     : with_powers(format_significant(enough.from, 3)) + " to " + with_unit(enough.to);
  }
  return text;
}

std::string simpler_cell(const CheapestModels& cheapest_models) {
  std::string items;
  for (const BreakEven& b : cheapest_models.break_evens)
    items += element("li", "", in_xml(b.model) + ": <var>" + in_xml(b.parameter) + "</var> " + ends_of(b));
  std::string never;
  for (const std::string& model : cheapest_models.never)
    never += (never.empty() ? "nowhere: " : "; ") + in_xml(model);
  if (!never.empty()) items += element("li", "", never);
  return items.empty() ? "" : element("ul", "", items);
}

std::string fault_cell(const ExerciseResult& e) {
  const Path* path = published_path(e);
  const auto findings = findings_of(e);
  if (path && broken_by(e) > 0) {
    const std::string off =
        path->outcome == Outcome::ok || path->outcome == Outcome::inaccurate
            ? "off by " + with_powers(shown_error(path->error)) +
                  (e.cheapest_models->units.size() == 1 ? unit_after(e.cheapest_models->units.front()) : "")
            : std::string(name_of(path->outcome));
    return html::link(to_string(e.number) + ".html#findings", "<em>" + in_xml(path->model) + "</em>: " + off);
  }
  if (findings.empty()) return "";
  return html::link(
      to_string(e.number) + ".html#findings",
      html::text(findings.front().title()) +
          (findings.size() > 1 ? ", and " + std::to_string(findings.size() - 1) + " more" : ""));
}

std::string game_row(const ExerciseResult& e) {
  const CheapestModel& game = e.cheapest_models->recipe;
  const std::string number = scene_link(e);
  if (!game.least)
    return html::row({number, "none here", "", "", simpler_cell(*e.cheapest_models), fault_cell(e)});
  const Candidate& least = *game.least;
  std::string errors;
  for (double error : least.errors) errors += (errors.empty() ? "" : ", ") + with_powers(shown_error(error));
  return html::row(
      {number, in_xml(least.model),
       in_xml(least.algorithm) +
           (least.resolution.empty() ? "" : ", " + in_xml(with_powers(shown_setting(least, game.need)))),
       format_significant(least.evaluations_per_frame, 3), simpler_cell(*e.cheapest_models), fault_cell(e)},
      "3");
}

std::string for_games(const Results& results) {
  html::Table table{"The least that each scene needs in a game",
                    {"scene", "model that is enough", "algorithm", "evaluations per frame",
                     "where simpler models hold", "fault of the published version"}};
  for (const ExerciseResult& e : results.exercises)
    if (e.cheapest_models) table.rows.push_back(game_row(e));
  if (table.rows.empty()) return "";
  return "<section id=\"games\">\n<h2>What it means for games</h2>\n<p>What stays within " +
         allowed_text({"m", "rad"}) + " at every frame over " + shown_span(game_need(), "s") +
         ": the answer of <code>oddity choose</code> if each evaluation costs the same. The "
         "<a href=\"chooser.html\">chooser</a> answers for a start, an error and a budget of your own.</p>\n" +
         html::table(table) + "</section>\n";
}

// ---- scenes by methods ------------------------------------------------------------------------------------

/// An algorithm's trial on a scene's motion, by any model that is right. It is the one with the least work
/// within a game's tolerance, or the most exact one within a limit of work.
struct Cell {
  const MethodResult* method = nullptr;  ///< the trial's, or the closest one if none is within
  const TimedTrial* trial = nullptr;
  bool within = false;
};

bool has_error(const TimedTrial& t) {
  return t.outcome == Outcome::ok || t.outcome == Outcome::inaccurate || t.outcome == Outcome::drifted;
}
bool is_within(const TimedTrial& t, double close) { return has_error(t) && t.error <= close; }

/// Closed forms take no steps, and have their own column.
constexpr const char* closed_forms = "closed form";
std::string column_of(const MethodResult& m) {
  return m.trials.empty() || m.trials.front().resolution == "step" ||
                 m.trials.front().resolution == "tolerance"
             ? m.algorithm
             : closed_forms;
}

struct Row {
  const ExerciseResult* exercise;
  std::map<std::string, Cell> cells;
  double best = 0;  ///< least work, or least error, of the cells with steps
};
/// The quantity that cells are compared by.
enum class By { work, error };
double measure(const Cell& cell, By by) {
  return by == By::work ? static_cast<double>(cell.trial->evaluations) : cell.trial->error;
}

bool is_better(const TimedTrial& t, bool within, const Cell& than) {
  if (!than.trial || within != than.within) return !than.trial || within;
  return within ? t.evaluations < than.trial->evaluations : t.error < than.trial->error;
}

const QuantityResult* moving_quantity(const ExerciseResult& e) {
  const auto moving =
      std::ranges::find_if(e.quantities, [](const QuantityResult& q) { return q.trajectory.has_value(); });
  return moving == e.quantities.end() ? nullptr : &*moving;
}

/// Calls f(cell, trial) for all trials of models that are right.
template <class F>
void for_each_trial(Row& row, const F& f) {
  for (const MethodResult& m : moving_quantity(*row.exercise)->methods)
    if (!is_published(m.model))
      for (const TimedTrial& t : m.trials) f(row.cells[column_of(m)], m, t);
}

void find_best(Row& row, By by) {
  row.best = INFINITY;
  for (const auto& [column, cell] : row.cells)
    if (cell.within && column != closed_forms) row.best = std::min(row.best, measure(cell, by));
}

Row by_work(const ExerciseResult& e) {
  Row row{&e, {}};
  const double close = moving_quantity(e)->trajectory->close;
  for_each_trial(row, [&](Cell& cell, const MethodResult& m, const TimedTrial& t) {
    if (const bool within = is_within(t, close); is_better(t, within, cell)) cell = {&m, &t, within};
  });
  find_best(row, By::work);
  return row;
}

/// At so many times the work of the row's best method.
constexpr double times_the_work = 2;
Row by_error(const Row& work) {
  Row row{work.exercise, {}};
  for_each_trial(row, [&](Cell& cell, const MethodResult& m, const TimedTrial& t) {
    const bool can_pay = has_error(t) && static_cast<double>(t.evaluations) <= times_the_work * work.best;
    if (!cell.trial || (can_pay && (!cell.within || t.error < cell.trial->error))) cell = {&m, &t, can_pay};
  });
  find_best(row, By::error);
  return row;
}

/// The algorithms tried with any scene, in the catalog's order; closed forms first.
std::vector<std::string> columns_of(const std::vector<Row>& rows) {
  std::set<std::string> tried;
  for (const Row& row : rows)
    for (const auto& [column, cell] : row.cells) tried.insert(column);
  std::vector<std::string> columns;
  if (tried.contains(closed_forms)) columns.emplace_back(closed_forms);
  for (const ode::CatalogEntry& a : ode::catalog())
    if (tried.contains(std::string(a.name))) columns.emplace_back(a.name);
  return columns;
}

/// Shades, each with the largest multiple of the best that it covers.
using Shades = std::array<std::pair<const char*, double>, 3>;
constexpr Shades shades_of_work{{{"best", 1.25}, {"near", 2.5}, {"dear", 10}}},
    shades_of_error{{{"best", 3}, {"near", 100}, {"dear", 1e4}}};
const Shades& shades(By by) { return by == By::work ? shades_of_work : shades_of_error; }

std::string shade_of(double ratio, By by) {
  const auto shade = std::ranges::find_if(shades(by), [&](const auto& one) { return ratio <= one.second; });
  return shade == shades(by).end() ? "dearest" : shade->first;
}
std::string shades_legend(By by) {
  std::string items;
  for (const auto& [shade, most] : shades(by))
    items += element("li", " class=\"" + std::string(shade) + "\"",
                     "up to " + with_powers(format_significant(most, 3)) + (items.empty() ? " times" : ""));
  return element("ul", " class=\"shades\"",
                 items + "<li class=\"dearest\">more</li><li class=\"fails\">× " +
                     (by == By::work ? "at no setting tried" : "needs more work") +
                     "</li><li>= a closed form, without steps</li>");
}

std::string ratio_text(double ratio) {
  return ratio < 10    ? format_significant(ratio, 2)
         : ratio < 100 ? std::to_string(std::lround(ratio))
                       : with_powers("1e+" + std::to_string(std::lround(std::log10(ratio)))).substr(3);
}

std::string cell_text(const Row& row, const std::string& column, By by) {
  const auto found = row.cells.find(column);
  if (found == row.cells.end() || !found->second.trial) return element("td", "", "");
  const auto& [method, trial, within] = found->second;
  const bool closed = column == closed_forms;
  const double ratio = closed || !within ? 0 : std::max(1.0, measure(found->second, by) / row.best);
  const std::string shade = !within  ? "fails"
                            : closed ? "best"
                                     : shade_of(ratio, by),
                    text = !within  ? "×"
                           : closed ? "="
                                    : ratio_text(ratio),
                    says = column + " on " + method->model + ", " + row.exercise->title + ": " +
                           (!within  ? by == By::work ? "no setting tried is within the error"
                                                      : "no setting tried takes so little work"
                            : closed ? "within the error"
                                     : text + (by == By::work ? " times the least work"
                                                              : " times the least error"));
  return element("td", " class=\"" + shade + "\"",
                 "<a href=\"" +
                     link_to_player(*row.exercise, {{method->model, method->algorithm, trial->setting}}) +
                     "\" title=\"" + in_xml(says) + "\">" + text + "</a>");
}

std::string table_of(const std::vector<Row>& rows, By by, const std::string& name) {
  const std::vector<std::string> columns = columns_of(rows);
  std::string head = "<th scope=\"col\">scene</th>", body;
  for (const std::string& column : columns)
    head += element("th", " scope=\"col\"", element("span", "", in_xml(column)));
  for (const Row& row : rows) {
    std::string cells = element("th", " scope=\"row\"", scene_link(*row.exercise));
    for (const std::string& column : columns) cells += cell_text(row, column, by);
    body += element("tr", "", cells) + "\n";
  }
  return shades_legend(by) + "\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + name +
         "\">" +
         element("table", " class=\"matrix\"",
                 element("thead", "", element("tr", "", head)) + "\n" + element("tbody", "", body)) +
         "</div>\n";
}

std::string matrix(const Results& results) {
  std::vector<Row> of_work, of_error;
  for (const ExerciseResult& e : results.exercises)
    if (moving_quantity(e)) of_work.push_back(by_work(e));
  for (const Row& row : of_work) of_error.push_back(by_error(row));
  if (of_work.empty()) return "";
  return "<section id=\"matrix\">\n<h2>Scenes by methods: the work for an error</h2>\n<p>Each method's work relative "
         "to the least work of one with steps, in evaluations of the equations, for a motion that differs by at most " +
         allowed_text({"m", "rad"}) +
         " from the true one at the times of its table, which are fewer than a game's frames. Each cell plays its "
         "trial.</p>\n" +
         table_of(of_work, By::work, "Scenes by methods, the work") +
         "</section>\n<section id=\"errors\">\n<h2>Scenes by methods: the error for so much work</h2>\n<p>Each "
         "method's error relative to the least one, with at most twice the work of the best one above. Each cell plays "
         "its trial.</p>\n" +
         table_of(of_error, By::error, "Scenes by methods, the error") + "</section>\n";
}

// ---- a scene's recipe -------------------------------------------------------------------------------------

bool is_simple(const CheapestModel& game, const Scene& scene) {
  Need need = game.need;
  need.objective = Objective::simple;
  return Picker(need, scene).meets_objective(*game.least);
}

std::string answer(const CheapestModel& game, const CheapestModels& models, const Scene& scene) {
  const Candidate& least = *game.least;
  std::string errors;
  for (std::size_t i = 0; i < least.errors.size() && i < models.units.size(); ++i)
    errors += (errors.empty() ? "" : ", ") + with_powers(shown_error(least.errors[i])) +
              unit_after(models.units[i]);
  return element(
             "p", " class=\"answer\"",
             "<strong>" + in_xml(least.model) + "</strong> by <strong>" + in_xml(least.algorithm) +
                 "</strong>" +
                 (least.resolution.empty() ? ""
                                           : ", " + in_xml(with_powers(shown_setting(least, game.need)))) +
                 ".") +
         element(
             "p", "",
             "Within " + allowed_text(models.units) + " at every frame over " +
                 shown_span(game.need, scene.axes.time) + ": " +
                 format_significant(least.evaluations_per_frame, 3) +
                 (least.evaluations_per_frame == 1 ? " evaluation" : " evaluations") + " per frame, off by " +
                 errors + " at most. <code>oddity choose</code> takes it if each evaluation costs the same" +
                 (is_simple(game, scene)
                      ? ". It is the simplest model at this cost. Only closed forms and one-step methods of fixed step "
                        "count, with a margin of three."
                      : ". No closed form or one-step method of fixed step holds with a margin of three.") +
                 " <a class=\"screen\" href=\"recipes.html\">All scenes</a>");
}

/// Third-party engines at a step per frame with their defaults.
std::string engines_of(const EngineContest& contest) {
  std::vector<std::pair<double, const EngineSeries*>> all;
  for (const EngineSeries& series : contest.series)
    if (series.defaults && !series.trials.empty() && series.trials.front().steps_per_frame == 1)
      all.emplace_back(series.trials.front().in_needs, &series);
  if (all.empty()) return "";
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) {
    return !std::isnan(a.first) && (std::isnan(b.first) || a.first < b.first);
  });
  const auto within = std::ranges::count_if(all, [](const auto& one) { return one.first <= 1; });
  std::string items;
  for (const auto& [error, series] : all)
    items += element(
        "li", "",
        in_xml(series->engine + " " + series->version) + ": " +
            (std::isfinite(error) ? with_powers(format_significant(error, 2)) + " times" : "no motion"));
  return element("p", "",
                 "Of " + counted(std::ssize(all), "engine", "engines") + " at 60 Hz with their defaults, " +
                     std::to_string(within) + (within == 1 ? " is" : " are") + " within the same error.") +
         html::folded("Their errors, relative to the allowed one", element("ul", "", items));
}

/// Keeps its lines separate.
std::string lines_in_xml(const std::string& code) {
  std::string text;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) text += in_xml(line) + "\n";
  return text;
}

/// "54 lines of C++ that do it, a function friction of 40 lines, and 13 that print it"; comments and blank
/// lines are not counted.
std::string counted_lines(const std::string& code, Language language) {
  const std::string_view printing_part = program_parts::main_of(language).text;
  const std::string_view begins = printing_part.substr(1, printing_part.find_first_of("{$") - 1);
  const std::size_t main = std::min(code.find(begins), code.size());
  long own = lines_of_code(code.substr(0, main));
  std::string of_helpers;
  for (const PrintedHelper& helper : helpers_in(code)) {
    own -= helper.lines;
    of_helpers += ", a function " + helper.name + " of " + counted(helper.lines, "line", "lines");
  }
  return counted(own, "line", "lines") + " of " +
         std::string(language_names[static_cast<std::size_t>(language)]) + " that do it" + of_helpers +
         ", and " + std::to_string(lines_of_code(code.substr(main))) + " that print it";
}

std::string code_in(Language language, const ExerciseResult& e, const CheapestModel& game) {
  const std::string name(language_names[static_cast<std::size_t>(language)]);
  try {
    const std::string code = code_of(Task(*entry_of(e.number)), *game.least, game.need,
                                     to_string(e.number) + " " + e.title + ": " + game.least->model + " by " +
                                         game.least->algorithm + "\n\nThe observables at every frame.",
                                     language);
    return html::folded(
        counted_lines(code, language),
        element("pre", " class=\"code\" tabindex=\"0\" data-language=\"" + name + "\"", lines_in_xml(code)));
  } catch (const BadInput& error) {
    return element("p", " class=\"none\"", "No " + name + ": " + in_xml(error.what()) + ".");
  }
}

std::string code_text(const ExerciseResult& e, const CheapestModel& game) {
  return code_in(Language::cpp, e, game) + code_in(Language::c_sharp, e, game) +
         code_in(Language::javascript, e, game);
}

}  // namespace

std::string recipe_section(const ExerciseResult& e, std::span<const EngineContest> contests) {
  const CheapestModel* game = recipe_of(e);
  if (!game) return "";
  std::string engines;
  for (const EngineContest& contest : contests)
    if (contest.scene == to_string(e.number)) engines += engines_of(contest);
  return "<section id=\"recipe\" class=\"recipe\">\n<h2>What to use</h2>\n" +
         answer(*game, *e.cheapest_models, *entry_of(e.number)->exercise.scene) + engines +
         code_text(e, *game) + "</section>\n";
}

std::string recipes_page(const Results& results) {
  return html::whole(
      {"What do I use? - oddity",
       "<header class=\"title\">\n<h1>What do I use?</h1>\n<p class=\"asks\">The model, the algorithm and "
       "the step that are enough for each scene. The page of a scene has the code. For a start, an error and a "
       "budget of your own there is the <a href=\"chooser.html\">chooser</a>.</p>\n</header>\n" +
           for_games(results) + matrix(results),
       {}});
}

}  // namespace oddity
