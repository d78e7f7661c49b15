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
  /// The first time at which the algorithm's two motions have parted more than the criteria grant (in units
  /// of their first distance), one of them is not finite, or the first is too large. Infinity: not in the
  /// span.
  double lost(std::string_view algorithm, double step) const;
  /// The algorithm's own motion from the start until this time, step by step.
  std::vector<State> motion(std::string_view algorithm, double step, double until) const;

 private:
  const AnySystem<n>& system_;
  Criteria criteria_;
  State start_, beside_, sizes_{};
  std::vector<double> times_;
  std::vector<double> parted_;  ///< at these times: ln of how far, in truth; never falling, at least 0
};

}  // namespace oddity::ode
