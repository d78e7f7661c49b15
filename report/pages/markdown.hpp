#pragma once

#include <string>

#include "reference/proofs.hpp"
#include "report/study/results.hpp"

/// Markdown for GitHub, from results alone. All pages except that of times are the same in every run.
namespace oddity {

/// The whole report, or the copy kept with the sources, which has no times.
enum class Edition { whole, book };

/// The report's front page, one screen long: counts, the worst errata, and, folded up, a row per exercise and
/// per scene.
std::string index_page(const Results&, Edition = Edition::whole);
/// An exercise's page: question, answer, findings, claims, computed quantities. Marks proved claims.
std::string exercise_page_text(const Results&, const ExerciseResult&, const ProvedClaims& = {});
/// All errata by root, and misprints by number.
std::string errata_page_text(const Results&);
/// The fastest method within the need for each quantity, in this run.
std::string times_page(const Results&);
/// An exercise's charts, each with a table of its trials.
std::string charts_page(const ExerciseResult&);
/// The front page and all exercises in one page, without charts.
std::string single_page(const Results&);

/// "3.5.md".
std::string exercise_file(Number);

/// Evidence for a claim's verdict: the checks of all its readings and near misses, one per line.
std::string claims_evidence(const JudgedClaim&);

}  // namespace oddity
