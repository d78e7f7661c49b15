#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace oddity {

/// Exit, standard error, output and cost of a program.
struct Ended {
  bool ok = false;
  std::string how;  ///< "status 1", "signal 9", "no answer within 60 s"
  std::string words;
  std::string output;  ///< standard output
  double cpu_seconds = 0, peak_bytes = 0;
};

/// Path of a program, by PATH without its relative entries; a name with a slash is used as it is. Empty if
/// no such program exists.
std::string program_on_path(const std::string& name);

/// Runs a program, without a shell, with `input` on its standard input, in `folder` unless empty, and kills
/// it at the limit. It gets at most `memory` [bytes of addresses], unless 0. Throws std::system_error when it
/// cannot be started.
Ended run_program(const std::vector<std::string>& command, const std::string& input,
                  std::chrono::milliseconds limit, std::size_t memory = 0, const std::string& folder = "");

}  // namespace oddity
