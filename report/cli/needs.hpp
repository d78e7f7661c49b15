#pragma once

#include <string>
#include <vector>

/// Requirements of verbs beyond the plain program. The script ./oddity queries them as `oddity --needs VERB
/// ...` before it runs the verb, so it installs or builds nothing for invalid arguments.
namespace oddity {

struct Needs {
  std::vector<std::string> packages = {};  ///< Debian packages
  std::vector<std::string> npm = {};       ///< source folders, for `npm ci`
  std::vector<std::string> targets = {};   ///< build targets
};

/// From now on verbs only print their needs.
void ask_for_needs();
bool needs_are_asked();

/// Called by a verb after checking its arguments. If needs are asked for, prints these and returns true; the
/// verb then has to return.
bool needs_are_all(const Needs&);

}  // namespace oddity
