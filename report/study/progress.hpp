#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "report/study/run.hpp"
#include "report/text/screen.hpp"

namespace oddity {

/// Progress of a stage of work, reported at times [s].
class Pace {
 public:
  void come_to(double done, double now);
  /// "3 of 7, about 20 s left" if each quarter of the time did half to twice as much as even work would.
  /// Otherwise "3 of 7, 20 s so far".
  std::string line(double all, double now) const;

 private:
  struct Told {
    double time, done;
  };
  double done_at(double time) const;
  std::vector<Told> reports_;  ///< each larger than the one before
};

/// Progress on standard error: on a terminal one line that is overwritten, otherwise a line now and then.
/// Shows nothing for work of less than two seconds. Its destructor removes the line.
class ProgressBar {
 public:
  ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  Progress callback();

 private:
  using Clock = std::chrono::steady_clock;

  void advance(const std::string& stage, double done, std::size_t all);
  void watch();
  void show();
  void wipe();
  double passed() const;
  std::string line() const;

  const Screen screen_;
  const bool terminal_;
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::string stage_ = {};
  std::size_t all_ = 0;
  double done_ = 0;
  Pace pace_ = {};
  Clock::time_point begun_ = Clock::now();  ///< start of the stage
  std::size_t written_ = 0;                 ///< columns of the line
  std::thread clock_;                       ///< a single piece may take long
};

/// Calls `work` with a progress callback that is shown meanwhile, and returns its result.
template <class Work>
auto with_progress(const Work& work) {
  ProgressBar bar;
  return work(bar.callback());
}

}  // namespace oddity
