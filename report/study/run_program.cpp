#include "report/study/run_program.hpp"

#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <system_error>
#include <thread>

#include "reference/interrupted.hpp"
#include "reference/text.hpp"
#include "solvers/stop.hpp"

extern char** environ;

namespace oddity {

namespace {

void require(bool done, int error, const char* what) {
  if (!done) throw std::system_error(error, std::generic_category(), what);
}

/// A file without a name. Unlike a pipe it cannot block or break.
class Scratch {
 public:
  Scratch() : file_(std::tmpfile(), &std::fclose) { require(file_ != nullptr, errno, "a temporary file"); }

  int descriptor() const { return fileno(file_.get()); }
  void write(const std::string& text) {
    require(
        std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() && std::fflush(file_.get()) == 0,
        errno, "a temporary file");
    std::rewind(file_.get());
  }
  std::string read(std::size_t most) {
    require(std::fseek(file_.get(), 0, SEEK_END) == 0, errno, "a temporary file");
    std::string text(std::min(most, static_cast<std::size_t>(std::ftell(file_.get()))), '\0');
    std::rewind(file_.get());
    text.resize(std::fread(text.data(), 1, text.size(), file_.get()));
    return text;
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

pid_t spawn(const std::vector<std::string>& command, int input, int output, int errors,
            const std::string& folder) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const std::string program = program_on_path(command.front());
  const int error = program.empty()
                        ? ENOENT
                        : posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  require(error == 0, error, words.front());
  return child;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

std::string program_on_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return name;
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (const std::string program = folder + "/" + name; folder.starts_with('/') &&
                                                         access(program.c_str(), X_OK) == 0 &&
                                                         std::filesystem::is_regular_file(program))
      return program;
  return "";
}

Ended run_program(const std::vector<std::string>& command, const std::string& input,
                  std::chrono::milliseconds limit, std::size_t memory, const std::string& folder) {
  using namespace std::chrono_literals;
  Scratch given, answered, said;
  given.write(input);
  std::signal(SIGCHLD, SIG_DFL);  // if SIGCHLD is ignored, the exit status is lost
  const pid_t child = spawn(command, given.descriptor(), answered.descriptor(), said.descriptor(), folder);
  if (memory > 0) {
    const rlimit most{memory, memory};
    prlimit(child, RLIMIT_AS, &most, nullptr);
  }
  const Running running(child);
  const auto deadline = std::chrono::steady_clock::now() + limit;
  int status = 0;
  bool late = false;
  rusage used{};
  pid_t ended = 0;
  while ((ended = wait4(child, &status, WNOHANG, &used)) == 0) {
    if (!late && (std::chrono::steady_clock::now() > deadline || (stop_here && stop_here->is_requested()))) {
      late = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(2ms);
  }
  require(ended == child, errno, command.front().c_str());
  check_stop();
  const double seconds = std::chrono::duration<double>(limit).count();
  return {!late && WIFEXITED(status) && WEXITSTATUS(status) == 0,
          late                  ? "no answer within " + format_significant(seconds, 3) + " s"
          : WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                                : "status " + std::to_string(WEXITSTATUS(status)),
          said.read(4000),
          answered.read(std::string::npos),
          seconds_of(used.ru_utime) + seconds_of(used.ru_stime),
          1024.0 * static_cast<double>(used.ru_maxrss)};
}

}  // namespace oddity
