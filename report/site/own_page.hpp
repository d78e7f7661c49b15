#pragma once

#include <filesystem>
#include <string>

#include "report/site/parts.hpp"

namespace oddity {

/// A problem's file for its own page.
struct OwnFile {
  std::string title, text;
  std::string answer;  ///< printed by `choose` for this file; or empty
};

/// own.html: a problem's file is typed, and answered in the page by assets/own.js.
std::string own_page(const SiteParts&, const OwnFile& = {});
/// data/problems.js: oddity.problems with `{files: [{title, text}, ...], programs: {algorithm: template},
/// taken: [name, ...]}`. `files` are those to begin with: this one, then those of chapters/examples/problems.
/// `programs` surround a model's code. `taken` are the names that a table cannot have.
std::string own_examples(const OwnFile& = {});

}  // namespace oddity
