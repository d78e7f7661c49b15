#pragma once

#include <functional>
#include <mutex>
#include <string>

#include "report/study/run.hpp"

/// Work in parallel, and how much of it is done.
namespace oddity {

/// Counts finished pieces of work for a progress display.
class Stage {
 public:
  Stage(const Progress& progress, std::string stage, std::size_t all)
      : progress_(progress), stage_(std::move(stage)), all_(all) {}
  void add() {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    progress_(stage_, ++done_, all_);
  }
  /// Nothing is finished, but work goes on.
  void beat() {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    progress_(stage_, done_, all_);
  }

 private:
  const Progress& progress_;
  std::string stage_;
  std::size_t all_, done_ = 0;
  std::mutex mutex_;
};

/// One of so many machines.
struct Shard {
  std::size_t number = 1, of = 1;
};

/// Calls f(0), ..., f(count - 1) in parallel, and throws the first exception thrown inside.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& f);

template <class Range, class F>
void parallel_for_each(Range& range, const F& f) {
  in_parallel(range.size(), [&](std::size_t i) { f(range[i]); });
}

}  // namespace oddity
