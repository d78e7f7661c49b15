#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "chapters/contents.hpp"
#include "chapters/drawing.hpp"
#include "report/study/results.hpp"

/// A scene's pictures, each a complete SVG file that is legible on light and dark pages.
namespace oddity {

/// The scene's observables at its start.
std::vector<double> observed_at_start(const Scene&, const Parameters&);

/// The style within each picture, for a page with several.
std::string_view drawing_style();

/// The set-up at the start with its letters; empty if the exercise has no drawing.
std::string setup_svg(const Entry&);
std::string setup_svg(const Drawing&, std::string_view title);

/// Five frames of the most accurate path, from start to end, side by side; empty if there is no drawing.
std::string frames_svg(const Entry&, const Trajectory&);

}  // namespace oddity
