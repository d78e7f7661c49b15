#pragma once

#include <vector>

#include "report/study/choose.hpp"
#include "report/study/starts.hpp"

namespace oddity {

/// Times candidates per frame, on the requested start.
class FrameClock {
 public:
  FrameClock(const Need& need, const Starts& starts, const Price& price, const Progress& progress)
      : need_(need), starts_(starts), price_(price), progress_(progress) {}

  void time(Candidate&) const;
  /// Times the candidates that are not timed yet. Returns whether there were any.
  bool time_all(const std::vector<Candidate*>&);
  /// Extra evaluations in the first frame of a run, beyond a steady one.
  double restart(const Candidate&) const;

  int timed() const { return timed_; }
  double seconds() const { return seconds_; }  ///< spent on timing

 private:
  double worst_part(const Candidate&) const;
  Time time_per_frame(const Candidate&) const;
  double restarting(const Candidate&) const;

  const Need& need_;
  const Starts& starts_;
  const Price& price_;
  const Progress& progress_;
  int timed_ = 0;
  double seconds_ = 0;
};

}  // namespace oddity
