#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// Programs that are started, disturbed, and watched to their end.
namespace faults {

struct Command {
  std::vector<std::string> words;
  std::map<std::string, std::string> environment = {};  ///< beside that of this program
  std::size_t memory = 0;                               ///< the most address space [bytes]; 0: any
  std::filesystem::path output = {};                    ///< instead of a file of its own
};

struct Ended {
  int status;        ///< as a shell has it: 128 and the signal that ended it
  std::string said;  ///< standard output and standard error
  double seconds;
};

class Process {
 public:
  explicit Process(const Command&);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void signal(int) const;
  /// To be called once.
  Ended wait();

 private:
  std::filesystem::path said_;
  pid_t program_;
  double begun_;
};

Ended run(const Command&);
/// Gets the signal after so many seconds, where it has not ended before.
Ended run_until(const Command&, double seconds, int signal);

}  // namespace faults
