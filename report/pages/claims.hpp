#pragma once

#include <map>
#include <string>
#include <vector>

#include "reference/proofs.hpp"
#include "report/study/findings.hpp"

/// Claims and their verdicts, as Markdown.
namespace oddity {

/// "2 wrong, 1 misprint, 12 confirmed", without zero counts.
std::string sentence(const Counts&);

/// Targets of a page's links: other pages in the same folder, or anchors in a single page.
enum class Links { apart, within };
/// "3.5.md#3.5-value".
std::string address_of(const ExerciseResult&, const Claim&, Links);
std::string link_to(const ExerciseResult&, const Claim&, Links);

/// The verdict in a line, and a row per erratum: printed, right, and its visible effect.
std::string answer(const ExerciseResult&);
/// All errata in full, with anchor, reason and numbers; marks those that are proved.
std::string wrong_claims(const ExerciseResult&, const ProvedClaims&);
/// Claims that cannot be checked, then confirmed ones, folded up: one per line, with the other side of its
/// comparison.
std::string other_claims(const ExerciseResult&, const ProvedClaims&);

/// A row per root: roots with a wrong claim, or roots whose claims are all incomplete.
std::string errata_table(const Results&, Links, Verdict);
/// Claims with a verdict, grouped by kind.
std::string list_of(const Results&, Verdict, Links);
/// Claims whose routes agree in every bit; a reader may doubt that they are independent. Folded up.
std::string bit_equal_text(const Results&);

}  // namespace oddity
