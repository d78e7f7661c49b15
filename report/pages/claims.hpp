#pragma once

#include <map>
#include <string>
#include <vector>

#include "reference/proofs.hpp"
#include "report/study/findings.hpp"

/// What comes of the claims, as Markdown.
namespace oddity {

/// "2 wrong, 1 misprint, 12 confirmed", without those that there are none of.
std::string sentence(const Counts&);

/// Where a page's links lead: to pages beside it, or to places in the one page.
enum class Links { apart, within };
/// "3.5.md#3.5-value".
std::string address_of(const ExerciseResult&, const Claim&, Links);
std::string link_to(const ExerciseResult&, const Claim&, Links);

/// The verdict in a line, and each erratum in a row: printed, right, and what one would see.
std::string answer(const ExerciseResult&);
/// Everything wrong in full, each with its anchor, its reason and its numbers. What is proved says so.
std::string wrong_claims(const ExerciseResult&, const ProvedClaims&);
/// What is confirmed, folded up: a line a claim, with what it was compared with. What cannot be checked.
std::string other_claims(const ExerciseResult&, const ProvedClaims&);

/// Roots a row each: those of which a claim is wrong, or those of which all are incomplete.
std::string errata_table(const Results&, Links, Verdict);
/// The claims of a verdict by number, those of one kind together.
std::string list_of(const Results&, Verdict, Links);
/// What a reader may doubt: claims whose two routes never differ may have one route. Folded up.
std::string bit_equal_text(const Results&);

}  // namespace oddity
