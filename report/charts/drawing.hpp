#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "chapters/contents.hpp"
#include "chapters/drawing.hpp"
#include "report/study/results.hpp"

/// A scene's pictures, each an SVG file that stands alone and is good on a light page and on a dark one.
namespace oddity {

/// What a scene shows at its start.
std::vector<double> observed_at_start(const Scene&, const Parameters&);

/// The style that each picture brings, for a page that has several.
std::string_view drawing_style();

/// The set-up at the start with its letters; empty where the exercise has no drawing.
std::string setup_svg(const Entry&);
std::string setup_svg(const Drawing&, std::string_view title);

/// Five times of the truest path from its start to its end, side by side; empty where there is no drawing.
std::string frames_svg(const Entry&, const Trajectory&);

}  // namespace oddity
