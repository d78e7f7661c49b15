#pragma once

#include <filesystem>
#include <string>

#include "report/charts/chart.hpp"
#include "report/pages/markdown.hpp"
#include "report/study/run.hpp"

/// The pictures of a report: which there are, and where they stand.
namespace oddity {

/// Links to the drawing of an exercise's set-up and to the strip of its motion's frames, where it has them.
std::string picture_links(const ExerciseResult&);

/// What a progress is told while pictures are drawn.
inline constexpr const char* drawing_charts = "drawing the charts";

/// Draws the pictures that a report's pages show: the set-up, the motion, one chart a quantity, the map.
void draw_pictures(const Results&, const std::filesystem::path& folder, const Progress& progress = {});
/// Draws the charts of an exercise that `oddity chart` shows, by work, by setting and by time, of which
/// `seam` [s] is a call's through the seam.
void draw_charts(const ExerciseResult&, Curves, double seam, const std::filesystem::path& folder);
/// Draws a scene's map of stability.
void draw_map(const ExerciseResult&, const std::filesystem::path& folder);

}  // namespace oddity
