#pragma once

#include <string>

#include "reference/proofs.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// What is wrong: each finding with the printed and the right version side by side, its consequence and why;
/// then the misprints, and what is unsettled. Empty when nothing is.
std::string findings_section(const ExerciseResult&, const ProvedClaims& = {});
/// What is confirmed, and what cannot be checked, each with what was compared with what.
std::string claims_section(const ExerciseResult&, const ProvedClaims& = {});
/// The id of a claim in its exercise's page.
std::string claim_anchor_of(const Claim&);

}  // namespace oddity
