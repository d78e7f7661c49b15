#pragma once

#include <sys/types.h>

#include <string>

/// What a run that is interrupted takes with it.
namespace oddity {

/// From now on an interruption (SIGINT, SIGTERM, SIGHUP) ends the programs and removes the files below, and
/// then the run, as it would have.
void tidy_when_interrupted();

/// The same at once, for a run that can go no further: nothing new begins. It takes no memory.
void tidy_up();

/// A file that is written for this run alone, under a name of chance that was not there before. It is gone at
/// the end, and when an interruption comes, unless it was renamed.
class Unfinished {
 public:
  /// Makes and opens it in the open folder, which stays open: nobody else may read or write it. Not open
  /// where that cannot be: errno says why.
  explicit Unfinished(int folder);
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished();

  /// -1 where it is not open.
  int descriptor() const { return descriptor_; }
  /// Finished, it takes this name in its folder, in place of what has it, and the mode of new files. False
  /// where it cannot: errno says why.
  bool rename(const std::string& name);

 private:
  bool opened_alone();

  int folder_;
  std::string name_;
  int descriptor_ = -1;
  bool finished_ = false;
};

/// Removes from the open folder what runs of this user that were killed have left unfinished: it is a day
/// old.
void remove_leftovers(int folder);

/// A program that an interruption ends, before it removes the files that the program may be writing.
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
