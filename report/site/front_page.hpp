#pragma once

#include <string>

#include "report/site/parts.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// index.html: the book's errors by root; their meaning for games, one row per scene; the exercises.
std::string front_page(const Results&, const SiteParts&);

}  // namespace oddity
