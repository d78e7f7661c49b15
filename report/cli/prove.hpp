#pragma once

#include "report/cli/verbs.hpp"

namespace oddity::verbs {

struct AskedProofs {
  std::vector<std::string> exercises = {};  ///< empty: all with provable claims
  fs::path out = {};                        ///< folder for the files
  bool overwrite = false;                   ///< even if the folder has other files
  bool approve = false;                     ///< record the proved claims
};
/// Writes a Coq file for each claim and checks it; returns 0 if all are proved, otherwise 1.
int prove(const fs::path& folder, const AskedProofs&, Format);

}  // namespace oddity::verbs
