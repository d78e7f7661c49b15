#pragma once

#include <span>

#include "solvers/taylor/series.hpp"

/// A motion by its Taylor series, order and step chosen [Jorba and Zou, Experimental Mathematics 14 (2005),
/// 99-117].
namespace oddity::taylor {

/// The order at which a motion to this tolerance takes the least work: the step that a series allows grows as
/// tolerance^(1/order).
int best_order(const Program& program, double tolerance);

/// Goes along a motion in steps as long as its series allow. Between the ends of a step the motion is the
/// series, which is not expanded anew for a time or an event on the way.
class Motion {
 public:
  /// The tolerance is for a step's last term, absolute and relative to the state.
  Motion(Program program, double tolerance);

  /// From x at t towards t1 to the step's end, or to t1 where that comes first; the error's message, or null.
  const char* advance(std::span<double> x, double& t, double t1);
  /// The work so far, in right-hand sides written by hand.
  long evaluations() const;

 private:
  /// x at t lies on the series, within its reach.
  bool covers(std::span<const double> x, double t);
  /// Whether it can be expanded.
  bool expand(std::span<const double> x, double t);
  void see(double t, std::span<double> x);
  /// How far the series is good.
  double reach() const;

  Series series_;
  int order_;
  double share_;  ///< of the radius of convergence
  double reach_ = -1;
  double last_time_ = 0;  ///< the last point that was given out
  std::vector<double> last_, compared_;
  std::vector<double> scale_;  ///< 1/(1 + |x|)
  long of_expansion_, of_point_, operations_ = 0;
};

}  // namespace oddity::taylor
