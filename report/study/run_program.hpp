#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace oddity {

/// How a program ended, what it said on standard error, and what it took.
struct Ended {
  bool ok = false;
  std::string how;  ///< "status 1", "signal 9", "no answer within 60 s"
  std::string words;
  std::string output;  ///< standard output
  double cpu_seconds = 0, peak_bytes = 0;
};

/// Where a program of that name is, on PATH without its relative parts, or as it is where it is a path; empty
/// where it is not.
std::string program_on_path(const std::string& name);

/// Runs a program, without a shell, with `input` on its standard input, in `folder` unless empty; it is
/// killed at the limit. It gets no more `memory` [bytes of addresses] than that, unless 0. Throws
/// std::system_error when it cannot be started.
Ended run_program(const std::vector<std::string>& command, const std::string& input,
                  std::chrono::milliseconds limit, std::size_t memory = 0, const std::string& folder = "");

}  // namespace oddity
