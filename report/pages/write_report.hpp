#pragma once

#include <filesystem>
#include <vector>

#include "report/study/run.hpp"

namespace oddity {

/// Makes the report's folder and writes in it, so that a run is not lost for want of one. Throws BadInput
/// when it cannot.
void make_folder(const std::filesystem::path& folder);

/// Writes the report's pages and charts into `folder` and returns the page to open first. One chapter, or all
/// of them (0). Each file is whole or not there. Throws BadInput when the folder cannot be written.
std::filesystem::path write_report(const Results&, int chapter, const std::filesystem::path& folder,
                                   const Progress& progress = {});

/// Writes the charts of all quantities that have a choice, and a page an exercise, "3.5.md", with the tables
/// behind them. Returns the pages. Each file is whole or not there. Throws BadInput as above.
std::vector<std::filesystem::path> write_charts(const Results&, const std::filesystem::path& folder,
                                                const Progress& progress = {});

}  // namespace oddity
