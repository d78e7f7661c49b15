#pragma once

#include <memory>
#include <string>
#include <vector>

#include "report/verify/collected.hpp"

namespace oddity {

/// A session of Catch2 in two steps, so that work can be done between the selection of test cases and their
/// run.
class CatchSession {
 public:
  /// Takes the arguments without the program's name. accepted() is false if Catch2 rejects them.
  explicit CatchSession(const std::vector<std::string>& arguments);
  ~CatchSession();

  bool accepted() const;
  /// Whether the arguments ask for help or a list, so that no test case will run.
  bool only_lists() const;
  /// The tags in the arguments, "[3.5]". Throws BadInput for a part that would select nothing.
  std::vector<std::string> tags() const;
  /// Names of the test cases that the arguments select. Throws BadInput if a part selects none, or if Catch2
  /// cannot open its output file.
  std::vector<std::string> selected() const;
  /// Runs the test cases and returns the number of failures. Writes Catch2's files whole; throws BadInput if
  /// one cannot be written. Call it once, and last.
  int run();

 private:
  struct Session;
  std::vector<Collected> outputs_;  // written after the session has closed its streams
  std::unique_ptr<Session> session_;
};

}  // namespace oddity
