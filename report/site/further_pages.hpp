#pragma once

#include <string>

#include "report/site/parts.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// chooser.html: recommends a method for a scene, computed in the page.
std::string chooser_page(const Results&, const SiteParts&);
/// algorithms.html: the catalog, and findings about the libraries.
std::string algorithms_page();
/// data/search.js: oddity.index([[where, kind, title, text], ...]), the index for the search.
std::string search_index(const Results&);

}  // namespace oddity
