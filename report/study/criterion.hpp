#pragma once

#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "report/study/need.hpp"

/// The criteria of a choice: how far a motion is off, told by what is seen of it alone. Whatever model made
/// it is judged alike.
namespace oddity {

/// The energy of a true motion. A table has places and no rates, so that two algorithms that share no code
/// follow it: the one whose path keeps nearer to the truth has the energy, and the other bounds its error.
struct TrueEnergy {
  std::vector<double> whole;  ///< at each time looked at
  double moves = 0;           ///< the most of it that is kinetic
  double known_to = 0;        ///< as a part of that
};
/// Throws BadInput where the scene states no energy, or no two methods follow the motion to its end.
TrueEnergy true_energy(const Quantity& motion);

/// Whether the criterion, alone or as another one of the need, looks at energies.
bool needs_energy(const Need&);

/// How far a motion is off by one criterion: infinitely where it has no such.
struct Off {
  double error;          ///< of a path in needs; of energy and period a part; of a constraint m
  std::string why = {};  ///< "its swing is 2.2 times the true one in the end"; empty: the error says it
};
/// By a criterion, path, each observable's distance from the truth, in needs. Energy, the most that it is off
/// its true value, as a part of the most that moves. Period, that of the first observable's upward passages
/// through its true mean, where the swing stays as large as the true one to a tenth. Constraint, the most
/// that what is seen, or the model's redundant coordinates, are off what holds them. Bounded, the motion's
/// size as a part of ten times the true one. Throws BadInput where the true motion
/// has no period.
Off off_by(Criterion, const Quantity& motion, const Method&, const Trial&, const std::vector<double>& errors,
           const TrueEnergy*);

/// The same where the observables alone are known: all but the energy, which is infinite.
Off off_by_observed(Criterion, const Quantity& motion, const Value& observed,
                    const std::vector<double>& errors);

/// The true motion's first observable passes upward through its mean twice.
bool has_period(const Quantity& motion);

/// The criteria that are asked for, the main one first.
std::vector<Criterion> criteria_of(const Need&);

/// The motion has what the criterion looks at, and the method shows it.
bool can_be_judged(Criterion, const Quantity& motion, const Method&);

/// The criterion's error that counts as zero: roundings of what is seen.
double rounding_of(Criterion, const Quantity& motion);

}  // namespace oddity
