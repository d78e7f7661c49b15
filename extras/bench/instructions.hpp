#pragma once

#include <string>

namespace oddity {

/// The processor's counter of this thread's instructions, user code only.
class Instructions {
 public:
  Instructions();
  ~Instructions();
  Instructions(const Instructions&) = delete;
  Instructions& operator=(const Instructions&) = delete;

  bool available() const { return file_ >= 0; }
  const std::string& why_not() const { return why_not_; }
  /// Instructions up to now; NaN where there is no counter.
  double now() const;

 private:
  int file_;
  std::string why_not_;
};

}  // namespace oddity
