#include "extras/engines/tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "extras/engines/contest.hpp"
#include "extras/engines/labels.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/text/numbers.hpp"

namespace oddity {

namespace {

/// "29 % in energy", "0.01 m in the constraint".
std::string in_words(Criterion criterion, double off) {
  const std::string part = std::isfinite(off) ? two_digits(100 * off) + " %" : "an unknown part";
  switch (criterion) {
    case Criterion::energy:
      return part + " in energy";
    case Criterion::period:
      return part + " in period";
    case Criterion::constraint:
      return two_digits(off) + " m in the constraint";
    case Criterion::bounded:
      return two_digits(10 * off) + " times the true motion's size";
    default:
      return two_digits(off) + " needs";
  }
}

}  // namespace

std::string error_text(const std::vector<double>& errors, const std::map<Criterion, double>& by,
                       const EngineContest& contest) {
  std::string text;
  for (const auto& [criterion, allowed] : contest.criteria)
    text += (text.empty() ? "" : " and ") + (criterion == Criterion::path
                                                 ? pictured(errors, contest.units)
                                                 : in_words(criterion, by.at(criterion)));
  return text;
}

namespace {

const EngineTrial* at_rate(const EngineSeries& series, double rate, double frames_per_second) {
  for (const EngineTrial& t : series.trials)
    if (std::abs(t.steps_per_frame * frames_per_second - rate) < 1e-9 * rate) return &t;
  return nullptr;
}

std::string shown(const EngineTrial* trial, const EngineContest& contest) {
  if (trial == nullptr) return "";
  if (trial->outcome == Outcome::ok || trial->outcome == Outcome::inaccurate)
    return error_text(trial->errors, trial->by, contest);
  return std::string(name_of(trial->outcome));
}

/// The rate, or why none is known to be sufficient.
std::string enough_from(const EngineSeries& series, const EngineContest& contest) {
  const auto rate = [&](const EngineTrial& t) {
    return format_significant(t.steps_per_frame * contest.frames_per_second, 6) + " Hz";
  };
  if (const EngineTrial* first = series.first_enough()) return rate(*first);
  const std::string why = why_never(contest, series);
  const EngineTrial& finest = series.trials.back();
  if (finest.outcome == Outcome::stalled) return "not below " + rate(finest) + ", which takes too long";
  return why.empty() ? "beyond " + rate(finest) : "never: " + why;
}

std::string order_of(const EngineSeries& series) {
  const std::string stated = series.stated_order > 0 ? " (" + std::to_string(series.stated_order) + ")" : "";
  return (series.law ? format_significant(series.law->exponent, 2) : "-") + stated;
}

/// The coarsest sufficient trial, else the coarsest.
const EngineTrial* priced(const EngineSeries& series) {
  if (const EngineTrial* first = series.first_enough()) return first;
  return series.trials.empty() ? nullptr : &series.trials.front();
}

std::string cheaper(const EngineSeries& series, const EngineContest& contest) {
  const EngineTrial* first = series.first_enough();
  if (!contest.least || first == nullptr || series.webassembly) return "";
  return two_digits(first->seconds_per_frame / contest.least->seconds_per_frame) + "x";
}

/// Whether someone who looks for accuracy would prefer a to b.
bool better(const EngineSeries& a, const EngineSeries& b) {
  const auto steps = [](const EngineSeries& s) {
    const EngineTrial* first = s.first_enough();
    return first ? first->steps_per_frame : std::numeric_limits<int>::max();
  };
  if (steps(a) != steps(b)) return steps(a) < steps(b);
  return a.trials.front().in_needs < b.trials.front().in_needs / 2;
}

/// Each engine's defaults, and its best variant where that is better; or all.
std::vector<const EngineSeries*> shown_of(const EngineContest& contest, bool all) {
  std::vector<const EngineSeries*> shown;
  for (const EngineSeries& s : contest.series) {
    if (!s.cannot.empty()) continue;
    const bool same_engine = !shown.empty() && shown.back()->engine == s.engine;
    if (all || !same_engine)
      shown.push_back(&s);
    else if (!shown.back()->defaults && better(s, *shown.back()))
      shown.back() = &s;
    else if (shown.back()->defaults && better(s, *shown.back()))
      shown.push_back(&s);
  }
  return shown;
}

}  // namespace

std::vector<std::vector<std::string>> rows_of(const EngineContest& contest, const std::vector<double>& rates,
                                              bool all) {
  std::vector<std::vector<std::string>> rows{{"engine", "numbers"}};
  for (double rate : rates) rows[0].push_back("at " + format_significant(rate, 6) + " Hz");
  for (const char* head : {"enough from", "order (stated)", "least error", "energy %", "momentum %",
                           "joints off", "a frame", "costs"})
    rows[0].emplace_back(head);
  for (const EngineSeries* series : shown_of(contest, all)) {
    const EngineSeries& s = *series;
    std::vector<std::string> row{full_name(s), s.precision};
    for (double rate : rates) row.push_back(shown(at_rate(s, rate, contest.frames_per_second), contest));
    const EngineTrial* trial = priced(s);
    const EngineTrial* first = at_rate(s, contest.frames_per_second, contest.frames_per_second);
    row.push_back(enough_from(s, contest));
    row.push_back(order_of(s));
    row.push_back(two_digits(s.floor) + " needs");
    row.push_back(first ? in_percent(first->energy) : "");
    row.push_back(first ? in_percent(first->momentum) : "");
    row.push_back(first && first->off_joint > 0 ? two_digits(1000 * first->off_joint) + " mm" : "");
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
  std::map<Criterion, double> allowed;
  for (const auto& [criterion, error] : contest.criteria) allowed[criterion] = error;
  return "Worst error over " + format_significant(contest.horizon, 6) + " s at every frame; enough is " +
         error_text(contest.needs, allowed, contest) + ".";
}

std::string least_text(const EngineContest& contest) {
  if (!contest.least) return "";
  return "Instead: " + contest.least->says + ", which errs by " +
         error_text(contest.least->errors, contest.least->by, contest) + " for " +
         shown_time(contest.least->seconds_per_frame) + " a frame.";
}

}  // namespace oddity
