#pragma once

#include <string>
#include <vector>

/// What a copy of the site has only where its makers are installed.
namespace oddity {

struct SiteParts {
  bool models = true;  ///< compiled for the page, with which its players and its chooser compute
};
/// Those that can be had now.
SiteParts parts_at_hand();

/// Debian's packages that make them.
std::vector<std::string> packages_of_models();

/// What the copy lacks, and how it shows: "no compiled models: ..."; nothing where it is whole.
std::vector<std::string> lacks(const SiteParts&);
/// What makes a whole one: "apt-get install clang && ./oddity site".
std::string command_for(const SiteParts&);

}  // namespace oddity
