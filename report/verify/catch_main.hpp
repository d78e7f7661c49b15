#pragma once

#include <memory>
#include <string>
#include <vector>

#include "report/verify/collected.hpp"

namespace oddity {

/// A session of Catch2 in two steps, so that work can be done between the choice of test cases and their run.
class CatchSession {
 public:
  /// The command line without the program's name. `accepted` is false when Catch2 does not take it.
  explicit CatchSession(const std::vector<std::string>& arguments);
  ~CatchSession();

  bool accepted() const;
  /// Help or a list is asked for, and no test case will run.
  bool only_lists() const;
  /// The tags that the command line names, "[3.5]". Throws BadInput where a part of it would select nothing.
  std::vector<std::string> tags() const;
  /// The names of the test cases that the command line selects. Throws BadInput when a part of it selects
  /// none, or when Catch2 cannot open the file that its output is to go to.
  std::vector<std::string> selected() const;
  /// The number of failures. Catch2's files are written now, whole; throws BadInput when one cannot be. To be
  /// called once, and nothing after it.
  int run();

 private:
  struct Session;
  std::vector<Collected> outputs_;  // which wait for the session to close its streams
  std::unique_ptr<Session> session_;
};

}  // namespace oddity
