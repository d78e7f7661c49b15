#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study/results.hpp"
#include "report/text/screen.hpp"

namespace oddity {

/// What a whole run has done beside its results.
struct Closing {
  bool as_on_record;  ///< the suite is green
  double seconds;     ///< that it took
  std::filesystem::path site, report;
  std::string program = "oddity";       ///< as it is typed
  std::vector<std::string> lacks = {};  ///< by the site: what, and how it shows
  std::string command = {};             ///< that makes a whole one
};

/// What was checked, what is wrong, what a game may use, and what to open.
std::string closing_screen(const Results&, const Closing&, const Screen&);

}  // namespace oddity
