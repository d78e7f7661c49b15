#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

/// Linear theory of stability: how an algorithm's step changes y' = lambda y, and the stable steps along a
/// motion whose Jacobian is frozen point by point.
namespace oddity::ode {

using Eigenvalues = std::vector<std::complex<double>>;

/// The eigenvalues of a model's Jacobian at points of its motion, each of which represents `span` of time.
struct Spectrum {
  double span;
  std::vector<Eigenvalues> at;
  /// At each of these points the Jacobian, row by row, and which of its unknowns are velocities, for
  /// algorithms that take these first. Empty: each eigenvalue belongs to the pair of a damped oscillation.
  std::vector<std::vector<double>> jacobians = {};
  std::vector<bool> velocities = {};
};

/// The Jacobian, row by row and by central differences, of rhs(x, dxdt, t); the number of unknowns is the
/// size of `x`.
std::vector<double> jacobian_at(const std::function<void(const double*, double*, double)>& rhs,
                                std::span<const double> x, double t);
/// Eigenvalues of a square matrix, row by row.
Eigenvalues eigenvalues_of(const std::vector<double>& matrix);

/// ln |R(z)|, the growth of y' = lambda y in a step of the named algorithm, z = h lambda. A partitioned
/// algorithm solves q'' = Re(lambda^2) q, and the result is its faster growth. One that takes velocities
/// first solves q'' = 2 Re(lambda) q' - |lambda|^2 q. For a multistep one the result is the growth of its
/// largest root. Throws std::logic_error for an algorithm without a fixed step.
double growth(std::string_view algorithm, std::complex<double> z);

/// Whether the algorithm alternates between positions and velocities.
bool is_partitioned(std::string_view algorithm);

/// Whether the algorithm uses several past steps.
bool is_multistep(std::string_view algorithm);

/// Steps at which a method is unstable.
struct Tongue {
  double from, to;  ///< infinity: every longer step
};

/// A disturbance that does not fade in the reference, and grows more slowly than this fraction of its
/// |lambda|, counts as one that does not grow: tenfold growth takes it 366 turns or more. One that fades in
/// the reference as fast as this must not grow at all.
constexpr double negligible_growth = 1e-3;

/// A method without a stable step of a 314th of a turn, h |lambda| = 0.02, counts as one that has no stable
/// step.
constexpr double finest = 0.02;

/// Criteria by which a method's motion counts as lost. For a step that is lost at once these numbers hardly
/// matter. For one that is lost slowly they decide, and no number would be right: such limits are marked
/// (`Limit::soft`).
struct Criteria {
  /// Time watched, in radians of the fastest mode: 159 turns. The longer, the more slow losses are found, and
  /// the longer it takes.
  double radians = 1000;
  /// Growth of the distance of neighbouring motions that is allowed beyond `as_fast`. A factor of 100 allows
  /// a mere change of their shape. A disturbance that starts as a millionth is still small then: a ten
  /// thousandth of the motion.
  double granted = 100;
  /// Power of the reference's growth of the distance. 1 would blame a method for parting chaotic motions a
  /// little faster.
  double as_fast = 2;
  /// Size of the motion, in units of the reference's, above which it has blown up. Distances alone cannot
  /// show it: where explicit Euler flings a motion away, its neighbours go with it. Limits that depend on it
  /// are marked.
  double largest_size = 2;
};

/// The times at which a motion counts as lost; infinity: not in the time watched.
struct Loss {
  /// The sizes that are watched, as fractions of `Criteria::largest_size`.
  static constexpr std::array sizes{0.75, 1.0, 2.0};
  double parted;                              ///< neighbouring motions have parted
  std::array<double, sizes.size()> outgrown;  ///< the motion has exceeded each size, or is not finite

  /// Time of the loss by one of the sizes.
  double time(std::size_t size) const { return std::min(parted, outgrown[size]); }
};

/// The steps at which the algorithm is unstable, shortest first. There, at some point of the motion, a
/// disturbance that does not grow in the reference grows by more than `negligible_growth`, or one that does,
/// more than twice as fast. Found by a scan in steps of 0.2 % near every edge (2 % for an algorithm
/// that takes velocities first), up to h |lambda| = 30. An edge is exact to nine digits. Eigenvalues that
/// turn the motion by less than a hundredth of a radian in total are left out.
std::vector<Tongue> unstable_steps(std::string_view algorithm, const Spectrum&,
                                   double negligible = negligible_growth);

/// The largest step below which all are stable: the start of the first tongue; 0: none; infinity: every step.
double stable_step(std::string_view algorithm, const Spectrum&);

/// ln of the growth of a disturbance in `time` by theory, beyond the allowed growth. It is the fastest growth
/// at each point, less `as_fast` times the reference's, added up along the motion. Theory calls a step
/// unstable if any point is; this weighs how strongly, and for how long.
double added_growth(std::string_view algorithm, const Spectrum&, double step, double time, double as_fast);

/// The largest |lambda| at each point, averaged over the motion.
double fastest(const Spectrum&);

/// The largest |lambda| of all.
double largest(const Spectrum&);

}  // namespace oddity::ode
