#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>

#include "report/study/run.hpp"

/// Runs work in parallel and reports its progress.
namespace oddity {

/// Counts finished pieces of work for a progress display.
class Stage {
 public:
  Stage(const Progress& progress, std::string stage, std::size_t all)
      : progress_(progress), stage_(std::move(stage)), all_(all) {
    if (all_ > 0) report();
  }
  void add() {
    const std::lock_guard lock(mutex_);
    begun_.erase(std::this_thread::get_id());
    ++done_;
    report();
  }
  /// Reports that work goes on, with nothing new finished.
  void beat() {
    const std::lock_guard lock(mutex_);
    report();
  }
  /// Progress of this thread's piece; if it is made in several passes, the largest value counts.
  void come_to(double part) {
    const std::lock_guard lock(mutex_);
    double& come = begun_[std::this_thread::get_id()];
    come = std::max(come, part);
    report();
  }

 private:
  void report() const {
    if (!progress_) return;
    double done = static_cast<double>(done_);
    for (const auto& [thread, part] : begun_) done += part;
    progress_(stage_, std::min(done, static_cast<double>(all_)), all_);
  }

  const Progress& progress_;
  std::string stage_;
  std::size_t all_, done_ = 0;
  std::map<std::thread::id, double> begun_;
  std::mutex mutex_;
};

/// One of several machines that share the work.
struct Shard {
  std::size_t number = 1, of = 1;
};

/// Calls f(0), ..., f(count - 1) in parallel and waits for all. Throws the first exception from inside, which
/// stops the others, or Stopped if this thread's work was asked to stop.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& f);

template <class Range, class F>
void parallel_for_each(Range& range, const F& f) {
  in_parallel(range.size(), [&](std::size_t i) { f(range[i]); });
}

}  // namespace oddity
