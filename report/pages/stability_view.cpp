#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/csv.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/pages/held_steps_view.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/text_view.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"
#include "report/text/table_text.hpp"

namespace oddity {

namespace {

std::string shown_theory(const Limit& l) {
  return std::isinf(l.theory()) ? "every step" : l.theory() == 0 ? "none" : format_significant(l.theory(), 3);
}

std::string in_unit(const std::string& value, const std::string& unit) {
  return unit.empty() || unit == "1" ? value : value + " " + unit;
}

/// "0.0189", "none found", "-".
std::string shown_holding(const Limit& l, const HeldSteps& held) {
  const auto found = held.longest.find({l.model, l.algorithm});
  return found == held.longest.end() ? "-"
         : found->second == 0        ? "none found"
                                     : format_significant(found->second, 3);
}

std::string shown_at_frames(const Limit& l, const HeldSteps& held) {
  const auto found = held.stable_at_frames.find({l.model, l.algorithm});
  return found == held.stable_at_frames.end() ? "-"
         : std::isinf(found->second)          ? "every frame"
         : found->second == 0                 ? "none"
                                              : format_significant(found->second, 3);
}

std::vector<std::string> header(const Stability& s, const HeldSteps& held) {
  const std::string unit = " [" + s.time_unit + "]";
  std::vector<std::string> all{
      "model",       "algorithm",        "stable to" + unit,     "theory" + unit, "unstable in theory" + unit,
      "error there", "needed to" + unit, "how it breaks beyond", "cure there"};
  if (!held.asked.empty()) all.insert(all.end() - 2, "holds to" + unit);
  if (!held.frames.empty()) all.insert(all.begin() + 3, "at these frames to" + unit);
  return all;
}

std::string error_of(const std::optional<TimedTrial>& t, const std::string& unit) {
  return t ? in_unit(shown_error(t->error), unit) : "-";
}

std::vector<std::string> limit_cells(const Stability& s, const HeldSteps& held, const Limit& l) {
  std::vector<std::string> all{l.model,
                               l.algorithm,
                               shown_step(l),
                               shown_theory(l),
                               shown_tongues(l),
                               error_of(l.at, s.unit),
                               l.within ? format_significant(l.within->setting, 3) : "none found",
                               how_it_breaks(l, s),
                               shown_cure(l, s.unit)};
  if (!held.asked.empty()) all.insert(all.end() - 2, shown_holding(l, held));
  if (!held.frames.empty()) all.insert(all.begin() + 3, shown_at_frames(l, held));
  return all;
}

/// The limits as columns, each model's below its name.
std::string limits_text(const Stability& s, const HeldSteps& held, const Screen& screen) {
  const auto names = header(s, held);
  std::vector<std::vector<std::string>> rows{{names.begin() + 1, names.end()}};
  const std::string* model = nullptr;
  for (const Limit& l : s.limits) {
    if (!model || *model != l.model) rows.push_back({screen.styled(Style::heading, l.model) + ":"});
    model = &l.model;
    const auto cells = limit_cells(s, held, l);
    rows.emplace_back(cells.begin() + 1, cells.end());
    rows.back().front().insert(0, "  ");
  }
  const std::vector<std::string>& n = rows.front();
  const std::string &how = *(n.end() - 2), &cure = n.back();
  const std::size_t theory = held.frames.empty() ? 2 : 3;  // behind the measured columns
  return aligned(rows, screen, {{n[0], how, cure}, {cure, how, n[theory + 1], n[theory], n[theory + 2]}});
}

/// Reasons why theory and measurement differ, each with the methods concerned.
std::vector<std::pair<std::string, std::string>> reasons(const Stability& s) {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Limit& l : s.limits) {
    if (l.why.empty()) continue;
    const std::string name =
        l.model + ", " + l.algorithm + (l.evidence.empty() ? "" : " (" + l.evidence + ")");
    const auto same = std::ranges::find(all, l.why, &std::pair<std::string, std::string>::first);
    if (same == all.end())
      all.emplace_back(l.why, name);
    else
      same->second += "; " + name;
  }
  return all;
}

/// A sentence for each limit that is not sharp, or that holds only for the time shown.
std::vector<std::string> reservations(const Stability& s) {
  std::vector<std::string> all;
  for (const Limit& l : s.limits) {
    const std::string name = l.model + ", " + l.algorithm + ": ", unit = " " + s.time_unit;
    if (l.soft)
      all.push_back(name + "no sharp limit" +
                    (l.unstable > 0 ? ", at " + format_significant(l.unstable, 3) + unit +
                                          " it is lost after " + format_significant(l.lost, 2) + unit
                                    : "") +
                    "; for other observers it is " + shown_soft(*l.soft) + unit);
    if (!l.goes_on && !std::isinf(l.step()))
      all.push_back(name + "the motion does not continue in the same way; it is watched for the " +
                    format_significant(l.watched, 3) + unit + " shown, and the limit applies to that time");
  }
  return all;
}

/// Explains the column of varying frames.
std::string frames_text(const HeldSteps& held) {
  if (held.frames.empty()) return "";
  return "at these frames: " + held.frames +
         ", one step each; the column shows the usual frame, and the longest is " +
         format_significant(held.longest_frame, 3) +
         " times as long. A limit further below that of equal steps than the longest frame explains is a "
         "resonance, excited by varying frames. An accumulator keeps the limit of equal steps. Multistep methods "
         "are left out, as a frame of another length makes them begin without their history; ";
}

/// The letters with a bar where theory's limit is: "XXd|ddiioooo".
std::string letters_and_theory(const MapRow& row, const std::vector<double>& steps) {
  std::string text = letters(row);
  if (std::isinf(row.theory)) return "|" + text;
  const auto above = std::ranges::count_if(steps, [&](double step) { return step > row.theory; });
  return text.insert(static_cast<std::size_t>(above), "|");
}

/// The cells that rounding errors decide, in a sentence; empty without such cells.
std::string fragile_text(const Stability& s) {
  std::string cells;
  for (const MapRow& row : s.map)
    for (std::size_t k = 0; k < row.fragile.size(); ++k)
      if (row.fragile[k])
        cells += (cells.empty() ? "" : "; ") + row.model + ", " + row.algorithm + " at " +
                 in_unit(format_significant(row.value, 4), s.parameter_unit) + ", step " +
                 in_unit(format_significant(s.steps[k], 3), s.time_unit);
  return cells.empty() ? "" : "\nA few roundings at the start decide how these end: " + cells + ".\n";
}

std::string map_text(const Stability& s, const Screen& screen) {
  std::string text = "\nmap: each letter a step, from " + format_significant(s.steps.front(), 3) + " " +
                     s.time_unit + ", halved and halved again, to " + format_significant(s.steps.back(), 3) +
                     " " + s.time_unit + "; the bar is theory's limit\n ";
  for (Outcome outcome : outcomes_of_a_map)
    text += " " + std::string(1, letter_of(outcome)) + " " + std::string(name_of(outcome));
  std::vector<std::vector<std::string>> rows{{"model", "algorithm", s.parameter, "steps"}};
  const MapRow* last = nullptr;
  for (const MapRow& row : s.map) {
    const bool first = !last || last->model != row.model || last->algorithm != row.algorithm;
    last = &row;
    rows.push_back({first ? row.model : "", first ? row.algorithm : "",
                    in_unit(format_significant(row.value, 4), s.parameter_unit),
                    letters_and_theory(row, s.steps)});
  }
  return wrapped(text + "\n", screen, 4) + aligned(rows, screen, {{"model", "algorithm"}, {}, true}) +
         wrapped(fragile_text(s), screen, 4);
}

/// "0.676 (0.639)": measured, with theory's limit in brackets if it differs. "~" marks a limit that is not
/// sharp, "≥" a lower bound.
std::string limit_text(const Limit& l) {
  const std::string measured = std::isinf(l.step()) ? "every step"
                               : l.stable == 0      ? "none"
                                                    : format_significant(l.stable, 3);
  const std::string theory = std::isinf(l.theory()) ? "every step"
                             : l.theory() == 0      ? "none"
                                                    : format_significant(l.theory(), 3);
  const std::string sign = l.stable == 0 || std::isinf(l.step()) ? ""
                           : l.soft                              ? "\\~"
                           : l.unstable > 0                      ? ""
                                                                 : "≥";
  return with_powers(sign + measured + (theory == measured ? "" : " (" + theory + ")"));
}

/// The limit, the error there, and the longest step that is good enough, on separate lines.
std::string limit_lines(const Limit& l) {
  return limit_text(l) + (l.at ? "<br>error " + with_powers(shown_error(l.at->error)) : "") +
         (l.within ? "<br>good to " + with_powers(format_significant(l.within->setting, 3))
                   : "<br>good nowhere");
}

/// A row per model, a column per algorithm.
std::string limits_table(const Stability& s) {
  std::vector<std::string> algorithms, models;
  const auto see = [](std::vector<std::string>& names, const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const Limit& l : s.limits) see(algorithms, l.algorithm), see(models, l.model);
  std::vector<std::string> columns{"model"};
  for (const std::string& algorithm : algorithms) columns.push_back(escaped(algorithm));
  std::vector<std::vector<std::string>> rows;
  for (const std::string& model : models) {
    rows.push_back({escaped(model)});
    for (const std::string& algorithm : algorithms) {
      const auto found = std::ranges::find_if(
          s.limits, [&](const Limit& l) { return l.model == model && l.algorithm == algorithm; });
      rows.back().push_back(found == s.limits.end() ? "" : limit_lines(*found));
    }
  }
  return table(columns, rows);
}

/// A game's tolerance, "0.0175 rad"; in words if there are several units.
std::string game_need(const Stability& s) {
  if (s.unit.find(',') != std::string::npos) return "one centimetre and one degree";
  return in_unit(with_powers(format_significant(s.close, 3)), typeset_unit(s.unit));
}

std::string stability_of_scene(const ExerciseResult& e) {
  const Stability& s = *e.stability;
  std::string text = "## " + to_string(e.number) + " " + escaped(e.title, false) +
                     "\n\n![how each method ends](" + map_file(e) + ")\n\nLongest stable step \\[" +
                     escaped(s.time_unit, false) + "\\]; good to " + escaped(game_need(s), false) + ":\n\n" +
                     limits_table(s);
  for (const auto& [reason, names] : reasons(s)) text += "- " + escaped(names + ": " + reason, false) + ".\n";
  return text + (reasons(s).empty() ? "" : "\n");
}

/// Counts the limits that are not sharp, that differ from theory, and that are not explained.
std::string differences(const Results& results) {
  long all = 0, slow = 0, differ = 0, open = 0;
  for (const ExerciseResult& e : results.exercises)
    if (e.stability)
      for (const Limit& l : e.stability->limits) {
        ++all;
        slow += l.soft ? 1 : 0;
        differ += l.soft || l.why.empty() ? 0 : 1;
        open += l.why == not_explained ? 1 : 0;
      }
  return "Of " + std::to_string(all) + " limits " + std::to_string(slow) + " are not sharp; of the others " +
         std::to_string(differ) + " differ from theory by more than a quarter, and " + std::to_string(open) +
         " differences are not explained by anything computed here.\n\n";
}

}  // namespace

std::string shown_step(const Limit& l) {
  if (std::isinf(l.step())) return "every step";
  if (l.stable == 0) return "none";
  return (l.unstable > 0 ? "" : "at least ") + format_significant(l.stable, 3) +
         (l.soft ? ", not sharp" : "");
}

std::string how_it_breaks(const Limit& l, const Stability& s) {
  if (!l.broken) return "";
  const TimedTrial& t = *l.broken;
  const std::string unit = " " + s.time_unit;
  return "at " + format_significant(l.unstable, 3) + unit +
         (l.outgrown ? " the motion is twice its true size after "
                     : " neighbouring motions have parted after ") +
         format_significant(l.lost, 2) + unit + "; the motion at " + format_significant(t.setting, 3) + unit +
         ": " + beyond(l) + ", " +
         (t.message.empty() ? "error " + in_unit(shown_error(t.error), s.unit) : t.message);
}

std::string shown_cure(const Limit& l, const std::string& unit) {
  if (!l.cure) return l.broken ? "none found" : "";
  const TimedTrial& t = *l.cure;
  return (t.model == l.model ? "" : t.model + ", ") + t.algorithm +
         (t.setting == l.broken->setting ? "" : ", " + shown_resolution(t)) + ": error " +
         in_unit(shown_error(t.error), unit) + ", " + std::to_string(t.evaluations) + " evaluations";
}

std::string stability_text(const ExerciseResult& e, const Screen& screen) {
  return stability_text(e, HeldSteps(), screen);
}

std::string stability_text(const ExerciseResult& e, const HeldSteps& held, const Screen& screen) {
  const Stability& s = *e.stability;
  std::string notes;
  for (const auto& [reason, names] : reasons(s)) notes += "\n  " + names + ": " + reason + "\n";
  for (const std::string& line : reservations(s)) notes += "\n  " + line + "\n";
  const std::string asked =
      s.quantity + " over " + format_significant(s.horizon, 4) + " " + s.time_unit + "; needed to " +
      in_unit(format_significant(s.close, 3), s.unit) + " at the end of every step; " +
      (held.asked.empty() ? "" : "holds: " + held.asked + "; ") + frames_text(held) +
      "breaks and cures are judged at " + format_significant(s.horizon / s.steps.front(), 4) + " times\n\n";
  return heading_of(e, screen) + wrapped(asked, screen) + limits_text(s, held, screen) +
         wrapped(notes, screen, 4) + map_text(s, screen);
}

std::string stability_page(const Results& results) {
  std::string text =
      "# Up to which step methods are stable\n\n"
      "A step is stable when two conditions are met. A small disturbance of the motion does not grow or, where it "
      "grows in truth, grows at most twice as fast. The motion does not become twice as large as the true one. "
      "Stable does not mean accurate. *None*: not even a step of 0.02 over the "
      "fastest frequency is stable. On an undamped oscillation, such as a pendulum, explicit Euler is unconditionally unstable: "
      "disturbances grow at the rate $`h\\omega^2/2`$ however short the step $`h`$. A limit after \\~ is not "
      "sharp. It moves by more than 5 % when the motion is watched for half or twice the time, or is called "
      "too large at another size. The step after ≥ is the longest that was tried.\n\n"
      "The limit is measured with the method itself, from two starts that differ by a millionth of the motion's "
      "size. They are watched for 1000 radians of the fastest mode or, if the motion does not continue in the same "
      "way, for its own time. Theory's limit, in brackets, is the shortest step at which disturbances grow by the "
      "eigenvalues of the Jacobian along the motion. If the two differ by more than a quarter, the reason "
      "is below the table. The maps show how each method ends over the step and over the parameter that "
      "makes the scene hard. A cell with a corner ends otherwise if the start is a few roundings off. Below "
      "a limit is the largest error at the end of any of its steps. *Good to*: up to this step all are "
      "within a game's tolerance at the end of every step, one centimetre or one degree; *good nowhere*: "
      "none that was tried is. `oddity stability` prints how each method breaks, and its cure.\n\n";
  text += differences(results);
  for (const ExerciseResult& e : results.exercises)
    if (e.stability) text += stability_of_scene(e);
  return text + "[All exercises](README.md)\n";
}

std::string map_file(const ExerciseResult& e) { return "charts/" + to_string(e.number) + "_stability.svg"; }

}  // namespace oddity
