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

/// A file that is written for this run alone. It is gone at the end, and when an interruption comes, unless
/// it was renamed. What a killed run has left of it is written over.
class Unfinished {
 public:
  /// Makes and opens it. Waits while another run, or another thread, has it. Not open where that cannot be:
  /// errno says why.
  explicit Unfinished(const std::string& file);
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished();

  /// -1 where it is not open.
  int descriptor() const { return descriptor_; }
  /// Finished, it takes this name. False where it cannot: errno says why.
  bool rename(const std::string& name);

 private:
  bool is_ours() const;
  bool opened_alone();

  std::string file_;
  int descriptor_ = -1;
  bool finished_ = false;
};

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
