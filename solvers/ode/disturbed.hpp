#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "solvers/ode/any_system.hpp"
#include "solvers/ode/stability.hpp"

/// Response of an algorithm of fixed step to a small disturbance of a motion, measured with the algorithm
/// itself.
namespace oddity::ode {

/// Two motions that start a millionth of their size apart, by the reference and by an algorithm.
template <std::size_t n>
class Disturbed {
 public:
  using State = std::array<double, n>;

  /// Cuts the span off where the reference ends, or after 100,000 of its steps.
  Disturbed(const AnySystem<n>& system, const State& start, double span, const Criteria& = {});

  double span() const { return times_.back(); }
  /// The largest absolute value of each component of the reference, but at least a hundredth of the largest
  /// of all.
  const State& sizes() const { return sizes_; }
  /// Times at which the algorithm's motion is lost. `parted`: its two motions are farther apart than the
  /// criteria allow (in units of their first distance), or the second is not finite. `outgrown`: the first is
  /// too large, or not finite.
  Loss lost(std::string_view algorithm, double step) const;
  /// Time at which a disturbance of the reference motion has grown beyond the same limit. The algorithm steps
  /// the disturbance, the reference the motion: linear theory without freezing the motion.
  double lost_along_truth(std::string_view algorithm, double step) const;
  /// Number of turns of the algorithm's own motion in a step, on average. A turn is an upward passage through
  /// its mean of the component that moves most, in units of its size.
  double turns_in_a_step(std::string_view algorithm, double step) const;
  /// The algorithm's own motion from the start to this time, step by step.
  std::vector<State> motion(std::string_view algorithm, double step, double until) const;

 private:
  /// ln of the distance allowed at this time, in units of the first distance.
  double allowed(double t) const;
  /// The reference motion through its span, at equally spaced times.
  std::vector<State> truth(double apart) const;

  const AnySystem<n>& system_;
  Criteria criteria_;
  State start_, beside_, sizes_{};
  std::vector<double> times_;
  std::vector<double>
      parted_;  ///< ln of the reference's distance at these times, its maximum so far, at least 0
};

}  // namespace oddity::ode
