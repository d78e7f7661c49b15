#include "report/pages/tables.hpp"

#include <limits>

#include "reference/text.hpp"
#include "report/pages/held_steps_view.hpp"
#include "report/pages/stability_view.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"

namespace oddity {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string as_text(std::string_view view) { return std::string(view); }

std::string value_text(const Value& value) {
  std::string text;
  for (double x : value) text += (text.empty() ? "" : " ") + format_shortest(x);
  return text;
}

void add_trials(Table& table, const ExerciseResult& e, const QuantityResult& q, const auto& methods) {
  for (const auto& m : methods)
    for (const TimedTrial& t : m.trials)
      table.rows.push_back({to_string(e.number), q.name, q.unit, t.model, t.algorithm,
                            as_text(name_of(t.precision)), t.resolution,
                            t.resolution.empty() ? none : t.setting, value_text(t.value), t.error,
                            q.need.allowed, t.evaluations, t.time.seconds, t.time.spread,
                            as_text(name_of(t.outcome)), t.message});
}

}  // namespace

Table parameters_table(std::span<const Task> tasks) {
  Table table{{"exercise", "title", "scene", "parameter", "value", "unit", "least", "most", "whole", "says"},
              {}};
  for (const Task& task : tasks) {
    const Exercise& e = task.entry->exercise;
    const std::vector<Cell> begin{to_string(task.entry->number), as_text(e.title), e.scene ? 1L : 0L};
    const auto add = [&](std::vector<Cell> cells) {
      cells.insert(cells.begin(), begin.begin(), begin.end());
      table.rows.push_back(std::move(cells));
    };
    for (const Parameter& p : e.parameters)
      add({as_text(p.name), p.value, as_text(p.unit), p.least, p.most, p.whole ? 1L : 0L, as_text(p.says)});
    if (e.parameters.empty()) add({"", "", "", "", "", "", ""});
  }
  return table;
}

Table claims_table(const Results& results, const Verdicts& on_record) {
  Table table{{"exercise", "claim", "line", "verdict", "on_record", "kind", "root", "says", "why"}, {}};
  for (const ExerciseResult& e : results.exercises)
    for (const JudgedClaim& c : e.claims) {
      const auto recorded = on_record.find(c.claim.id);
      table.rows.push_back({to_string(e.number), c.claim.id, static_cast<long>(c.claim.line),
                            as_text(name_of(c.verdict)), recorded == on_record.end() ? "" : recorded->second,
                            as_text(name_of(c.claim.kind)), c.claim.root, c.claim.says,
                            c.verdict == Verdict::not_checkable ? c.claim.not_checkable : c.claim.why});
    }
  return table;
}

Table trials_table(const Results& results) {
  Table table{{"exercise", "quantity", "unit", "model", "algorithm", "precision", "resolution", "setting",
               "value", "error", "needed", "evaluations", "seconds", "spread", "outcome", "message"},
              {}};
  for (const ExerciseResult& e : results.exercises)
    for (const QuantityResult& q : e.quantities) {
      add_trials(table, e, q, q.methods);
      add_trials(table, e, q, q.in_float);
    }
  return table;
}

Table limits_table(const Results& results) { return limits_table(results, {}); }

Table limits_table(const Results& results, std::span<const HeldSteps> held) {
  Table table{{"exercise", "model", "algorithm", "stable_to", "breaks_at", "theory", "unit", "breaks_by",
               "error", "error_unit", "why", "unstable_in_theory", "error_there", "needed_to",
               "not_sharp_from", "not_sharp_to", "watched", "how", "cure"},
              {}};
  const bool has_asked = !held.empty() && !held.front().asked.empty(),
             has_frames = !held.empty() && !held.front().frames.empty();
  if (has_asked) table.columns.push_back("holds_to");
  if (has_frames) table.columns.push_back("stable_at_frames");
  for (std::size_t i = 0; i < results.exercises.size(); ++i) {
    const ExerciseResult& e = results.exercises[i];
    for (const Limit& l : e.stability->limits) {
      const Stability& s = *e.stability;
      table.rows.push_back({to_string(e.number), l.model, l.algorithm, l.step(),
                            l.broken ? l.broken->setting : none, l.theory(), s.time_unit, beyond(l),
                            l.broken ? l.broken->error : none, s.unit, l.why, shown_tongues(l),
                            l.at ? l.at->error : none, l.within ? l.within->setting : none,
                            l.soft ? l.soft->least : none, l.soft ? l.soft->most : none,
                            l.goes_on || std::isinf(l.step()) ? none : l.watched, how_it_breaks(l, s),
                            l.broken ? shown_cure(l, s.unit) : ""});
      const auto add = [&](const auto& steps) {
        const auto found = steps.find({l.model, l.algorithm});
        table.rows.back().push_back(found == steps.end() ? none : found->second);
      };
      if (has_asked) add(held[i].longest);
      if (has_frames) add(held[i].stable_at_frames);
    }
  }
  return table;
}

}  // namespace oddity
