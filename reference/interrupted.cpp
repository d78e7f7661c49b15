#include "reference/interrupted.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <string_view>
#include <system_error>
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

struct Name {
  int folder;
  const char* name;

  bool operator==(const Name&) const = default;
};

/// Unfinished files and running programs. Never destroyed: an interruption may come while the program ends.
struct Register {
  std::atomic_flag busy = ATOMIC_FLAG_INIT;
  std::vector<Name> files;
  std::vector<pid_t> programs;
};
Register& at_work() {
  static Register& all = *new Register;
  return all;
}

/// Mode bits that new files do not get.
const mode_t mask = [] {
  const mode_t bits = umask(0);
  umask(bits);
  return bits;
}();

constexpr std::string_view before_chance = ".oddity-", after_chance = ".part";
constexpr int digits_of_chance = 16;
constexpr time_t a_day = 86400;

std::string name_of_chance() {
  std::uint64_t chance = 0;
  if (getrandom(&chance, sizeof chance, 0) != sizeof chance)
    throw std::system_error(errno, std::generic_category());
  std::string name(before_chance);
  for (int i = 0; i < digits_of_chance; ++i, chance >>= 4) name += "0123456789abcdef"[chance & 15];
  return name.append(after_chance);
}

bool is_name_of_chance(std::string_view name) {
  if (!name.starts_with(before_chance) || !name.ends_with(after_chance)) return false;
  name.remove_prefix(before_chance.size());
  name.remove_suffix(after_chance.size());
  return name.size() == digits_of_chance &&
         name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// Access to the register for one thread. Blocks interruptions meanwhile, as their handler may wait for the
/// register.
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

/// Makes only calls that are safe in a signal handler.
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

/// Leaves the register locked.
void tidy_up() {
  Register& all = at_work();
  while (all.busy.test_and_set(std::memory_order_acquire)) {
  }
  for (pid_t program : all.programs) {
    kill(program, SIGKILL);
    waitpid(program, nullptr, 0);
  }
  for (const Name& file : all.files) unlinkat(file.folder, file.name, 0);
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

bool Unfinished::opened_alone() {
  name_ = name_of_chance();
  const Access access;
  descriptor_ = openat(folder_, name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
  if (descriptor_ < 0) return errno != EEXIST;
  at_work().files.push_back({folder_, name_.c_str()});
  return true;
}

Unfinished::Unfinished(int folder) : folder_(folder) {
  while (!opened_alone()) {
  }
}

bool Unfinished::rename(const std::string& name) {
  const Access access;
  fchmod(descriptor_, 0666 & ~mask);  // a file system without modes needs none
  if (renameat(folder_, name_.c_str(), folder_, name.c_str()) != 0) return false;
  std::erase(at_work().files, Name{folder_, name_.c_str()});
  finished_ = true;
  return true;
}

Unfinished::~Unfinished() {
  if (descriptor_ < 0) return;
  const Access access;
  if (!finished_) {
    unlinkat(folder_, name_.c_str(), 0);
    std::erase(at_work().files, Name{folder_, name_.c_str()});
  }
  close(descriptor_);
}

void remove_leftovers(int folder) {
  const int listed = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* const all = listed < 0 ? nullptr : fdopendir(listed);
  if (!all) return;
  while (const dirent* entry = readdir(all)) {
    if (!is_name_of_chance(entry->d_name)) continue;
    struct stat status {};
    if (fstatat(folder, entry->d_name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode) &&
        status.st_uid == geteuid() && status.st_mtime < time(nullptr) - a_day)
      unlinkat(folder, entry->d_name, 0);
  }
  closedir(all);
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
