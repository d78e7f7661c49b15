#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

/// Linear theory of stability: how an algorithm's step changes y' = lambda y, and what that allows along a
/// motion whose Jacobian is frozen point by point.
namespace oddity::ode {

using Eigenvalues = std::vector<std::complex<double>>;

/// The eigenvalues of a model's Jacobian at points of its motion, each of which stands for `span` of time.
struct Spectrum {
  double span;
  std::vector<Eigenvalues> at;
  /// At each of these points the Jacobian, row by row, and which of its unknowns are velocities, for
  /// algorithms that take these first. Empty: each eigenvalue is one of a damped oscillation's two.
  std::vector<std::vector<double>> jacobians = {};
  std::vector<bool> velocities = {};
};

/// The Jacobian, row by row and by central differences, of rhs(x, dxdt, t) of as many unknowns as `x` has.
std::vector<double> jacobian_at(const std::function<void(const double*, double*, double)>& rhs,
                                std::span<const double> x, double t);
/// Of a square matrix, row by row.
Eigenvalues eigenvalues_of(const std::vector<double>& matrix);

/// ln |R(z)|, the rate at which y' = lambda y grows in a step of the named algorithm, z = h lambda. A
/// partitioned algorithm solves q'' = lambda^2 q, of which it takes the real part, and gives its faster
/// growth; one that takes velocities first solves q'' = 2 Re(lambda) q' - |lambda|^2 q; a multistep one gives
/// the growth of its largest root. Throws std::logic_error for an algorithm
/// that has no fixed step.
double growth(std::string_view algorithm, std::complex<double> z);

/// Whether the algorithm takes positions and velocities in turn.
bool is_partitioned(std::string_view algorithm);

/// Whether the algorithm goes on from several steps past.
bool is_multistep(std::string_view algorithm);

/// Steps at which a method is unstable.
struct Tongue {
  double from, to;  ///< to infinity: every longer step
};

/// A disturbance that does not fade in truth, and grows more slowly than this part of its own |lambda|,
/// counts as one that does not grow: tenfold takes it 366 turns or more. One that fades in truth as fast as
/// this must not grow at all.
constexpr double negligible_growth = 1e-3;

/// A method is said to have no stable step where it has none of a 314th of a turn, h |lambda| = 0.02.
constexpr double finest = 0.02;

/// When a method's motion counts as lost. Where a step is lost at once these numbers hardly matter; where it
/// is lost slowly they decide, and no number would be right: such limits are marked (`Limit::soft`).
struct Criteria {
  /// Of the fastest mode: 159 turns. The longer, the slower a loss is found, and the longer it takes.
  double radians = 1000;
  /// How far neighbouring motions may part beyond what follows: a hundredfold, so that a change of their
  /// shape alone is let pass, and a disturbance that starts as a millionth is still small, a ten thousandth
  /// of the motion.
  double granted = 100;
  /// The power of what they part in truth. 1 would blame a method for parting chaotic motions a little
  /// faster.
  double as_fast = 2;
  /// Of the motion, in units of the truth's: what a scene would call blown up. It cannot do without: whom
  /// explicit Euler flings away, his neighbours go along. Limits that hang on it are marked.
  double largest_size = 2;
};

/// The times at which a motion counts as lost; infinity: it does not in the time watched.
struct Loss {
  /// The sizes that are watched, as parts of `Criteria::largest_size`.
  static constexpr std::array sizes{0.75, 1.0, 2.0};
  double parted;                              ///< neighbouring motions have parted
  std::array<double, sizes.size()> outgrown;  ///< the motion has outgrown each size, or is not finite

  /// By one of the sizes.
  double time(std::size_t size) const { return std::min(parted, outgrown[size]); }
};

/// The steps at which the algorithm is unstable: at some point of the motion a disturbance that does not grow
/// in truth grows by more than `negligible_growth`, or one that does grows more than twice as fast. From the
/// shortest on, found by a scan in steps of 0.2 % near every edge (2 % for an algorithm that takes velocities
/// first), up to h |lambda| = 30; an edge is exact to nine digits. Eigenvalues that turn the motion by less
/// than a hundredth of a radian in all are left out.
std::vector<Tongue> unstable_steps(std::string_view algorithm, const Spectrum&,
                                   double negligible = negligible_growth);

/// The largest step below which all are stable: where the first tongue begins; 0: none; infinity: every step.
double stable_step(std::string_view algorithm, const Spectrum&);

/// ln of how much theory has a disturbance grow in `time`, beyond what it may: the fastest growth at each
/// point, less `as_fast` times the truth's, added up along the motion. Theory calls a step unstable if any
/// point is; this weighs how strongly, and for how long.
double added_growth(std::string_view algorithm, const Spectrum&, double step, double time, double as_fast);

/// The largest |lambda| at each point, averaged over the motion.
double fastest(const Spectrum&);

/// The largest |lambda| of all.
double largest(const Spectrum&);

}  // namespace oddity::ode
