#pragma once

#include <string>
#include <vector>

/// What verbs need beside the plain program. The script ./oddity asks for it, as `oddity --needs VERB ...`,
/// before it has the verb done: so nothing is installed or built for arguments that are no good.
namespace oddity {

struct Needs {
  std::vector<std::string> packages = {};  ///< Debian's
  std::vector<std::string> npm = {};       ///< folders of the sources, for `npm ci`
  std::vector<std::string> targets = {};   ///< of the build
};

/// From now on nothing is done but said what it needs.
void ask_for_needs();
bool needs_are_asked();

/// Of a verb whose arguments are found good: says these where they are asked, and returns whether they are.
/// Nothing is then to be done.
bool needs_are_all(const Needs&);

}  // namespace oddity
