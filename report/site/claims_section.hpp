#pragma once

#include <string>

#include "reference/proofs.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// Errors: each finding with the printed and the right version side by side, its consequence and the reason.
/// Then misprints and unsettled claims; apart from these, losses in our copy of the manual. Empty if
/// nothing is to be shown.
std::string findings_section(const ExerciseResult&, const ProvedClaims& = {});
/// Confirmed and uncheckable claims, each with the comparison made.
std::string claims_section(const ExerciseResult&, const ProvedClaims& = {});
/// The CSS class of a verdict: "wrong", "lost-in-our-copy".
std::string class_of(Verdict);
/// The id of a claim on its exercise's page.
std::string claim_anchor_of(const Claim&);

}  // namespace oddity
