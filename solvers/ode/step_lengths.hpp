#pragma once

#include <vector>

namespace oddity::ode {

/// While it lives, disturbances on this thread are watched in steps of these lengths one after another, again
/// and again, in units of the step that is asked for.
class StepLengths {
 public:
  explicit StepLengths(const std::vector<double>& lengths) : before_(here_) { here_ = &lengths; }
  StepLengths(const StepLengths&) = delete;
  StepLengths& operator=(const StepLengths&) = delete;
  ~StepLengths() { here_ = before_; }

  /// Null: all steps are equal.
  static const std::vector<double>* here() { return here_; }

 private:
  static inline thread_local const std::vector<double>* here_ = nullptr;

  const std::vector<double>* before_;
};

}  // namespace oddity::ode
