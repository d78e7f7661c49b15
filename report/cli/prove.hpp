#pragma once

#include "report/cli/verbs.hpp"

namespace oddity::verbs {

struct AskedProofs {
  std::vector<std::string> exercises = {};  ///< none: all of which something is proved
  fs::path out = {};                        ///< where the files go
  bool overwrite = false;                   ///< also over files of others
  bool approve = false;                     ///< what is proved is put on record
};
/// Writes a Coq file for each claim and has it checked; 0 when all are proved, else 1.
int prove(const fs::path& folder, const AskedProofs&, Format);

}  // namespace oddity::verbs
