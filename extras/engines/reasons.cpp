// Why an engine does not converge to a scene.

#include <algorithm>
#include <cmath>

#include "extras/engines/contest.hpp"

namespace oddity {

namespace {

double finest(const EngineSeries& s) { return s.trials.back().in_needs; }

bool errs_less(const EngineSeries& a, const EngineSeries& b) {
  return a.cannot.empty() && finest(a) < 0.75 * finest(b);
}

/// Whether another variant of the engine without this one's lasting errors does better; nullopt if there is
/// no such variant.
std::optional<bool> better_without(const EngineContest& contest, const EngineSeries& s) {
  std::optional<bool> better;
  for (const EngineSeries& other : contest.series)
    if (other.engine == s.engine && other.webassembly == s.webassembly && other.lasting.empty())
      better = better.value_or(false) || errs_less(other, s);
  return better;
}

bool still_falls(const EngineSeries& s) {
  const std::size_t n = s.trials.size();
  return n > 1 && finest(s) < 0.75 * s.trials[n - 2].in_needs && finest(s) == s.floor;
}

bool is_rounding(const EngineContest& contest, const EngineSeries& s) {
  if (s.precision != "float") return false;
  return finest(s) > 1.5 * s.floor || std::ranges::any_of(contest.series, [&](const EngineSeries& other) {
           return other.engine == s.engine + " in double" && other.variant == s.variant &&
                  errs_less(other, s);
         });
}

}  // namespace

std::string why_never(const EngineContest& contest, const EngineSeries& s) {
  if (s.trials.back().outcome == Outcome::stalled) return "";
  if (!std::isfinite(finest(s))) return std::string(name_of(s.trials.back().outcome));
  if (!contest.differs.empty()) return "not the same scene";
  const std::optional<bool> better = better_without(contest, s);
  if (!s.lasting.empty() && better == true) return s.lasting;
  if (still_falls(s)) return "";
  if (contest.rubs && !s.friction.empty()) return s.friction;
  if (is_rounding(contest, s)) return "rounding in float";
  if (!s.lasting.empty() && !better) return s.lasting;
  return s.trials.size() > 1 ? "not explained" : "";  // a single rate does not show whether errors fall
}

}  // namespace oddity
