#pragma once

#include <filesystem>
#include <vector>

#include "report/study/run.hpp"

namespace oddity {

/// A run of all exercises, once for all tests.
inline const Results& run_of_all() {
  static const Results results = run(std::vector<Task>(registry().begin(), registry().end()),
                                     Reference(std::filesystem::path(ODDITY_SOURCE) / "reference"), false);
  return results;
}

}  // namespace oddity
