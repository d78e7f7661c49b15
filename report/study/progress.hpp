#pragma once

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <string>

#include "report/study/run.hpp"

namespace oddity {

/// How far a run has come, on standard error: in one line that is written over on a terminal, else in a line
/// now and then. Nothing for what takes less than two seconds.
class ProgressBar {
 public:
  Progress callback() {
    return [this](const std::string& stage, std::size_t done, std::size_t all) { show(stage, done, all); };
  }
  ~ProgressBar() { wipe(); }

 private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
  }

  static std::string shown(double seconds) {
    const auto whole = static_cast<long>(std::ceil(seconds));
    return whole < 120 ? std::to_string(whole) + " s" : std::to_string((whole + 59) / 60) + " min";
  }

  void show(const std::string& stage, std::size_t done, std::size_t all) {
    if (stage != stage_) {
      stage_ = stage;
      begun_ = last_ = Clock::now();
      return;
    }
    const double passed = seconds_since(begun_);
    if (seconds_since(last_) < (terminal_ ? 0.5 : 10) || passed < 2) return;
    last_ = Clock::now();
    const double left =
        passed * static_cast<double>(all - done) / static_cast<double>(std::max<std::size_t>(done, 1));
    const std::string line =
        "oddity: " + stage + ", " + std::to_string(done) + " of " + std::to_string(all) +
        (done > 0 ? ", about " + shown(left) + " left" : ", " + shown(passed) + " so far");
    wipe();
    std::cerr << line << (terminal_ ? "" : "\n") << std::flush;
    if (terminal_) written_ = line.size();
  }

  void wipe() {
    if (written_ > 0) std::cerr << '\r' << std::string(written_, ' ') << '\r' << std::flush;
    written_ = 0;
  }

  const bool terminal_ = isatty(STDERR_FILENO) != 0;
  std::string stage_;
  Clock::time_point begun_ = Clock::now(), last_ = begun_;
  std::size_t written_ = 0;
};

}  // namespace oddity
