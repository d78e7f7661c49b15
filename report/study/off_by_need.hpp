#pragma once

#include <map>
#include <string>
#include <vector>

#include "report/study/criterion.hpp"

/// How far a motion is off by all criteria of a need at once.
namespace oddity {

struct OffByNeed {
  double error = 0;                     ///< in units of what was asked, by the criterion that is off most
  std::map<Criterion, double> by = {};  ///< by each but path, in its own unit
  std::string why = {};                 ///< of the first that fails, where the error does not say it
};
/// `errors` are those of the path. Throws as by one criterion.
OffByNeed off_by(const Need&, const Quantity& motion, const Method&, const Trial&,
                 const std::vector<double>& errors, const TrueEnergy*);

/// By every criterion of the need.
bool can_be_judged(const Need&, const Quantity& motion, const Method&);

/// Throws BadInput where a constraint is asked for, and neither what is seen nor one of the methods has any.
void require_constraint(const Need&, const Quantity& motion, const std::vector<const Method*>&);

}  // namespace oddity
