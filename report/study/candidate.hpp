#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "report/study/initial_conditions.hpp"

namespace oddity {

/// Settings to try for a need, from cheap to expensive: whole numbers of steps per frame, tolerances by
/// decades, or the method's own.
std::vector<double> settings(const Method&, const Need&);

/// Evaluates a method at a setting over the starts. Gives its worst error by the need's criterion, its work
/// on the first start, and, if it fails, the worst outcome and its start. Does not measure the time. Throws
/// BadInput if the criterion does not fit the motion.
Candidate evaluate(std::span<const Start>, const Method&, double setting, const Need&);

/// Starts in the order in which to try them.
using Order = std::vector<const Start*>;
/// The starts whose `says` is in `first`, in that order, then the others.
Order in_order(std::span<const Start>, std::span<const std::string> first);

/// As `evaluate`, but stops at the first start that fails. Tries the first start alone and the others in
/// parallel. Its work is that on the first start. No start may take more than `most_evaluations`.
Candidate evaluate_until_one_fails(const Order&, const Method&, double setting, const Need&,
                                   double most_evaluations = std::numeric_limits<double>::infinity());

/// Completes a candidate that was left at the start on which it failed.
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
