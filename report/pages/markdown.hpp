#pragma once

#include <string>

#include "reference/proofs.hpp"
#include "report/study/results.hpp"

/// Markdown for GitHub, drawn from results alone. Every page but the one of times is the same from run to
/// run.
namespace oddity {

/// The whole report, or the copy of it that is kept with the sources: without times.
enum class Edition { whole, book };

/// The report's front page, of one screen: what was found, the errata that matter most, and what can be
/// unfolded: an answer for each scene, a row for each exercise.
std::string index_page(const Results&, Edition = Edition::whole);
/// An exercise's page: the question, the answer, the findings, the claims, what is computed. Claims that are
/// proved say so.
std::string exercise_page_text(const Results&, const ExerciseResult&, const ProvedClaims& = {});
/// All errata by root, the misprints by number.
std::string errata_page_text(const Results&);
/// For each quantity the fastest method within the need, in the run at hand.
std::string times_page(const Results&);
/// An exercise's charts, by evaluations and by time, each with the table of all its trials beneath.
std::string charts_page(const ExerciseResult&);
/// The front page and all exercises in one, without charts.
std::string single_page(const Results&);

/// "3.5.md".
std::string exercise_file(Number);

/// What speaks for a claim's verdict: each check of the reading that decided, one a line.
std::string claims_evidence(const JudgedClaim&);

}  // namespace oddity
