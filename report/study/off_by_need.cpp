#include "report/study/off_by_need.hpp"

#include <algorithm>

#include "reference/bad_input.hpp"

namespace oddity {

OffByNeed off_by(const Need& need, const Quantity& motion, const Method& method, const Trial& trial,
                 const std::vector<double>& errors, const TrueEnergy* energy) {
  OffByNeed all;
  for (Criterion criterion : criteria_of(need)) {
    const Off off = off_by(criterion, motion, method, trial, errors, energy);
    const double asked = need.error_by(criterion);
    all.error = std::max(all.error, off.error / asked);
    if (criterion != Criterion::path) all.by[criterion] = off.error;
    if (off.error > asked && all.why.empty()) all.why = off.why;
  }
  return all;
}

bool can_be_judged(const Need& need, const Quantity& motion, const Method& method) {
  return std::ranges::all_of(criteria_of(need),
                             [&](Criterion criterion) { return can_be_judged(criterion, motion, method); });
}

void require_constraint(const Need& need, const Quantity& motion, const std::vector<const Method*>& methods) {
  if (motion.off || std::ranges::count(criteria_of(need), Criterion::constraint) == 0) return;
  if (std::ranges::any_of(methods, [](const Method* m) { return static_cast<bool>(m->off_constraint); }))
    return;
  throw BadInput("no model " + std::string(need.only.empty() && need.exclude.empty() ? "here" : "left") +
                 " has a constraint to be off: all coordinates are free, or hold it by construction");
}

}  // namespace oddity
