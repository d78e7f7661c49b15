#pragma once

#include <functional>
#include <optional>

#include "report/study/results.hpp"

namespace oddity {

/// It has a knob for its step, and limits of stability.
bool of_fixed_step(const Method&);

/// Judges a motion at the end of every step, or of every second, third, ... where there are more than 4,096.
/// What is true there is a method without a fixed step: the cheapest trial that is within a millionth of the
/// need at the times of the reference, or, where none is, the most exact. Without a motion to look at it is
/// judged at those times alone.
class EveryStep {
 public:
  using MotionAt = std::function<Quantity(const Horizon&)>;
  /// How far a motion is off at the times of a true one, in units of what is asked.
  using OffBy = std::function<double(const Quantity& truth, const Method&, const Trial&)>;
  static constexpr long most_looks = 4096;

  /// By the path, within the quantity's needs; or by what else is asked of it.
  EveryStep(Quantity at_looks, double horizon, MotionAt = {}, OffBy = {});

  /// What takes the place of the truth; none: the truth is known at the times of the reference alone.
  const std::optional<Trial>& truest() const { return truest_; }
  /// The motion at so many times, with its truth. Only where there is one.
  Quantity motion_at(long looks) const;

  struct Judged {
    Trial trial;
    double off;  ///< in units of what is asked
  };
  /// By so many steps between two times of the reference, judged at these alone: by the path.
  Judged at_looks(const Method&, long steps) const;
  /// By as many, or a few more.
  Judged judged(const Method&, long steps) const;

 private:
  void consider(const Method&);

  Quantity at_looks_;
  double horizon_;
  MotionAt motion_;
  OffBy off_by_;
  std::optional<Trial> truest_;
};

/// By the largest step below which all that were tried meet what is asked: 1, 2, 3, 5, 8, ... steps an
/// interval up to 4,096 steps in all, and to 262,144 steps or 200,000 evaluations while none is; bisected to
/// 1 %. With a path that is asked for, what fails at the few times of the reference is not judged elsewhere.
std::optional<TimedTrial> within_need(const EveryStep&, const Method&, int intervals,
                                      bool path_is_asked = true);

}  // namespace oddity
