#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/study/criterion.hpp"

/// Error of a motion by all criteria of a need.
namespace oddity {

struct OffByNeed {
  double error = 0;                     ///< in needs, by the worst criterion
  std::map<Criterion, double> by = {};  ///< by each criterion except path, in its own unit
  std::string why = {};                 ///< reason for the first failure, if the error does not show it
};
/// `errors` are those of the path. Throws as for one criterion.
OffByNeed off_by(const Need&, const Quantity& motion, const Method&, const Trial&,
                 const std::vector<double>& errors, const TrueEnergy*);

/// True if every criterion of the need can be judged.
bool can_be_judged(const Need&, const Quantity& motion, const Method&);

/// Throws BadInput if a constraint is asked for, and neither the observables nor any method has one.
void require_constraint(const Need&, const Quantity& motion, const std::vector<const Method*>&);

}  // namespace oddity
