#pragma once

#include "reference/enclosures/parallelepiped.hpp"
#include "reference/enclosures/recorded.hpp"
#include "reference/make/dual.hpp"

/// Initial value problems by Taylor series whose remainders are bounded, in balls.
namespace oddity::truth {

/// An initial value problem recorded on two tapes: of the motion, and of it with its slopes by one of the
/// unknowns. rhs(x, t) returns the derivatives of x.
class TaylorProblem {
 public:
  template <class Rhs>
  TaylorProblem(const Rhs& rhs, std::size_t dimension) {
    std::vector<Jet> x;
    for (std::size_t i = 0; i < dimension; ++i) x.push_back(motion_.variable());
    const Jet t = motion_.variable();
    const std::vector<Jet> dxdt = rhs(x, t);
    for (std::size_t i = 0; i < dimension; ++i) {
      motion_.unknowns.push_back(x[i].node);
      motion_.derivatives.push_back(dxdt[i].node);
    }
    motion_.time = t.node;
    record_slopes(rhs, dimension);
  }

  /// The state at t1 from that at t0. Each step's remainder is below 10^-digits of the state's size. Throws
  /// Undecided where the enclosure becomes too wide, or a step too short.
  Numbers solve(const Numbers& x, const Number& t0, const Number& t1, int digits) const;

  /// One step from t towards t1, the set of states following; returns where it ends. `radius` is how far the
  /// motion was found to be analytic: the last step's as a guess.
  Number step(Parallelepiped& states, const Number& t, const Number& t1, int digits, double& radius) const;

  /// Whether both tapes are alike.
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

  Rows slopes(const Numbers& hull, const Number& t, const Number& h) const;

  mutable Recorded motion_, slopes_;
};

/// The state at t1. A motion that is asked for at one time after the other is followed once.
Numbers enclosed_motion(const TaylorProblem&, const Numbers& x0, const Number& t0, const Number& t1,
                        int digits);

/// rhs(const std::vector<T>& x, const T& t) -> std::vector<T>, for T = Jet and T = Dual<Jet>.
template <class Rhs>
Numbers solve_taylor(const Rhs& rhs, const Numbers& x0, const Number& t0, const Number& t1,
                     Precision precision) {
  return enclosed_motion(TaylorProblem(rhs, x0.size()), x0, t0, t1, precision.digits);
}

}  // namespace oddity::truth
