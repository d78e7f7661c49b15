#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace oddity {

/// Approved limit of stability of a method.
struct ApprovedLimit {
  std::string exercise, model, algorithm;
  double step = 0;                ///< s, the largest stable step; infinity: every step; 0: none
  double theory = 0;              ///< s, by linear theory
  std::string unstable;           ///< the steps that are unstable in theory
  std::optional<double> watched;  ///< s, the time watched, if the motion does not go on in the same way
  std::string soft;               ///< range of the limit for other observers; empty: it is sharp
  std::optional<double> error;    ///< error at the largest stable step; none: no step is stable
  std::optional<double> needed;   ///< s, the largest step within the scene's tolerance; none: no tried step
  std::string beyond;             ///< outcome just above; "stable": no tried step is unstable
  std::string why;                ///< the reason if step and theory differ by more than a quarter
  std::string place;              ///< file and line
};

/// Approved endings of a method at one value of the scene's parameter: one letter per step.
struct ApprovedMap {
  std::string exercise, model, algorithm;
  double value = 0;
  std::string outcomes;
  std::string fragile;  ///< stars for letters that depend on roundings, dots for others; empty: none
  std::string place;
};

using Limits = std::vector<ApprovedLimit>;
using Maps = std::vector<ApprovedMap>;

/// Reads limits.csv in `folder`. Throws BadInput with file and line if it is missing or broken.
Limits read_limits(const std::filesystem::path& folder);
/// Reads stability_maps.csv in `folder`; throws likewise.
Maps read_maps(const std::filesystem::path& folder);

}  // namespace oddity
