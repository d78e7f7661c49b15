#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace oddity {

/// The verdicts on record: claim id -> verdict, and exercise number -> "not yet encoded" for those still
/// missing.
using Verdicts = std::map<std::string, std::string, std::less<>>;

constexpr std::string_view not_yet_encoded = "not yet encoded";

/// Reads verdicts.csv in `folder`. Throws BadInput naming file and line when it is missing or broken.
Verdicts read_verdicts(const std::filesystem::path& folder);

}  // namespace oddity
