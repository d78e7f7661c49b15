#pragma once

#include <string>

/// What the catalog says of a library, shown. Also for files that are compiled as C++17.
struct Shown {
  const char* by;       ///< the test's file, which is the finding's `shown_by`
  std::string version;  ///< of the library that is installed

  /// The finding says `words`, and, in the version that it was found in, they hold. With another version what
  /// was measured is printed.
  void check(const std::string& words, bool hold, double measured) const;
};
