#pragma once

#include <string>

#include "reference/proofs.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// What is wrong: each finding with the printed and the right version side by side, its consequence and why;
/// then the misprints, and what is unsettled; apart from these what our copy of the manual has lost. Empty
/// when there is none.
std::string findings_section(const ExerciseResult&, const ProvedClaims& = {});
/// What is confirmed, and what cannot be checked, each with what was compared with what.
std::string claims_section(const ExerciseResult&, const ProvedClaims& = {});
/// The class of what is shown of a verdict: "wrong", "lost-in-our-copy".
std::string class_of(Verdict);
/// The id of a claim in its exercise's page.
std::string claim_anchor_of(const Claim&);

}  // namespace oddity
