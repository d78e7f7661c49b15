#pragma once

#include <string>
#include <vector>

/// Parts of the site that need tools to be installed.
namespace oddity {

struct SiteParts {
  bool models = true;  ///< compiled for the page; its players and its chooser need them
};
/// The parts that are available now.
SiteParts parts_at_hand();

/// Debian packages that build them.
std::vector<std::string> packages_of_models();

/// The missing parts and their effects: "no compiled models: ..."; empty for a complete copy.
std::vector<std::string> lacks(const SiteParts&);
/// The command for a complete copy: "apt-get install clang && ./oddity site".
std::string command_for(const SiteParts&);

}  // namespace oddity
