#pragma once

#include <filesystem>
#include <vector>

#include "report/charts/chart.hpp"
#include "report/pages/markdown.hpp"
#include "report/study/run.hpp"
#include "report/study/trust.hpp"

namespace oddity {

/// Makes the report's folder and writes in it, so that a missing folder cannot waste a run. Throws BadInput
/// when it cannot.
void make_folder(const std::filesystem::path& folder);

/// Writes the report's pages and charts into `folder` and returns the page to open first. Each file is whole
/// or not there. Throws BadInput when the folder cannot be written.
///   README.md                    the front page
///   3.5.md, ...                  a page an exercise
///   errata.md, trust.md, models.md, stability.md, algorithms.md
///   times.md                     in the whole edition alone
///   charts/
std::filesystem::path write_report(const Results&, Edition, const std::filesystem::path& folder,
                                   const Progress& progress = {}, const Trust& trust = {});

/// Writes the charts of all quantities that have a choice, and a page an exercise, "3.5.md", with the tables
/// behind them. Returns the pages. Each file is whole or not there. Throws BadInput as above.
std::vector<std::filesystem::path> write_charts(const Results&, Curves, const std::filesystem::path& folder,
                                                const Progress& progress = {});

}  // namespace oddity
