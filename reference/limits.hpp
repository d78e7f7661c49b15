#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace oddity {

/// A method's limit of stability as it is on record.
struct ApprovedLimit {
  std::string exercise, model, algorithm;
  double step = 0;       ///< s, the largest stable one; infinity: every step; 0: none
  double theory = 0;     ///< s, of linear theory
  std::string unstable;  ///< the steps that are unstable in theory
  std::optional<double>
      watched;       ///< s, where the motion does not go on alike: only so long, the horizon shown
  std::string soft;  ///< where not sharp: between which steps it lies for other observers; empty: sharp
  std::optional<double> error;   ///< at the largest stable step; none: no step is stable
  std::optional<double> needed;  ///< s, the largest step within the scene's need; none: none that was tried
  std::string beyond;  ///< the outcome just above; "stable" where no step up to the longest tried is unstable
  std::string why;     ///< why step and theory differ, where they do by more than a quarter
  std::string place;   ///< file and line
};

/// How a method ends step by step at one value of the scene's parameter, as it is on record: a letter a step.
struct ApprovedMap {
  std::string exercise, model, algorithm;
  double value = 0;
  std::string outcomes;
  std::string fragile;  ///< a star for each letter that roundings decide, a dot for each other; empty: none
  std::string place;
};

using Limits = std::vector<ApprovedLimit>;
using Maps = std::vector<ApprovedMap>;

/// Reads limits.csv in `folder`. Throws BadInput naming file and line when it is missing or broken.
Limits read_limits(const std::filesystem::path& folder);
/// Reads stability_maps.csv in `folder`, likewise.
Maps read_maps(const std::filesystem::path& folder);

}  // namespace oddity
