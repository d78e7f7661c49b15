#pragma once

#include <unistd.h>

#include <boost/timer/progress_display.hpp>
#include <iostream>
#include <memory>

#include "report/run.hpp"

namespace oddity {

/// A live bar on standard error when that is a terminal, else nothing. One bar for each stage of a run.
class ProgressBar {
 public:
  Progress callback() {
    if (isatty(STDERR_FILENO) == 0) return {};
    return [this](const std::string& stage, std::size_t done, std::size_t all) {
      if (done == 1) bar_ = std::make_unique<boost::timer::progress_display>(all, std::cerr, stage + "\n");
      if (bar_) ++*bar_;
      if (done == all) std::cerr << std::flush;
    };
  }

 private:
  std::unique_ptr<boost::timer::progress_display> bar_;
};

}  // namespace oddity
