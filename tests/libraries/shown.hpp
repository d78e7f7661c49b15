#pragma once

#include <string>

/// Checks a finding of the catalog about a library. Also for files that are compiled as C++17.
struct Shown {
  const char* by;       ///< name of the test's file, as in the finding's `shown_by`
  std::string version;  ///< version of the installed library

  /// Requires that the finding contains `words`, and that they hold in the version in which it was found.
  /// With another version the measured number is printed.
  void check(const std::string& words, bool hold, double measured) const;
};
