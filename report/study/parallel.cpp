#include "report/study/parallel.hpp"

#ifdef __SANITIZE_THREAD__
#include <atomic>
#include <exception>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#endif

namespace oddity {

#ifdef __SANITIZE_THREAD__

// The sanitizer does not see how TBB's library, which is compiled without it, hands work from thread to
// thread.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& f) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr first;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) f(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!first) first = std::current_exception();
    }
  };
  std::vector<std::jthread> threads(4);
  for (std::jthread& thread : threads) thread = std::jthread(work);
  for (std::jthread& thread : threads) thread.join();
  if (first) std::rethrow_exception(first);
}

#else

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& f) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const auto& block) {
        for (std::size_t i = block.begin(); i != block.end(); ++i) f(i);
      },
      tbb::simple_partitioner());
}

#endif

}  // namespace oddity
