#include "extras/engines/view.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "extras/engines/contest.hpp"
#include "extras/engines/labels.hpp"
#include "extras/engines/tables.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/numbers.hpp"

namespace oddity {

std::string engines_text(const std::vector<EngineContest>& contests, const std::vector<double>& rates,
                         bool all, const Screen& screen) {
  if (contests.empty())
    return "nothing is kept of these scenes; '" + program_as_typed() + " engines' runs them\n";
  std::string text;
  for (const EngineContest& contest : contests) {
    text += screen.styled(Style::heading, contest.scene + "  " + contest.title) + "\n";
    text += wrapped("  " + need_text(contest) + "\n", screen, 2);
    text += aligned(rows_of(contest, rates, all), screen,
                    {.shorten = {"engine", "enough from"},
                     .leave_out = {"joints off", "numbers", "energy %", "momentum %", "least error"}});
    if (contest.least) text += wrapped("  " + least_text(contest) + "\n", screen, 2);
    if (const std::string cannot = cannot_text(contest); !cannot.empty())
      text += wrapped("  Not to be had by " + cannot + ".\n", screen, 2);
    if (!contest.differs.empty()) text += wrapped("  " + contest.differs + "\n", screen, 2);
    text += "\n";
  }
  return text + "  * behind WebAssembly: its times are not those of a native program\n";
}

namespace {

/// All criteria except the path.
std::set<Criterion> criteria_of(const std::vector<EngineContest>& contests) {
  std::set<Criterion> all;
  for (const EngineContest& c : contests)
    for (const auto& [criterion, allowed] : c.criteria) all.insert(criterion);
  all.erase(Criterion::path);
  return all;
}

}  // namespace

Table engines_table(const std::vector<EngineContest>& contests) {
  Table table{
      {"scene", "engine", "version", "precision", "variant", "webassembly", "hz", "outcome", "error", "unit",
       "in_needs", "energy", "momentum", "off_joint", "seconds_per_frame", "spread", "same_bits", "restored"},
      {}};
  const std::set<Criterion> criteria = criteria_of(contests);
  for (Criterion criterion : criteria)
    table.columns.push_back("off_" + std::string(criterion_names[static_cast<std::size_t>(criterion)]));
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      for (const EngineTrial& t : s.trials)
        for (std::size_t i = 0; i < c.units.size(); ++i) {
          table.rows.push_back({c.scene, s.engine, s.version, s.precision, s.variant, long(s.webassembly),
                                t.steps_per_frame * c.frames_per_second, std::string(name_of(t.outcome)),
                                t.errors.empty() ? NAN : t.errors[i], c.units[i], t.in_needs, t.energy,
                                t.momentum, t.off_joint, t.seconds_per_frame, t.spread, long(t.same_bits),
                                t.restored});
          for (Criterion criterion : criteria)
            table.rows.back().push_back(t.by.contains(criterion) ? t.by.at(criterion) : not_a_number);
        }
  return table;
}

namespace {

/// Text of a cell without quotes, for extras/engines/engines.sh.
std::string plain(std::string text) {
  std::ranges::replace(text, ',', ';');
  return text;
}

std::string on_record(double part) { return std::isfinite(part) ? format_significant(part, 2) : "-"; }

}  // namespace

std::string engine_rows(const std::vector<EngineContest>& contests) {
  Table table{{"scene", "engine", "version", "variant", "order", "stated", "enough_from", "at_frame_rate",
               "same_bits", "restored", "energy", "momentum", "off_joint"},
              {}};
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series) {
      if (s.trials.empty()) continue;
      const EngineTrial* enough = s.first_enough();
      const bool same = std::ranges::all_of(s.trials, &EngineTrial::same_bits);
      table.rows.push_back(
          {c.scene, plain(s.engine), plain(s.version), plain(s.variant),
           s.law ? format_significant(s.law->exponent, 2) : "-",
           s.stated_order > 0 ? std::to_string(s.stated_order) : "-",
           enough ? format_significant(enough->steps_per_frame * c.frames_per_second, 6) : "never",
           std::string(name_of(s.trials.front().outcome)), same ? "same" : "other", s.trials.front().restored,
           on_record(s.trials.front().energy), on_record(s.trials.front().momentum),
           on_record(s.trials.front().off_joint)});
    }
  return to_csv(table);
}

namespace {

std::string in_hertz(const EngineTrial& t, const EngineContest& contest) {
  return format_significant(t.steps_per_frame * contest.frames_per_second, 6) + " Hz";
}

/// "it errs by 3.2 deg", or how it ended instead.
std::string did(const EngineTrial& t, const EngineContest& contest) {
  switch (t.outcome) {
    case Outcome::ok:
    case Outcome::inaccurate:
      return "it errs by " + error_text(t.errors, t.by, contest);
    case Outcome::non_finite:
      return "its numbers are infinite or none before the motion ends";
    default:
      return "it gives no answer: " + t.message;
  }
}

/// "8 steps a frame bring 0.75 deg", or that none is sufficient, and why.
std::string with_more_steps(const EngineSeries& s, const EngineContest& contest) {
  if (const EngineTrial* enough = s.first_enough())
    return enough == &s.trials.front()
               ? ""
               : "; " + std::to_string(enough->steps_per_frame) + " steps a frame bring " +
                     error_text(enough->errors, enough->by, contest);
  const std::string why =
      s.trials.back().outcome == Outcome::stalled ? "these take too long" : why_never(contest, s);
  return "; no more steps make that enough, up to " + std::to_string(s.trials.back().steps_per_frame) +
         " a frame" + (why.empty() ? "" : ": " + why);
}

std::string variant_answer(const EngineContest& contest, const EngineSeries& s) {
  if (!s.cannot.empty()) return "not to be had: " + s.cannot + ".";
  const EngineTrial &coarsest = s.trials.front(), *enough = s.first_enough();
  std::string line =
      "at " + in_hertz(coarsest, contest) + " " + did(coarsest, contest) + with_more_steps(s, contest);
  const EngineTrial& paid = enough ? *enough : coarsest;
  if (!std::isfinite(paid.seconds_per_frame)) return line + ".";
  line += ", for " + shown_time(paid.seconds_per_frame) + " a frame";
  if (contest.least && enough && !s.webassembly)
    line += ", " + two_digits(paid.seconds_per_frame / contest.least->seconds_per_frame) +
            " times the cost of the choice above";
  return line + ".";
}

}  // namespace

std::string engine_answer(const EngineContest& contest, const Screen& screen) {
  std::string text;
  for (const EngineSeries& s : contest.series)
    text += wrapped("  on " + s.engine + " " + s.version + ", " + s.variant + " (" + s.precision +
                        "): " + variant_answer(contest, s) + "\n",
                    screen, 4);
  if (!contest.differs.empty()) text += wrapped("  " + contest.differs + "\n", screen, 4);
  return text;
}

}  // namespace oddity
