#pragma once

#include <string>

#include "report/site/parts.hpp"

namespace oddity {

/// own.html: a problem's file is typed, and answered in the page by assets/own.js.
std::string own_page(const SiteParts&);
/// data/problems.js: oddity.problems([{title, text}, ...]), files to begin with: those of
/// chapters/examples/problems that the page can run.
std::string own_examples();

}  // namespace oddity
