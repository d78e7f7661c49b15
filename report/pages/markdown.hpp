#pragma once

#include <string>

#include "report/charts/chart.hpp"
#include "report/study/results.hpp"

/// Markdown for GitHub, drawn from results alone. Every page but the one of times is the same from run to
/// run.
namespace oddity {

/// The report's front page: what was found, by chapter and by exercise.
std::string index_page(const Results&);
/// A chapter's page: exercise by exercise, claims, methods, charts, breakdowns.
std::string chapter_page(const Results&, int chapter);
/// How long every method took, in the run at hand, with the charts of error against time.
std::string times_page(const Results&);
/// An exercise's charts, by evaluations and by time, each with the table of all its trials beneath.
std::string charts_page(const ExerciseResult&);
/// The front page and all chapters in one, without charts.
std::string single_page(const Results&);

/// "chapter_03.md".
std::string chapter_file(int chapter);
/// "charts/3.5_swing.svg", "charts/3.5_swing_time.svg", "charts/3.5_swing_over_step.svg".
std::string chart_file(const ExerciseResult&, const QuantityResult&, Across);
/// "charts/3.5_swing_motion.svg".
std::string trajectory_file(const ExerciseResult&, const QuantityResult&);
/// "charts/3.25_chain_of_10_series.svg", for the first of a series.
std::string series_file(const ExerciseResult&, const QuantityResult& first);

/// What speaks for a claim's verdict: each check of the reading that decided, one a line.
std::string claims_evidence(const JudgedClaim&);

}  // namespace oddity
