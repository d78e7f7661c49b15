#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "report/study/initial_conditions.hpp"

namespace oddity {

/// The settings at which a method is tried for a need, from cheap to dear: whole numbers of steps per frame,
/// tolerances by decades, or the method's own.
std::vector<double> settings(const Method&, const Need&);

/// The method at a setting over the starts: its worst error by the need's criterion, how and on which start
/// it ended worst where it does not hold, and its work on the first start. The time is not measured. Throws
/// BadInput where the criterion does not fit the motion.
Candidate evaluate(std::span<const Start>, const Method&, double setting, const Need&);

/// Starts in the order in which they are to be tried.
using Order = std::vector<const Start*>;
/// Those that say this first, as they are named; then the others.
Order in_order(std::span<const Start>, std::span<const std::string> first);

/// The same, but no further than to the first start on which it fails, as a search needs to know no more: the
/// first is tried alone, the others in parallel. Its work is that on the first one, none may take more than
/// so many evaluations.
Candidate evaluate_until_one_fails(const Order&, const Method&, double setting, const Need&,
                                   double most_evaluations = std::numeric_limits<double>::infinity());

/// The same of a candidate that was left at the start on which it failed.
void go_through(std::span<const Start>, Candidate&, const Need&);

/// "2 steps per frame", "tolerance 1e-06", "-".
std::string shown_setting(const Candidate&, const Need&);

/// "at 60 frames per second, 1 % dropped".
std::string shown_rate(const Need&, std::string_view time_unit);
/// "10 s at 60 frames per second"; where the frames end elsewhere, how long is judged.
std::string shown_span(const Need&, std::string_view time_unit);

/// Refinement is pointless: the method cannot run here, or costs far too much.
bool hopeless(const Candidate&);

}  // namespace oddity
