#include "report/pages/engines_view.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "reference/text.hpp"
#include "report/pages/markup.hpp"
#include "report/pages/text_view.hpp"

namespace oddity {

namespace {

/// "3.4 cm", "0.12 deg": of errors in the motion's units, what a reader can picture.
std::string pictured(double error, const std::string& unit) {
  if (!std::isfinite(error)) return "-";
  if (unit == "m") return rounded(100 * error, 2) + " cm";
  if (unit == "rad") return rounded(180 / std::numbers::pi * error, 2) + " deg";
  return rounded(error, 2) + " " + unit;
}

std::string pictured(const std::vector<double>& errors, const std::vector<std::string>& units) {
  std::string text;
  for (std::size_t i = 0; i < errors.size(); ++i)
    text += (i == 0 ? "" : ", ") + pictured(errors[i], units[i]);
  return text;
}

const EngineTrial* at_rate(const EngineSeries& series, double rate, double frames_per_second) {
  for (const EngineTrial& t : series.trials)
    if (std::abs(t.steps_per_frame * frames_per_second - rate) < 1e-9 * rate) return &t;
  return nullptr;
}

std::string shown(const EngineTrial* trial, const EngineContest& contest) {
  if (trial == nullptr) return "";
  if (trial->outcome == Outcome::ok || trial->outcome == Outcome::inaccurate)
    return pictured(trial->errors, contest.units);
  return std::string(name_of(trial->outcome));
}

std::string enough_from(const EngineSeries& series, const EngineContest& contest) {
  const EngineTrial* first = series.first_enough();
  return first == nullptr ? "never" : rounded(first->steps_per_frame * contest.frames_per_second, 6) + " Hz";
}

std::string order_of(const EngineSeries& series) {
  const std::string stated = series.stated_order > 0 ? " (" + std::to_string(series.stated_order) + ")" : "";
  return (series.law ? rounded(series.law->exponent, 2) : "-") + stated;
}

/// Of the coarsest trial that is enough, else of the coarsest.
const EngineTrial* priced(const EngineSeries& series) {
  if (const EngineTrial* first = series.first_enough()) return first;
  return series.trials.empty() ? nullptr : &series.trials.front();
}

std::string cheaper(const EngineSeries& series, const EngineContest& contest) {
  const EngineTrial* first = series.first_enough();
  if (!contest.least || first == nullptr || series.webassembly) return "";
  return rounded(first->seconds_per_frame / contest.least->seconds_per_frame, 2) + "x";
}

std::string name_of(const EngineSeries& s) {
  return s.engine + (s.variant == "defaults" ? "" : ", " + s.variant) + (s.webassembly ? " *" : "");
}

std::vector<std::vector<std::string>> rows_of(const EngineContest& contest,
                                              const std::vector<double>& rates) {
  std::vector<std::vector<std::string>> rows{{"engine", "numbers"}};
  for (double rate : rates) rows[0].push_back("at " + rounded(rate, 6) + " Hz");
  for (const char* head :
       {"enough from", "order (stated)", "least error", "energy", "joints off", "a frame", "costs"})
    rows[0].emplace_back(head);
  for (const EngineSeries& s : contest.series) {
    if (!s.cannot.empty()) continue;
    std::vector<std::string> row{name_of(s), s.precision};
    for (double rate : rates) row.push_back(shown(at_rate(s, rate, contest.frames_per_second), contest));
    const EngineTrial* trial = priced(s);
    const EngineTrial* first = at_rate(s, contest.frames_per_second, contest.frames_per_second);
    row.push_back(enough_from(s, contest));
    row.push_back(order_of(s));
    row.push_back(rounded(s.floor, 2) + " needs");
    row.push_back(first && std::isfinite(first->energy) ? rounded(100 * first->energy, 2) + " %" : "");
    row.push_back(first && first->off_joint > 0 ? rounded(1000 * first->off_joint, 2) + " mm" : "");
    row.push_back(trial ? shown_time(trial->seconds_per_frame) : "");
    row.push_back(cheaper(s, contest));
    rows.push_back(std::move(row));
  }
  return rows;
}

/// "ODE: no joint that ...; Box2D, Chipmunk: ...".
std::string cannot_text(const EngineContest& contest) {
  std::map<std::string, std::vector<std::string>> engines;
  for (const EngineSeries& s : contest.series) {
    auto& names = engines[s.cannot];
    if (!s.cannot.empty() && (names.empty() || names.back() != s.engine)) names.push_back(s.engine);
  }
  std::string text;
  for (const auto& [reason, names] : engines) {
    if (reason.empty()) continue;
    text += text.empty() ? "" : "; ";
    for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ", ") + names[i];
    text += ": " + reason;
  }
  return text;
}

std::string need_text(const EngineContest& contest) {
  return "Worst error over " + rounded(contest.horizon, 6) + " s at every frame; enough is " +
         pictured(contest.needs, contest.units) + ".";
}

std::string least_text(const EngineContest& contest) {
  if (!contest.least) return "";
  return "Instead: " + contest.least->says + ", which errs by " +
         pictured(contest.least->errors, contest.units) + " for " +
         shown_time(contest.least->seconds_per_frame) + " a frame.";
}

}  // namespace

std::string engines_text(const std::vector<EngineContest>& contests, const std::vector<double>& rates,
                         const Screen& screen) {
  std::string text;
  for (const EngineContest& contest : contests) {
    text += screen.styled(Style::heading, contest.scene + "  " + contest.title) + "\n";
    text += wrapped("  " + need_text(contest) + "\n", screen, 2);
    text += aligned(rows_of(contest, rates), screen,
                    {.shorten = {"engine"}, .leave_out = {"joints off", "numbers", "energy", "least error"}});
    if (contest.least) text += wrapped("  " + least_text(contest) + "\n", screen, 2);
    if (const std::string cannot = cannot_text(contest); !cannot.empty())
      text += wrapped("  Not to be had by " + cannot + ".\n", screen, 2);
    text += "\n";
  }
  return text + "  * behind WebAssembly: its times are not those of a native program\n";
}

Table engines_table(const std::vector<EngineContest>& contests) {
  Table table{
      {"scene", "engine", "version", "precision", "variant", "webassembly", "hz", "outcome", "error", "unit",
       "in_needs", "energy", "off_joint", "seconds_per_frame", "spread", "same_bits", "restored"},
      {}};
  for (const EngineContest& c : contests)
    for (const EngineSeries& s : c.series)
      for (const EngineTrial& t : s.trials)
        for (std::size_t i = 0; i < c.units.size(); ++i)
          table.rows.push_back({c.scene, s.engine, s.version, s.precision, s.variant, long(s.webassembly),
                                t.steps_per_frame * c.frames_per_second, std::string(name_of(t.outcome)),
                                t.errors.empty() ? NAN : t.errors[i], c.units[i], t.in_needs, t.energy,
                                t.off_joint, t.seconds_per_frame, t.spread, long(t.same_bits), t.restored});
  return table;
}

}  // namespace oddity
