#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace oddity {

/// Approved errors of an exercise's results, so that a formula that is expected to be wrong cannot be
/// replaced by a different wrong one.
struct ErrorsOnRecord {
  std::string exercise;
  /// "claim ID" (its wrong readings), "claim ID: tolerances", "QUANTITY: need" (the error it may have),
  /// "QUANTITY: MODEL, ALGORITHM", "QUANTITY: breakdown 1"
  std::string of;
  std::string at = {};  ///< a claim's line; a method's kind of setting, and settings
  std::vector<std::optional<double>> errors = {};  ///< 0: only roundings; none: depends on the last bits
  std::vector<std::optional<double>> work = {};    ///< evaluations; none: likewise
  std::string place = {};                          ///< file and line
};

/// In a row, replaces a number that depends on the last bits.
inline constexpr std::string_view by_last_bits = "~";

/// Reads errors.csv in `folder`. Throws BadInput with file and line if it is missing or broken.
std::vector<ErrorsOnRecord> read_errors(const std::filesystem::path& folder);

}  // namespace oddity
