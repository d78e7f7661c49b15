#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace oddity {

/// How far off what an exercise computes is, as it is on record, so that a formula which is expected to be
/// wrong cannot be any other wrong one.
struct ErrorsOnRecord {
  std::string exercise;
  /// "claim ID" (its wrong readings), "claim ID: tolerances", "QUANTITY: need" (the error it may have),
  /// "QUANTITY: MODEL, ALGORITHM", "QUANTITY: breakdown 1"
  std::string of;
  std::string at = {};                             ///< a claim's line; a method's knob and settings
  std::vector<std::optional<double>> errors = {};  ///< 0: as small as roundings; none: the last bits decide
  std::vector<std::optional<double>> work = {};    ///< evaluations; none: likewise
  std::string place = {};                          ///< file and line
};

/// In a row, what stands for a number that the last bits decide.
inline constexpr std::string_view by_last_bits = "~";

/// Reads errors.csv in `folder`. Throws BadInput naming file and line when it is missing or broken.
std::vector<ErrorsOnRecord> read_errors(const std::filesystem::path& folder);

}  // namespace oddity
