#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/results.hpp"

namespace oddity {

/// A gnuplot script that draws a quantity's work-precision diagram as SVG into `file`: error against
/// evaluations, models by colour, algorithms by mark, failed trials as crosses above the frame's last decade,
/// with their kind.
std::string chart_script(const QuantityResult&, const std::string& title, const std::filesystem::path& file);

/// Runs gnuplot over the scripts. Throws std::runtime_error with its words when it fails.
void draw(const std::vector<std::string>& scripts);

}  // namespace oddity
