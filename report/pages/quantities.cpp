#include "report/pages/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/text.hpp"
#include "report/pages/findings.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"

namespace oddity {

namespace {

std::string picture_file(const ExerciseResult& e, const QuantityResult& q, const std::string& kind) {
  return "charts/" + to_string(e.number) + "_" + file_name(q.name) + kind + ".svg";
}

std::string image(const std::string& says, const std::string& file) {
  return "![" + escaped(says, false) + "](" + file + ")\n\n";
}

bool of_one_model(const QuantityResult& q) {
  return std::ranges::all_of(q.methods,
                             [&](const MethodResult& m) { return m.model == q.methods.front().model; });
}

std::string method_cell(const QuantityResult& q, const TimedTrial& t) {
  return escaped(of_one_model(q) ? t.algorithm : t.model + ", " + t.algorithm);
}

/// Each method's cheapest trial that is ok, or else its most accurate one.
std::string methods_table(const QuantityResult& q) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i : worth_seeing(q, Across::evaluations)) {
    const TimedTrial& t = best_of(q.methods[i], Cost::evaluations);
    rows.push_back({method_cell(q, t), knob_cell(t), std::to_string(t.evaluations), error_cell(t.error),
                    t.outcome == Outcome::ok ? "yes" : std::string(name_of(t.outcome))});
  }
  const auto left_out = static_cast<int>(q.methods.size() - rows.size());
  return table({"method", "setting", "evaluations", "error", "within the need"}, rows, "23") +
         (left_out > 0 ? "Of " + std::to_string(q.methods.size()) +
                             " methods, those on the front and the best of each model and family.\n\n"
                       : "");
}

/// What differs from what is expected: nothing in a green run.
std::string surprises(const QuantityResult& q) {
  std::string text;
  for (const MethodResult& m : q.methods)
    if (!m.as_expected())
      text += "- " + escaped(m.model + ", " + m.algorithm, false) + " ends **" +
              std::string(m.trials.empty() ? "without a trial" : name_of(m.trials.back().outcome)) +
              "** (expected " + std::string(name_of(m.expected)) + ").\n";
  return text.empty() ? "" : text + "\n";
}

/// "one angle by explicit Euler, velocity Verlet; small angle by closed form".
std::string by_model(const std::vector<const MethodResult*>& methods) {
  std::vector<std::pair<std::string, std::string>> models;
  for (const MethodResult* m : methods) {
    const auto same = std::ranges::find(models, m->model, &std::pair<std::string, std::string>::first);
    if (same == models.end())
      models.emplace_back(m->model, m->algorithm);
    else
      same->second += ", " + m->algorithm;
  }
  std::string text;
  for (const auto& [model, algorithms] : models)
    text += (text.empty() ? "" : "; ") + escaped(model + " by " + algorithms, false);
  return text;
}

/// Why methods are expected to fail, those with the same reason together.
std::string expected_failures(const QuantityResult& q) {
  struct Reason {
    std::string text;
    std::vector<const MethodResult*> methods;
  };
  std::vector<Reason> reasons;
  int count = 0;
  for (const MethodResult& m : q.methods) {
    if (m.why.empty() || m.expected == Outcome::ok) continue;
    ++count;
    const std::string text = "*" + std::string(name_of(m.expected)) + "*: " + escaped(m.why, false);
    const auto same = std::ranges::find(reasons, text, &Reason::text);
    if (same == reasons.end())
      reasons.push_back({text, {&m}});
    else
      same->methods.push_back(&m);
  }
  if (reasons.empty()) return "";
  std::string text = "<details><summary>" +
                     plural(count, "method is expected to fail", "methods are expected to fail") +
                     "</summary>\n\n";
  for (const Reason& r : reasons) text += "- " + by_model(r.methods) + ": " + r.text + ".\n";
  return text + "\n</details>\n\n";
}

std::string breakdown_text(const BreakdownResult& b) {
  const auto line = [](const std::string& what, const TimedTrial& t) {
    const std::string knob = t.knob.empty() ? "" : ", " + with_powers(escaped(shown_knob(t), false));
    return "- " + what + ": " + escaped(t.model + ", " + t.algorithm, false) + knob + ": " +
           (std::isfinite(t.error) ? "error " + error_cell(t.error) + ", " : "") + "*" +
           std::string(name_of(t.outcome)) + "*, " +
           plural(static_cast<int>(t.evaluations), "evaluation", "evaluations") + "\n";
  };
  return "**Where it breaks.** " + prose(b.says) + "\n\n" + line("breaks", b.broken) + line("cure", b.cured) +
         "\n";
}

/// How many settings hold in double, and how many of these do not in float.
std::string lost_in_float(const QuantityResult& q) {
  int held = 0, lost = 0;
  for (const FloatResult& m : q.in_float)
    for (std::size_t i = 0; i < m.trials.size(); ++i) {
      if (q.methods[m.in_double].trials[i].outcome != Outcome::ok) continue;
      ++held;
      lost += m.trials[i].outcome != Outcome::ok;
    }
  if (held == 0) return "none of its methods is within the need in double";
  const std::string all = plural(held, "setting", "settings") + " within the need in double";
  return lost == 0 ? "of " + all + ", none is outside it in float"
                   : "of " + all + ", " + std::to_string(lost) + (lost == 1 ? " is" : " are") +
                         " outside it in float";
}

/// Where float's floor lies.
std::string in_float_text(const QuantityResult& q) {
  const TimedTrial* least = nullptr;
  const TimedTrial* like = nullptr;
  for (const FloatResult& m : q.in_float)
    for (std::size_t i = 0; i < m.trials.size(); ++i)
      if (const TimedTrial& t = m.trials[i]; std::isfinite(t.error) && (!least || t.error < least->error))
        least = &t, like = &q.methods[m.in_double].trials[i];
  if (!least) return "";
  return "**In float**, as games compute: " + lost_in_float(q) + ". The least error is " +
         error_cell(least->error) + ", of " + escaped(least->model + ", " + like->algorithm, false) +
         (least->knob.empty() ? "" : " at " + with_powers(escaped(shown_knob(*least), false))) +
         (q.trajectory
              ? least->error <= q.trajectory->close ? ", enough for a game" : ", not enough for a game"
              : "") +
         ".\n\n";
}

/// Beneath the last of a series, its chart.
std::string series_link(const ExerciseResult& e, const QuantityResult& q) {
  for (const auto& series : series_of(e))
    if (series.back() == &q) return image(series_finding(series), series_file(e, *series.front()));
  return "";
}

}  // namespace

std::string quantity_head(const QuantityResult& q) {
  return "### " + code(q.name) + ": " + escaped(q.says, false) +
         "\n\nReference: " + value_cell(q.reference.value, 16) +
         (q.unit == "1" ? "" : " " + escaped(q.unit, false)) + ", known to " + error_cell(q.reference_error) +
         " (" + escaped(q.reference.by, false) + "). Needed to " + error_cell(q.need.allowed) + ": " +
         escaped(q.need.reason, false) + (q.samples > 1 ? "; " + instants(q) : "") + ".\n\n";
}

std::string quantity_text(const ExerciseResult& e, const QuantityResult& q, bool charts) {
  std::string text = quantity_head(q);
  if (charts) {
    text += motion_link(e, q);
    if (const auto all = charts_of(q); !all.empty())
      text += image(finding(q, all.front()), chart_file(e, q, all.front()));
    text += series_link(e, q);
  }
  text += methods_table(q) + surprises(q) + in_float_text(q);
  for (const BreakdownResult& b : q.breakdowns) text += breakdown_text(b);
  return text + expected_failures(q);
}

std::string motion_link(const ExerciseResult& e, const QuantityResult& q) {
  return q.trajectory ? image(motion_finding(q), trajectory_file(e, q)) : "";
}

std::string chart_links(const ExerciseResult& e, const QuantityResult& q) {
  std::string text;
  for (Across across : charts_of(q)) text += image(finding(q, across), chart_file(e, q, across));
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
          {escaped(t.model), escaped(t.algorithm), knob_cell(t), error_cell(t.error),
           error_cell(t.final_error), std::to_string(t.evaluations), shown_time(t.time.seconds),
           shown_time(t.time.spread),
           t.evaluations > 0 ? shown_time(t.time.seconds / static_cast<double>(t.evaluations)) : "-",
           std::string(name_of(t.outcome)), front});
    }
  return table({"model", "algorithm", "knob", "error", "final error", "evaluations", "time", "spread",
                "per evaluation", "outcome", "front"},
               rows, "345678");
}

std::string fits_table(const QuantityResult& q) {
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& m : q.methods)
    if (const auto f = fit(q, m))
      rows.push_back(
          {escaped(m.model), escaped(m.algorithm), escaped(shown_fit(m, f)), error_cell(f->factor),
           knob_cell(m.trials[f->first]) + " to " + with_powers(rounded(m.trials[f->last].setting, 4))});
  if (rows.empty()) return "";
  return "Fitted: error = factor × knob^exponent, for a knob that counts, factor × (1/knob)^exponent.\n\n" +
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
