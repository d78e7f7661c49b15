#include "report/study/parallel.hpp"

#include <tbb/parallel_for.h>

namespace oddity {

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& f) {
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const auto& block) {
        for (std::size_t i = block.begin(); i != block.end(); ++i) f(i);
      },
      tbb::simple_partitioner());
}

}  // namespace oddity
