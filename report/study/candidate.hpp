#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/study/initial_conditions.hpp"

namespace oddity {

/// The settings at which a method is tried for a need, from cheap to dear: whole numbers of steps per frame,
/// tolerances by decades, or the method's own.
std::vector<double> settings(const Method&, const Need&);

/// A search needs to know of a setting that fails no more than that; who shows its error, the worst of all.
enum class Over { all_starts, until_one_fails };

/// The method at a setting over the starts: its worst error by the need's criterion, how and on which start
/// it ended worst where it does not hold, and its work on the first start. The time is not measured. Throws
/// BadInput where the criterion does not fit the motion.
Candidate evaluate(std::span<const Start>, const Method&, double setting, const Need&,
                   Over = Over::all_starts);

/// "2 steps per frame", "tolerance 1e-06", "-".
std::string shown_setting(const Candidate&, const Need&);

/// Refinement is pointless: the method cannot run here, or costs far too much.
bool hopeless(const Candidate&);

}  // namespace oddity
