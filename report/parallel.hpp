#pragma once

#include <algorithm>
#include <execution>
#include <mutex>
#include <string>

#include "report/run.hpp"

/// Work in parallel, and how much of it is done.
namespace oddity {

/// Counts finished pieces of work for a progress display.
class Tally {
 public:
  Tally(const Progress& progress, std::string stage, std::size_t all)
      : progress_(progress), stage_(std::move(stage)), all_(all) {}
  void add() {
    if (!progress_) return;
    const std::lock_guard lock(mutex_);
    progress_(stage_, ++done_, all_);
  }

 private:
  const Progress& progress_;
  std::string stage_;
  std::size_t all_, done_ = 0;
  std::mutex mutex_;
};

/// std::for_each in parallel; the first exception thrown inside is thrown on (the standard one would
/// terminate).
template <class Range, class F>
void parallel_for_each(Range& range, const F& f) {
  std::exception_ptr thrown;
  std::mutex mutex;
  std::for_each(std::execution::par, range.begin(), range.end(), [&](auto& item) {
    try {
      f(item);
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!thrown) thrown = std::current_exception();
    }
  });
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace oddity
