#pragma once

#include <filesystem>
#include <string>

#include "report/pages/screen.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// What a whole run has done beside its results.
struct Closing {
  bool as_on_record;  ///< the suite is green
  double seconds;     ///< that it took
  std::filesystem::path site, report;
};

/// What was checked, what is wrong, what a game may use, and what to open.
std::string closing_screen(const Results&, const Closing&, const Screen&);

}  // namespace oddity
