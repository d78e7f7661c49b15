#include "reference/interrupted.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <thread>
#include <vector>

namespace oddity {

namespace {

constexpr std::array interruptions{SIGINT, SIGTERM, SIGHUP};

sigset_t all_interruptions() {
  sigset_t set;
  sigemptyset(&set);
  for (int signal : interruptions) sigaddset(&set, signal);
  return set;
}

/// Files and programs at work. Never destroyed: an interruption may come when the program ends.
struct Register {
  std::atomic_flag busy = ATOMIC_FLAG_INIT;
  std::vector<const char*> files;
  std::vector<pid_t> programs;
};
Register& at_work() {
  static Register& all = *new Register;
  return all;
}

/// The register for one thread, which no interruption stops meanwhile: its handler may wait for it.
class Access {
 public:
  Access() {
    const sigset_t set = all_interruptions();
    pthread_sigmask(SIG_BLOCK, &set, &before_);
    while (at_work().busy.test_and_set(std::memory_order_acquire)) {
    }
  }
  Access(const Access&) = delete;
  Access& operator=(const Access&) = delete;
  ~Access() {
    at_work().busy.clear(std::memory_order_release);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t before_{};
};

/// Only calls that a signal's handler may make.
extern "C" void tidy(int signal) {
  tidy_up();
  if (signal == SIGINT) {
    constexpr std::string_view says = "\noddity: interrupted; every file that was written is whole\n";
    static_cast<void>(!write(STDERR_FILENO, says.data(), says.size()));
  }
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  sigaction(signal, &usual, nullptr);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  raise(signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace

/// The register stays closed.
void tidy_up() {
  Register& all = at_work();
  while (all.busy.test_and_set(std::memory_order_acquire)) {
  }
  for (pid_t program : all.programs) {
    kill(program, SIGKILL);
    waitpid(program, nullptr, 0);
  }
  for (const char* file : all.files) unlink(file);
}

void tidy_when_interrupted() {
  at_work();
  struct sigaction tidying {};
  tidying.sa_handler = tidy;
  tidying.sa_mask = all_interruptions();
  for (int signal : interruptions) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &tidying, nullptr);
  }
}

bool Unfinished::is_ours() const {
  struct stat opened {
  }, named{};
  return fstat(descriptor_, &opened) == 0 && stat(file_.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// False while another has it. Whoever has its lock and finds it still under its name has it alone: meanwhile
/// another may have renamed or removed it.
bool Unfinished::opened_alone() {
  const Access access;
  descriptor_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) return true;
  const bool locked = flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
  if (!locked || !is_ours()) {
    close(descriptor_);
    return false;
  }
  at_work().files.push_back(file_.c_str());
  return true;
}

Unfinished::Unfinished(const std::string& file) : file_(file) {
  while (!opened_alone()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

bool Unfinished::rename(const std::string& name) {
  const Access access;
  if (std::rename(file_.c_str(), name.c_str()) != 0) return false;
  std::erase(at_work().files, file_.c_str());
  finished_ = true;
  return true;
}

Unfinished::~Unfinished() {
  if (descriptor_ < 0) return;
  const Access access;
  if (!finished_) {
    unlink(file_.c_str());
    std::erase(at_work().files, file_.c_str());
  }
  close(descriptor_);
}

Running::Running(pid_t program) : program_(program) {
  const Access access;
  at_work().programs.push_back(program_);
}

Running::~Running() {
  const Access access;
  std::erase(at_work().programs, program_);
}

}  // namespace oddity
