#pragma once

#include <sys/types.h>

#include <string>

/// What a run that is interrupted takes with it.
namespace oddity {

/// From now on an interruption (SIGINT, SIGTERM, SIGHUP) ends the programs and removes the files below, and
/// then the run, as it would have.
void tidy_when_interrupted();

/// A file that an interruption removes.
class Unfinished {
 public:
  explicit Unfinished(const std::string& file);
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished();

 private:
  std::string file_;
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
