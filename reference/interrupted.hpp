#pragma once

#include <sys/types.h>

#include <string>

/// Cleanup after an interruption of a run.
namespace oddity {

/// From now on an interruption (SIGINT, SIGTERM, SIGHUP) first ends the programs below and removes the files,
/// and then ends the run as usual.
void tidy_when_interrupted();

/// Does the same at once, for a run that cannot continue: nothing new begins. Allocates no memory.
void tidy_up();

/// A file that only this run writes, under a random name that did not exist before. It is removed at the end
/// or by an interruption, unless it was renamed.
class Unfinished {
 public:
  /// Creates and opens it in the open folder, which stays open; nobody else may read or write it. If that
  /// fails it is not open, and errno has the reason.
  explicit Unfinished(int folder);
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished();

  /// -1 if it is not open.
  int descriptor() const { return descriptor_; }
  /// Renames the finished file in its folder, replacing an existing file, and gives it the mode of new files.
  /// False if that fails: errno has the reason.
  bool rename(const std::string& name);

 private:
  bool opened_alone();

  int folder_;
  std::string name_;
  int descriptor_ = -1;
  bool finished_ = false;
};

/// Removes from the open folder unfinished files that are a day old, left by killed runs of this user.
void remove_leftovers(int folder);

/// A program that an interruption ends before it removes the files that the program may be writing.
class Running {
 public:
  explicit Running(pid_t program);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();

 private:
  pid_t program_;
};

}  // namespace oddity
