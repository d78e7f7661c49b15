#pragma once

#include <string>

#include "report/site/parts.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// index.html: what is wrong in the book, by root; what it means for games, a row a scene; the exercises.
std::string front_page(const Results&, const SiteParts&);

}  // namespace oddity
