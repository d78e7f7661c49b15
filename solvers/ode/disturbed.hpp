#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "solvers/ode/any_system.hpp"
#include "solvers/ode/stability.hpp"

/// How an algorithm of fixed step treats a small disturbance of a motion, measured with the algorithm itself.
namespace oddity::ode {

/// Two motions that start a millionth of their size apart, as they are in truth and as an algorithm has them.
template <std::size_t n>
class Disturbed {
 public:
  using State = std::array<double, n>;

  /// The span is cut off where the truth ends, or after 100,000 steps of it.
  Disturbed(const AnySystem<n>& system, const State& start, double span, const Criteria& = {});

  double span() const { return times_.back(); }
  /// The largest absolute value of each component in truth, but no less than a hundredth of the largest of
  /// all.
  const State& sizes() const { return sizes_; }
  /// When the algorithm's two motions have parted more than the criteria grant (in units of their first
  /// distance), or the second is not finite; and when the first has become too large, or is not finite.
  Loss lost(std::string_view algorithm, double step) const;
  /// When a disturbance of the true motion has grown as much, where the algorithm makes the disturbance's
  /// steps and the truth makes the motion's: linear theory without freezing the motion.
  double lost_along_truth(std::string_view algorithm, double step) const;
  /// How often the algorithm's own motion turns in a step, on average: how often what moves most, in units of
  /// its size in truth, passes its mean upward.
  double turns_in_a_step(std::string_view algorithm, double step) const;
  /// The algorithm's own motion from the start until this time, step by step.
  std::vector<State> motion(std::string_view algorithm, double step, double until) const;

 private:
  /// ln of how far the two may have parted at this time.
  double allowed(double t) const;
  /// The true motion through its span, at even times.
  std::vector<State> truth(double apart) const;

  const AnySystem<n>& system_;
  Criteria criteria_;
  State start_, beside_, sizes_{};
  std::vector<double> times_;
  std::vector<double> parted_;  ///< at these times: ln of how far, in truth; never falling, at least 0
};

}  // namespace oddity::ode
