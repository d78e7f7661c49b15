#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Programs that are started, disturbed, and awaited.
namespace faults {

struct Command {
  std::vector<std::string> words;
  std::map<std::string, std::string> environment = {};  ///< added to that of this program
  std::size_t memory = 0;                               ///< limit of the address space [bytes]; 0: none
  std::filesystem::path output = {};                    ///< empty: a temporary file
};

struct Ended {
  int status;          ///< as in a shell: 128 plus the signal that ended it
  std::string output;  ///< standard output and standard error
  double seconds;
};

class Process {
 public:
  explicit Process(const Command&);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int) const;
  /// Must be called once.
  Ended wait();

 private:
  std::filesystem::path output_;
  pid_t program_;
  double begun_;
};

Ended run(const Command&);
/// Sends the signal after this many seconds, unless the program has ended before.
Ended run_until(const Command&, double seconds, int signal);

}  // namespace faults
