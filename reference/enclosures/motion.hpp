#pragma once

#include <optional>

#include "reference/enclosures/disc.hpp"
#include "reference/enclosures/parallelepiped.hpp"
#include "reference/make/dual.hpp"
#include "reference/make/recorded.hpp"

/// Initial value problems by Taylor series with bounded remainders, in balls.
namespace oddity::truth {

/// The polynomials of a motion about a time, and of its slopes with respect to the start, for times at which
/// their remainders are small.
struct Stride {
  Number from;
  double length;  ///< with its sign
  Disc disc;
  double apart;                              ///< largest distance of starts in the disc from the center
  std::vector<Numbers> center;               ///< one series per unknown
  std::vector<std::vector<Numbers>> slopes;  ///< row i, column j: series of d x_i / d x_j

  bool holds(const Number& t) const;
  /// Image of the center at the time.
  Numbers image(const Number& t) const;
  /// Slopes over all starts in the set for which it was made.
  Rows slopes_at(const Number& t) const;
};

/// An initial value problem recorded on two tapes: the motion, and the motion with its slopes with respect to
/// one of the unknowns. rhs(x, t) returns the derivatives of x.
class TaylorProblem {
 public:
  template <class Rhs>
  TaylorProblem(const Rhs& rhs, std::size_t dimension) {
    motion_.record(rhs, dimension);
    record_slopes(rhs, dimension);
  }

  /// The longest stride of these states at t, towards t1, with a remainder below 10^-digits of the state's
  /// size. `radius` is the radius of the motion's disc; the last stride's serves as a guess. Throws Undecided
  /// if the states are too far apart, or the stride too short.
  Stride stride(const Parallelepiped& states, const Number& t, const Number& t1, int digits,
                double& radius) const;

  /// The state at t1 from that at t0. Throws as Followed::at.
  Numbers solve(const Numbers& x, const Number& t0, const Number& t1, int digits) const;

  /// Whether both tapes are equal.
  bool operator==(const TaylorProblem&) const;

 private:
  template <class Rhs>
  void record_slopes(const Rhs& rhs, std::size_t dimension) {
    std::vector<Dual<Jet>> x;
    for (std::size_t i = 0; i < dimension; ++i) x.push_back({slopes_.variable(), slopes_.variable()});
    const Jet t = slopes_.variable(), still{&slopes_.tape, slopes_.tape.put({Tape::Op::constant, -1, -1, 0})};
    const std::vector<Dual<Jet>> dxdt = rhs(x, Dual<Jet>{t, still});
    for (const auto part : {&Dual<Jet>::x, &Dual<Jet>::dx})
      for (std::size_t i = 0; i < dimension; ++i) {
        slopes_.unknowns.push_back((x[i].*part).node);
        slopes_.derivatives.push_back((dxdt[i].*part).node);
      }
    slopes_.time = t.node;
  }

  std::vector<std::vector<Numbers>> slopes(const Numbers& hull, const Number& t, int order) const;

  mutable Recorded motion_, slopes_;
};

/// A motion that is followed by strides, which do not end at the requested times.
class Followed {
 public:
  Followed(TaylorProblem problem, const Numbers& x0, const Number& t0, int digits)
      : problem_(std::move(problem)), x0_(x0), t0_(t0), digits_(digits), states_(x0) {}

  /// The state at a time that is not before the last requested one. Throws Undecided if the enclosure becomes
  /// too wide, or a stride too short.
  Numbers at(const Number& t1);
  /// Whether this is the motion of this problem from this start, and t1 lies ahead.
  bool leads_to(const TaylorProblem&, const Numbers& x0, const Number& t0, const Number& t1) const;

 private:
  void follow_to(const Number& end_of_stride);

  TaylorProblem problem_;
  Numbers x0_;
  Number t0_;
  int digits_;
  slong bits_ = Ball::bits;
  Parallelepiped states_;  ///< states at the beginning of the stride
  std::optional<Stride> stride_;
  double radius_ = 0;
};

/// The state at t1. A motion that is requested at successive times is followed once.
Numbers enclosed_motion(const TaylorProblem&, const Numbers& x0, const Number& t0, const Number& t1,
                        int digits);

/// rhs(const std::vector<T>& x, const T& t) -> std::vector<T>, for T = Jet and T = Dual<Jet>.
template <class Rhs>
Numbers solve_taylor(const Rhs& rhs, const Numbers& x0, const Number& t0, const Number& t1,
                     Precision precision) {
  return enclosed_motion(TaylorProblem(rhs, x0.size()), x0, t0, t1, precision.digits);
}

}  // namespace oddity::truth
