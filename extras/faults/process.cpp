#include "extras/faults/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/scratch_folder.hpp"

namespace faults {

namespace fs = std::filesystem;

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

fs::path new_file() {
  static const ScratchFolder scratch;
  static std::atomic<int> count = 0;
  return scratch.path() / std::to_string(count++);
}

/// Runs in the child process.
[[noreturn]] void become(const Command& command, const fs::path& said) {
  const int out =
      open((command.output.empty() ? said : command.output).c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  const int errors = open(said.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  dup2(out, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  for (int one : {SIGINT, SIGTERM, SIGHUP}) std::signal(one, SIG_DFL);
  for (const auto& [name, value] : command.environment) setenv(name.c_str(), value.c_str(), 1);
  if (command.memory > 0) {
    const rlimit most{command.memory, command.memory};
    setrlimit(RLIMIT_AS, &most);
  }
  std::vector<char*> words;
  for (const std::string& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(words.front(), words.data());
  _exit(127);
}

}  // namespace

Process::Process(const Command& command) : output_(new_file()), program_(fork()), begun_(now()) {
  if (program_ == 0) become(command, output_);
}

void Process::signal(int number) const { kill(program_, number); }

Ended Process::wait() {
  int status = 0;
  waitpid(program_, &status, 0);
  Ended ended{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(output_),
              now() - begun_};
  fs::remove(output_);
  return ended;
}

Ended run(const Command& command) { return Process(command).wait(); }

Ended run_until(const Command& command, double seconds, int signal) {
  Process process(command);
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  process.signal(signal);
  return process.wait();
}

}  // namespace faults
