#include <cmath>

#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/choose_view.hpp"
#include "report/pages/is_enough_view.hpp"
#include "report/study/is_enough.hpp"
#include "report/text/numbers.hpp"

namespace oddity {

namespace {

std::string trend_text(const Judgement& j) {
  constexpr double grows = 1.5;
  std::string text;
  if (std::isfinite(j.growth))
    text = "its error " + std::string(j.growth > grows ? "grows" : "does not grow") + ": at the end it is " +
           format_significant(j.growth, 2) + " times that at half the time";
  if (std::isfinite(j.energy))
    text += (text.empty() ? "" : "; ") + std::string("its energy is off by ") + percent(j.energy);
  else if (std::isfinite(j.drift) && j.drift > 0)
    text += (text.empty() ? "" : "; ") + std::string("the conserved quantity changes by ") + percent(j.drift);
  return text;
}

std::string limit_text(const Judgement& j, const std::string& unit) {
  if (!j.stable_to || j.run.resolution != "step") return "";
  const double limit = *j.stable_to;
  if (limit == 0) return "no step of it is stable";
  if (std::isinf(limit)) return "every step of it is stable";
  return "its step is " + percent(j.run.setting / limit) + " of the longest stable one, " +
         format_significant(limit, 3) + " " + unit;
}

}  // namespace

std::string is_enough_text(const IsEnough& found, const Screen& screen) {
  Choice choice;  // only for the units of errors
  choice.need = found.need;
  choice.units = found.units;
  const Candidate& best = found.models.front().run;
  const std::string at = best.resolution == "step"
                             ? format_significant(1 / best.setting, 4) +
                                   (found.time_unit == "s" ? " Hz" : " steps a " + found.time_unit)
                             : best.resolution + " " + format_shortest(best.setting);
  std::string text =
      screen.styled(best.holds() ? Style::good : Style::bad,
                    best.holds() ? "Good enough: " : "Not good enough: ") +
      best.algorithm + " at " + at + ", judged " + format_significant(found.need.frames_per_second, 4) +
      " times a " + (found.time_unit == "s" ? "second" : found.time_unit) +
      (found.need.frame_times ? ", " + found.need.frame_times->says + "," : "") +
      (found.need.kicks ? ", with the kick " + found.need.kicked + "," : "") + " on " +
      std::to_string(found.starts.size()) + (found.starts.size() == 1 ? " start" : " starts") + ".\n";
  for (const Judgement& j : found.models) {
    const Candidate& run = j.run;
    text += "  " + run.model + (j.faulted ? ", which its page shows to be wrong: " : ": ") +
            std::string(run.holds() ? "holds" : name_of(run.outcome)) +
            (std::isfinite(run.error) ? ", error " + shown_errors(run, choice) : "") +
            (run.holds() ? "" : ", the worst at " + run.where) + ", " + shown_time(run.seconds_per_frame) +
            " per frame";
    if (j.failing > 0)
      text += "; fails on " + std::to_string(j.failing) + " of " + std::to_string(found.starts.size()) +
              (found.starts.size() == 1 ? " start" : " starts");
    for (const std::string& more : {trend_text(j), limit_text(j, found.time_unit)})
      if (!more.empty()) text += "; " + more;
    text += ".\n";
  }
  return wrapped(text, screen, 4);
}

Table is_enough_table(const IsEnough& found) {
  Table table{{"exercise", "model", "algorithm", "resolution", "setting", "holds", "outcome", "where",
               "error_in_needs", "starts", "failing", "growth", "drift", "energy", "stable_to",
               "evaluations_per_frame", "seconds_per_frame", "frames_per_second"},
              {}};
  for (const Judgement& j : found.models)
    table.rows.push_back({found.exercise, j.run.model, j.run.algorithm, j.run.resolution, j.run.setting,
                          static_cast<long>(j.run.holds()), std::string(name_of(j.run.outcome)), j.run.where,
                          j.run.error, static_cast<long>(found.starts.size()), static_cast<long>(j.failing),
                          j.growth, j.drift, j.energy, j.stable_to.value_or(not_a_number),
                          j.run.evaluations_per_frame, j.run.seconds_per_frame,
                          found.need.frames_per_second});
  return table;
}

}  // namespace oddity
