#include "report/pages/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/claims.hpp"
#include "report/pages/text_view.hpp"
#include "report/text/markup.hpp"

namespace oddity {

namespace {

std::string picture_file(const ExerciseResult& e, const QuantityResult& q, const std::string& kind) {
  return "charts/" + to_string(e.number) + "_" + file_name(q.name) + kind + ".svg";
}

std::string image(const std::string& says, const std::string& file) {
  return "![" + escaped(says, false) + "](" + file + ")\n\n";
}

std::string axis_of(Across across) {
  return across == Across::time ? "time" : across == Across::evaluations ? "evaluations" : "setting";
}

bool of_one_model(const QuantityResult& q) {
  return std::ranges::all_of(q.methods,
                             [&](const MethodResult& m) { return m.model == q.methods.front().model; });
}

std::string method_name(const QuantityResult& q, const TimedTrial& t) {
  return escaped(of_one_model(q) ? t.algorithm : t.model + ", " + t.algorithm, false);
}

/// The cheapest trials within the need, cheapest first: one per family of algorithms, or per model for
/// algorithms without a family. At most three for a motion, otherwise one.
std::vector<const TimedTrial*> cheapest_within(const QuantityResult& q) {
  const std::size_t most = q.trajectory ? 3 : 1;
  std::vector<std::pair<std::string, const TimedTrial*>> best;
  for (const MethodResult& m : q.methods) {
    const TimedTrial& t = best_of(m, Cost::evaluations);
    if (t.outcome != Outcome::ok) continue;
    const Family family = family_of(m.algorithm);
    const std::string key = family == Family::none ? m.model : std::to_string(static_cast<int>(family));
    const auto same = std::ranges::find(best, key, &std::pair<std::string, const TimedTrial*>::first);
    if (same == best.end())
      best.emplace_back(key, &t);
    else if (preferable(t, *same->second, Cost::evaluations))
      same->second = &t;
  }
  std::ranges::stable_sort(
      best, [](const auto& a, const auto& b) { return preferable(*a.second, *b.second, Cost::evaluations); });
  std::vector<const TimedTrial*> trials;
  for (const auto& [key, t] : best)
    if (trials.size() < most) trials.push_back(t);
  return trials;
}

/// "Runge-Kutta 4, step 0.0156: 2560 evaluations, error 4.4×10⁻⁷".
std::string trial_text(const QuantityResult& q, const TimedTrial& t) {
  return method_name(q, t) +
         (t.resolution.empty() ? "" : ", " + with_powers(escaped(shown_resolution(t), false))) + ": " +
         counted(static_cast<int>(t.evaluations), "evaluation", "evaluations") +
         (std::isfinite(t.error) ? ", error " + error_cell(t.error) : "");
}

std::string methods_text(const QuantityResult& q) {
  const auto trials = cheapest_within(q);
  std::string text;
  for (const TimedTrial* t : trials) text += "- " + trial_text(q, *t) + "\n";
  if (!trials.empty()) return text + "\n";
  const TimedTrial* closest = nullptr;
  for (const MethodResult& m : q.methods)
    if (const TimedTrial& t = best_of(m, Cost::evaluations);
        !closest || preferable(t, *closest, Cost::evaluations))
      closest = &t;
  return closest ? "No method is within the need; the closest is " + trial_text(q, *closest) + ", *" +
                       std::string(name_of(closest->outcome)) + "*.\n\n"
                 : "";
}

/// Methods that do not end as expected: none in a green run, but those of motions may at other parameters.
std::string surprises(const QuantityResult& q) {
  std::string text;
  for (const MethodResult& m : q.methods)
    if (!m.as_expected())
      text += "- " + escaped(m.model + ", " + m.algorithm, false) + " ends **" +
              std::string(m.trials.empty() ? "without a trial" : name_of(m.trials.back().outcome)) +
              (m.asserted ? "** (expected " : "** at these parameters (usually ") +
              std::string(name_of(m.expected)) + ").\n";
  return text.empty() ? "" : text + "\n";
}

std::string breakdown_text(const BreakdownResult& b) {
  const auto end = [](const TimedTrial& t) {
    return escaped(t.model + ", " + t.algorithm, false) +
           (t.resolution.empty() ? "" : ", " + with_powers(escaped(shown_resolution(t), false))) + ": " +
           (std::isfinite(t.error) ? "error " + error_cell(t.error) : "no number") +
           (t.outcome == Outcome::ok ? "" : ", *" + std::string(name_of(t.outcome)) + "*");
  };
  return std::string(b.as_expected() ? "**Breaks.** " : "**Does not break so here.** ") + prose(b.says) +
         "\n\n- " + end(b.broken) + "\n- cure: " + end(b.cured) + "\n\n";
}

/// How many settings within the need in double are within it in float.
std::string lost_in_float(const QuantityResult& q) {
  int held = 0, lost = 0;
  for (const FloatResult& m : q.in_float)
    for (std::size_t i = 0; i < m.trials.size(); ++i) {
      if (q.methods[m.in_double].trials[i].outcome != Outcome::ok) continue;
      ++held;
      lost += m.trials[i].outcome != Outcome::ok;
    }
  if (held == 0) return "no method is within the need in double";
  if (held == 1)
    return "the one setting that is within the need in double " +
           std::string(lost == 0 ? "stays within it" : "does not stay within it");
  const std::string within =
      " of the " + std::to_string(held) + " settings that are within the need in double ";
  return lost == 0 ? "all" + within + "stay within it"
         : lost == held
             ? "none" + within + "stays within it"
             : std::to_string(held - lost) + within + (held - lost == 1 ? "stays" : "stay") + " within it";
}

/// The least error in float.
std::string in_float_text(const QuantityResult& q) {
  const TimedTrial* least = nullptr;
  const TimedTrial* like = nullptr;
  for (const FloatResult& m : q.in_float)
    for (std::size_t i = 0; i < m.trials.size(); ++i)
      if (const TimedTrial& t = m.trials[i]; std::isfinite(t.error) && (!least || t.error < least->error))
        least = &t, like = &q.methods[m.in_double].trials[i];
  if (!least) return "";
  return "**In float:** " + lost_in_float(q) + "; the least error is " + error_cell(least->error) + " (" +
         escaped(least->model + ", " + like->algorithm, false) +
         (least->resolution.empty() ? "" : ", " + with_powers(escaped(shown_resolution(*least), false))) +
         ")" +
         (!q.trajectory                         ? ""
          : least->error <= q.trajectory->close ? ", enough for a game"
                                                : ", not enough for a game") +
         ".\n\n";
}

/// The chart of a series, below its last quantity.
std::string series_link(const ExerciseResult& e, const QuantityResult& q) {
  for (const auto& series : series_of(e))
    if (series.back() == &q) return image("work over size", series_file(e, *series.front()));
  return "";
}

}  // namespace

std::string quantity_head(const QuantityResult& q) {
  const std::string unit = q.unit == "1" || q.unit.empty() ? "" : " " + escaped(typeset_unit(q.unit), false);
  const bool one = q.reference.value.size() == 1;
  return "### " + code(q.name) + ": " + escaped(q.says, false) + "\n\n" +
         (one ? "**" + value_cell(q.reference.value, 16) + unit + "** (" : "Truth: ") +
         escaped(q.reference.by, false) + (one ? "), needed to " : "; needed to ") +
         error_cell(q.need.allowed) +
         (one                                   ? ""
          : unit.find(',') == std::string::npos ? unit
                                                : " (" + unit.substr(1) + ")") +
         (q.samples > 1 ? "; " + instants(q) : "") + ".\n\n";
}

std::string quantity_text(const ExerciseResult& e, const QuantityResult& q, bool charts) {
  std::string text = quantity_head(q);
  if (charts) {
    text += motion_link(e, q);
    if (const auto all = charts_of(q); !all.empty())
      text += image("error against " + axis_of(all.front()), chart_file(e, q, all.front()));
    text += series_link(e, q);
  }
  text += methods_text(q) + surprises(q) + in_float_text(q);
  for (const BreakdownResult& b : q.breakdowns) text += breakdown_text(b);
  return text;
}

std::string expected_failures(const ExerciseResult& e) {
  struct Reason {
    std::string why;
    std::set<std::string> models, algorithms;
    int methods = 0;
  };
  std::vector<Reason> reasons;
  for (const QuantityResult& q : e.quantities)
    for (const MethodResult& m : q.methods) {
      if (!m.fails_as_expected()) continue;
      auto same = std::ranges::find(reasons, m.why, &Reason::why);
      if (same == reasons.end()) same = reasons.insert(reasons.end(), {m.why, {}, {}});
      same->models.insert(m.model);
      same->algorithms.insert(m.algorithm);
      ++same->methods;
    }
  if (reasons.empty()) return "";
  std::string lines;
  int count = 0;
  for (const Reason& r : reasons) {
    const bool one_algorithm = r.algorithms.size() == 1;
    lines += "- " +
             (r.models.size() > 1 && !one_algorithm
                  ? std::to_string(r.methods) + " methods"
                  : escaped(r.models.size() > 1 ? *r.algorithms.begin()
                            : one_algorithm     ? *r.models.begin() + ", " + *r.algorithms.begin()
                                                : *r.models.begin(),
                            false)) +
             ": " + escaped(r.why, false) + ".\n";
    count += r.methods;
  }
  return "<details><summary>" + counted(count, "method fails as expected", "methods fail as expected") +
         "</summary>\n\n" + lines + "\n</details>\n\n";
}

std::string motion_link(const ExerciseResult& e, const QuantityResult& q) {
  return q.trajectory ? image("the motion", trajectory_file(e, q)) : "";
}

std::string chart_links(const ExerciseResult& e, const QuantityResult& q) {
  std::string text;
  for (Across across : charts_of(q))
    text += image("error against " + axis_of(across), chart_file(e, q, across));
  return text;
}

std::string trials_table(const QuantityResult& q) {
  const std::vector<bool> by_evaluations = pareto_front(q, Cost::evaluations),
                          by_time = pareto_front(q, Cost::time);
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& m : q.methods)
    for (const TimedTrial& t : m.trials) {
      const std::string front =
          std::string(by_evaluations[rows.size()] ? "E" : "") + (by_time[rows.size()] ? "T" : "");
      rows.push_back(
          {escaped(t.model), escaped(t.algorithm), resolution_cell(t), error_cell(t.error),
           error_cell(t.final_error), std::to_string(t.evaluations), shown_time(t.time.seconds),
           shown_time(t.time.spread),
           t.evaluations > 0 ? shown_time(t.time.seconds / static_cast<double>(t.evaluations)) : "-",
           std::string(name_of(t.outcome)), front});
    }
  return table({"model", "algorithm", "resolution", "error", "final error", "evaluations", "time", "spread",
                "per evaluation", "outcome", "front"},
               rows, "345678");
}

std::string fits_table(const QuantityResult& q) {
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& m : q.methods)
    if (const auto f = fit(q, m))
      rows.push_back({escaped(m.model), escaped(m.algorithm), escaped(shown_fit(m, f)), error_cell(f->factor),
                      resolution_cell(m.trials[f->first]) + " to " +
                          with_powers(format_significant(m.trials[f->last].setting, 4))});
  if (rows.empty()) return "";
  return "Fitted: error = factor × setting^exponent, with 1/setting where the setting is a count.\n\n" +
         table({"model", "algorithm", "fit", "factor", "over"}, rows, "3");
}

std::string chart_file(const ExerciseResult& e, const QuantityResult& q, Across across) {
  const bool beside = across == Across::setting && charts_of(q).size() > 1;
  return picture_file(e, q, across == Across::time ? "_time" : beside ? "_over_step" : "");
}

std::string trajectory_file(const ExerciseResult& e, const QuantityResult& q) {
  return picture_file(e, q, "_motion");
}

std::string series_file(const ExerciseResult& e, const QuantityResult& first) {
  return picture_file(e, first, "_series");
}

}  // namespace oddity
