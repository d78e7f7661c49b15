#pragma once

#include <functional>
#include <optional>

#include "report/study/results.hpp"

namespace oddity {

/// The method has a setting for its step, and stability limits.
bool of_fixed_step(const Method&);

/// Judges a motion at the end of every step, or of every second, third, ... if there are more than 4,096. The
/// reference there is a method without a fixed step: the cheapest trial within a millionth of the need at the
/// times of the reference, otherwise the most accurate one. Without a `MotionAt` it judges only at those
/// times.
class EveryStep {
 public:
  using MotionAt = std::function<Quantity(const Horizon&)>;
  /// Error of a motion at the times of a true one, in needs.
  using OffBy = std::function<double(const Quantity& truth, const Method&, const Trial&)>;
  static constexpr long most_looks = 4096;

  /// Judges by the path, within the quantity's needs, or by `OffBy`.
  EveryStep(Quantity at_looks, double horizon, MotionAt = {}, OffBy = {});

  /// The trial that serves as the reference; empty: the truth is known only at the times of the reference.
  const std::optional<Trial>& truest() const { return truest_; }
  /// The motion at so many times, with its reference. Requires `truest()`.
  Quantity motion_at(long looks) const;

  struct Judged {
    Trial trial;
    double off;  ///< in needs
  };
  /// With so many steps between two times of the reference, judged by the path and only at these times.
  Judged at_looks(const Method&, long steps) const;
  /// With at least so many steps, and at most a few more.
  Judged judged(const Method&, long steps) const;

 private:
  void consider(const Method&);

  Quantity at_looks_;
  double horizon_;
  MotionAt motion_;
  OffBy off_by_;
  std::optional<Trial> truest_;
};

/// The trial at the largest step below which all steps tried pass. Tries 1, 2, 3, 5, 8, ... steps per
/// interval up to 4,096 steps in all, and up to 262,144 steps or 200,000 evaluations while none passes; then
/// bisects to 1 %. If a path is asked for, a failure at the few times of the reference is not judged
/// elsewhere.
std::optional<TimedTrial> within_need(const EveryStep&, const Method&, int intervals,
                                      bool path_is_asked = true);
/// The trial at the expected step, if a few steps confirm it as the largest within the need. It passes, as do
/// two finer ones, and a slightly longer one fails.
std::optional<TimedTrial> confirmed_within_need(const EveryStep&, const Method&, int intervals,
                                                double expected_steps);
/// Whether the finest steps that within_need() tries fail at the times of the reference: the finest of all,
/// and that of 4,096 steps.
bool is_never_within_need(const EveryStep&, const Method&, int intervals);

}  // namespace oddity
