#pragma once

#include <string>
#include <vector>

#include "chapters/exercise.hpp"
#include "report/study/need.hpp"

/// The criteria of a choice: errors of a motion, judged by its observables only. All models are judged in the
/// same way.
namespace oddity {

/// The energy of a true motion. A table has places but no rates, so methods compute it. The algorithm whose
/// path stays nearest to the truth gives the energy, and its difference from that of the next bounds the
/// error.
struct TrueEnergy {
  std::vector<double> whole;  ///< at each time judged
  double moves = 0;           ///< the largest kinetic part
  double known_to = 0;        ///< relative to `moves`
};
/// Throws BadInput if the scene states no energy, or fewer than two algorithms reach the end.
TrueEnergy true_energy(const Quantity& motion);

/// Whether the criterion, alone or as another one of the need, looks at energies.
bool needs_energy(const Need&);

/// Error of a motion by one criterion; infinite if it does not show that quantity.
struct Off {
  double error;          ///< path: in needs; energy and period: relative; constraint: in m
  std::string why = {};  ///< "its swing is 2.2 times the true one in the end"; empty: the error is the reason
};
/// Error by a criterion. Path: each observable's distance from the truth, in needs. Energy: the largest
/// deviation from its true value, relative to the largest moving part. Period: of the first observable's
/// upward passages through its true mean, if the swing stays as large as the true one to a tenth. Constraint:
/// the largest deviation of the observables, or of the model's redundant coordinates, from their constraints.
/// Bounded: the motion's size over ten times the true one. Throws BadInput if the true motion has no period.
Off off_by(Criterion, const Quantity& motion, const Method&, const Trial&, const std::vector<double>& errors,
           const TrueEnergy*);

/// As `off_by`, if only the observables are known: all criteria except the energy, which is infinite.
Off off_by_observed(Criterion, const Quantity& motion, const Value& observed,
                    const std::vector<double>& errors);

/// The true motion's first observable passes upward through its mean at least twice.
bool has_period(const Quantity& motion);

/// The requested criteria, the main one first.
std::vector<Criterion> criteria_of(const Need&);

/// The motion has the quantity that the criterion needs, and the method shows it.
bool can_be_judged(Criterion, const Quantity& motion, const Method&);

/// Errors by the criterion up to this are roundings of the observables, and count as zero.
double rounding_of(Criterion, const Quantity& motion);

}  // namespace oddity
