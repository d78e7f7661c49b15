#pragma once

#include <vector>

#include "solvers/ode/stability.hpp"

namespace oddity::ode {

/// While it lives, unstable_steps() on this thread first tries to confirm these tongues: on both sides of
/// each edge, and at a few steps within and between them. It scans only where one of them fails.
///
///   const KnownTongues here(recorded);
///   const auto tongues = method.unstable_steps();  // the recorded ones, if they are confirmed
class KnownTongues {
 public:
  explicit KnownTongues(const std::vector<Tongue>& tongues) : before_(here_) { here_ = &tongues; }
  KnownTongues(const KnownTongues&) = delete;
  KnownTongues& operator=(const KnownTongues&) = delete;
  ~KnownTongues() { here_ = before_; }

  /// Null: none are known.
  static const std::vector<Tongue>* here() { return here_; }

 private:
  static inline thread_local const std::vector<Tongue>* here_ = nullptr;

  const std::vector<Tongue>* before_;
};

}  // namespace oddity::ode
