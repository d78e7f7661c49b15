// A faulty disk and clock, for a program that loads this before its libraries (LD_PRELOAD). ODDITY_FAULT is
// one of
//   full, readonly   from the change ODDITY_FAULT_AT on, the disk refuses all: no space, no permission.
//   kill             the program is killed before that change.
//   clock            the time of day jumps by a year, on and back.
// At the end the file ODDITY_FAULT_COUNT contains the number of changes requested.

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

std::atomic<long> changes = 0;

std::string setting(const char* name) {
  const char* text = std::getenv(name);
  return text ? text : "";
}

struct Fault {
  std::string kind = setting("ODDITY_FAULT"), count = setting("ODDITY_FAULT_COUNT");
  long at = std::atol(setting("ODDITY_FAULT_AT").c_str());

  Fault() { unsetenv("LD_PRELOAD"); }  // not for its child processes
  ~Fault() {
    if (count.empty()) return;
    const std::string line = std::to_string(changes) + "\n";
    const long file = syscall(SYS_openat, AT_FDCWD, count.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    static_cast<void>(!syscall(SYS_write, file, line.data(), line.size()));
  }

  /// Whether the disk accepts one more change.
  bool lets_pass() const {
    const bool now = ++changes >= at && at > 0;
    if (now && kind == "kill") kill(getpid(), SIGKILL);
    if (!now || (kind != "full" && kind != "readonly")) return true;
    errno = kind == "full" ? ENOSPC : EROFS;
    return false;
  }
};

const Fault& fault() {
  static const Fault one;
  return one;
}

[[gnu::constructor]] void begin() { fault(); }

template <class Function>
Function* real(const char* name, Function*) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool is_of_disk(int descriptor) {
  struct stat status {};
  return descriptor > STDERR_FILENO && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

}  // namespace

extern "C" {

int openat(int folder, const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (flags & O_CREAT && !fault().lets_pass()) return -1;
  static const auto open_really = real("openat", openat);
  return open_really(folder, path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  if (is_of_disk(descriptor) && !fault().lets_pass()) return -1;
  static const auto write_really = real("write", write);
  return write_really(descriptor, bytes, size);
}

int renameat(int folder, const char* from, int other, const char* to) noexcept {
  if (!fault().lets_pass()) return -1;
  static const auto rename_really = real("renameat", renameat);
  return rename_really(folder, from, other, to);
}

int mkdirat(int folder, const char* path, mode_t mode) noexcept {
  if (!fault().lets_pass()) return -1;
  static const auto mkdir_really = real("mkdirat", mkdirat);
  return mkdir_really(folder, path, mode);
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  static std::atomic<long> asked = 0;
  const long result = syscall(SYS_clock_gettime, clock, time);
  if (clock == CLOCK_REALTIME && fault().kind == "clock")
    time->tv_sec += (++asked % 2 == 0 ? 1 : -1) * 365L * 86400;
  return static_cast<int>(result);
}
}
