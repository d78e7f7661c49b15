#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace oddity {

/// The approved verdicts: claim id -> verdict.
using Verdicts = std::map<std::string, std::string, std::less<>>;

/// Reads verdicts.csv in `folder`. Throws BadInput with file and line if it is missing or broken.
Verdicts read_verdicts(const std::filesystem::path& folder);

}  // namespace oddity
