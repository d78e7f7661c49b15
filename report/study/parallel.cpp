#include "report/study/parallel.hpp"

#include <exception>

#include "solvers/stop.hpp"

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <vector>
#else
#include <tbb/parallel_for.h>
#endif

namespace oddity {

namespace {

#ifdef __SANITIZE_THREAD__

// The sanitizer does not see how TBB's library, which is compiled without it, hands work from thread to
// thread.
template <class F>
void in_threads(std::size_t count, const F& f) {
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads(4);
  for (std::jthread& thread : threads)
    thread = std::jthread([&] {
      for (std::size_t i = next++; i < count; i = next++) f(i);
    });
}

#else

/// Isolated: otherwise TBB cancels the loops inside one that an exception left, and they return as if they
/// had run.
template <class F>
void in_threads(std::size_t count, const F& f) {
  tbb::task_group_context alone(tbb::task_group_context::isolated);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const auto& block) {
        for (std::size_t i = block.begin(); i != block.end(); ++i) f(i);
      },
      tbb::simple_partitioner(), alone);
}

#endif

/// The first exception of many threads.
class FirstThrown {
 public:
  void keep(std::exception_ptr thrown) {
    const std::lock_guard lock(mutex_);
    if (!first_) first_ = std::move(thrown);
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr first_;
};

}  // namespace

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& f) {
  Stop stop(stop_here);
  FirstThrown thrown;
  in_threads(count, [&](std::size_t i) {
    const Stoppable here(&stop);
    try {
      check_stop();
      f(i);
    } catch (...) {
      thrown.keep(std::current_exception());
      stop.request();
    }
  });
  thrown.rethrow();
}

}  // namespace oddity
