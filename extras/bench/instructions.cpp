#include "extras/bench/instructions.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>

namespace oddity {

Instructions::Instructions() {
  perf_event_attr event{};
  event.size = sizeof event;
  event.type = PERF_TYPE_HARDWARE;
  event.config = PERF_COUNT_HW_INSTRUCTIONS;
  event.exclude_kernel = 1;
  event.exclude_hv = 1;
  file_ = static_cast<int>(syscall(SYS_perf_event_open, &event, 0, -1, -1, 0));
  if (file_ < 0) why_not_ = "perf_event_open: " + std::string(std::strerror(errno));
}

Instructions::~Instructions() {
  if (available()) close(file_);
}

double Instructions::now() const {
  std::uint64_t count = 0;
  if (!available() || read(file_, &count, sizeof count) != sizeof count)
    return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(count);
}

}  // namespace oddity
