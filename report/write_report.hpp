#pragma once

#include <filesystem>

#include "report/results.hpp"

namespace oddity {

/// Writes the report's pages and charts into `folder` and returns the page to open first. One chapter, or all
/// of them (0). Each file is whole or not there. Throws BadInput when the folder cannot be written.
std::filesystem::path write_report(const Results&, int chapter, const std::filesystem::path& folder);

}  // namespace oddity
