#pragma once

#include <filesystem>
#include <string>

#include "report/site/parts.hpp"

namespace oddity {

/// A problem's file, for a page of its own.
struct OwnFile {
  std::string title, text;
  std::string answer;  ///< what `choose` says of it; empty: nothing
};

/// own.html: a problem's file is typed, and answered in the page by assets/own.js.
std::string own_page(const SiteParts&, const OwnFile& = {});
/// data/problems.js: oddity.problems({files: [{title, text}, ...], programs: {algorithm: template}, taken:
/// [name, ...]}), files to begin with, this one first and then those of chapters/examples/problems, the
/// programs around a model's code, and the names that a table cannot have.
std::string own_examples(const OwnFile& = {});

}  // namespace oddity
