#pragma once

#include <span>

#include "solvers/taylor/series.hpp"

/// A motion by its Taylor series, with choice of order and step [Jorba and Zou, Experimental Mathematics 14
/// (2005), 99-117].
namespace oddity::taylor {

/// The order at which a motion to this tolerance takes the least work: the step of a series grows as
/// tolerance^(1/order).
int best_order(const Program& program, double tolerance);

/// Follows a motion in steps as long as its series allow. Inside a step the motion is the series: times and
/// events there need no new expansion.
class Motion {
 public:
  /// The tolerance limits a step's last term, absolute and relative to the state.
  Motion(Program program, double tolerance);

  /// Advances x from t towards t1 to the step's end, or to t1 if that comes first. Returns the error's
  /// message, or null.
  const char* advance(std::span<double> x, double& t, double t1);
  /// The work so far, in evaluations of a right-hand side written by hand.
  long evaluations() const;

 private:
  /// Whether x at t lies on the series, within its reach.
  bool covers(std::span<const double> x, double t);
  /// Expands the series about x at t; false if it is not finite.
  bool expand(std::span<const double> x, double t);
  void see(double t, std::span<double> x);
  /// The largest step for which the series meets the tolerance.
  double reach() const;

  Series series_;
  int order_;
  double share_;  ///< fraction of the radius of convergence
  double reach_ = -1;
  double last_time_ = 0;  ///< the last point returned
  std::vector<double> last_, compared_;
  std::vector<double> scale_;  ///< 1/(1 + |x|)
  long of_expansion_, of_point_, operations_ = 0;
};

}  // namespace oddity::taylor
