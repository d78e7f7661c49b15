#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

/// The program, run like a user does.
namespace program {

struct Ran {
  int status;
  std::string output;  ///< standard output and standard error together
};

/// Runs a shell's command, in which $oddity is the program.
inline Ran shell(const std::string& command) {
  const std::string words = "oddity='" + std::string(ODDITY_PROGRAM) + "'; { " + command + "; } 2>&1";
  std::FILE* pipe = popen(words.c_str(), "r");
  Ran ran{-1, ""};
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    ran.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return ran;
}

/// Runs the program with these arguments.
inline Ran run(const std::string& arguments) { return shell("$oddity " + arguments); }

/// Like `run`, without standard error, which shows progress on a busy machine.
inline Ran printed(const std::string& arguments) { return run("2>/dev/null " + arguments); }

/// Like `run`, on a terminal of this many columns, with these settings of the environment.
inline Ran on_terminal(int columns, const std::string& arguments, const std::string& environment = "") {
  return shell("TERM=xterm COLUMNS=" + std::to_string(columns) + " " + environment +
               " script -qec \"$oddity " + arguments + "\" /dev/null");
}

/// Whether there are pseudo-terminals; a bare chroot has none.
inline bool has_terminals() {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  const bool there = terminal != -1 && grantpt(terminal) == 0 && unlockpt(terminal) == 0 && ptsname(terminal);
  if (terminal != -1) close(terminal);
  return there;
}

inline bool says(const Ran& ran, const std::string& text) {
  return ran.output.find(text) != std::string::npos;
}

}  // namespace program
