#pragma once

#include <filesystem>
#include <string>

#include "report/charts/chart.hpp"
#include "report/pages/markdown.hpp"
#include "report/study/run.hpp"

/// The pictures of a report, and links to them.
namespace oddity {

/// Links to the drawing of an exercise's set-up and to the strip of frames, if it has them.
std::string picture_links(const ExerciseResult&);

/// Name of the stage for progress reports.
inline constexpr const char* drawing_charts = "drawing the charts";

/// Draws the pictures of the report's pages: set-up, motion, one chart per quantity, map.
void draw_pictures(const Results&, const std::filesystem::path& folder, const Progress& progress = {});
/// Draws the charts of `oddity chart`: by work, by setting and by time. `seam` [s] is the time of a
/// type-erased call.
void draw_charts(const ExerciseResult&, Curves, double seam, const std::filesystem::path& folder);
/// Draws a scene's map of stability.
void draw_map(const ExerciseResult&, const std::filesystem::path& folder);

}  // namespace oddity
