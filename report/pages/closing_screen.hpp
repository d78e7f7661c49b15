#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study/results.hpp"
#include "report/text/screen.hpp"

namespace oddity {

/// Outcome of a whole run, apart from its results.
struct Closing {
  bool as_on_record;  ///< the suite passed
  double seconds;     ///< duration of the run
  std::filesystem::path site, report;
  std::string program = "oddity";       ///< as typed
  std::vector<std::string> lacks = {};  ///< missing parts of the site, with their effect
  std::string command = {};             ///< makes a complete site
};

/// Summary of a run: the checks, the worst errata, methods for games, and the files to open.
std::string closing_screen(const Results&, const Closing&, const Screen&);

}  // namespace oddity
