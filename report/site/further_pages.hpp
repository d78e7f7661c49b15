#pragma once

#include <string>

#include "report/site/parts.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// chooser.html: what to use for a scene, answered in the page.
std::string chooser_page(const Results&, const SiteParts&);
/// algorithms.html: the catalog, and what was found in the libraries.
std::string algorithms_page();
/// data/search.js: oddity.index([[where, kind, title, text], ...]), what the search looks through.
std::string search_index(const Results&);

}  // namespace oddity
