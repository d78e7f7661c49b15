#pragma once

#include <filesystem>
#include <vector>

#include "report/charts/chart.hpp"
#include "report/pages/markdown.hpp"
#include "report/study/run.hpp"
#include "report/study/trust.hpp"

namespace oddity {

/// Creates the report's folders and checks that they can be written, before a long run. Throws BadInput if
/// not.
void make_folder(const std::filesystem::path& folder);

/// Writes the report's pages and charts into `folder` and returns the front page. Files are written whole or
/// not at all. Throws BadInput if the folder cannot be written.
///   README.md                    the front page
///   3.5.md, ...                  a page per exercise
///   errata.md, trust.md, models.md, stability.md, algorithms.md
///   times.md                     in the whole edition only
///   charts/
std::filesystem::path write_report(const Results&, Edition, const std::filesystem::path& folder,
                                   const Progress& progress = {}, const Trust& trust = {});

/// Writes the charts of all quantities, and a page per exercise, "3.5.md", with the tables behind them.
/// Returns the pages. Writes and throws as write_report().
std::vector<std::filesystem::path> write_charts(const Results&, Curves, const std::filesystem::path& folder,
                                                const Progress& progress = {});

}  // namespace oddity
