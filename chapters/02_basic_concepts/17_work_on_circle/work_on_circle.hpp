#pragma once

#include <numbers>
#include <vector>

#include "chapters/02_basic_concepts/shared/bodies.hpp"
#include "solvers/dual.hpp"

/// Exercise 2.17: a particle at (r cos wt, r sin wt, 0) and the power of the forces (1, 1, 1) and (t, t, 1)
/// on it. Shared by the files of the exercise.
namespace oddity::work_on_circle {

using namespace bodies;

using std::abs, std::cos, std::sin, std::sqrt, std::numbers::pi;

/// A circular motion and a time.
template <class G>
struct MotionOf {
  G r, w, T;

  template <class Number>
  std::array<Number, 3> position(const Number& t) const {
    return {r * cos(w * t), r * sin(w * t), 0.0 * t};
  }
  template <class Number>
  std::array<Number, 3> velocity(const Number& t) const {
    const auto moved = position(Dual<Number>(t, Number(1.0)));
    return {moved[0].slope, moved[1].slope, moved[2].slope};
  }
  MotionOf at(const G& time) const { return {r, w, time}; }
  G x() const { return w * T; }
};
using Motion = MotionOf<double>;

enum class Force { constant, growing };

template <class G, class Number>
Number power(Force force, const MotionOf<G>& m, const Number& t) {
  const auto v = m.velocity(t);
  return force == Force::constant ? v[0] + v[1] + v[2] : t * v[0] + t * v[1] + v[2];
}

Quantity work(const Motion&, const Reference&);
Quantity late_work(const Reference&);
/// The growing force's work in a short time, for which the closed form subtracts nearly equal numbers.
Quantity early_work(const Reference&);
/// The maximum after a number of whole turns.
Quantity maximum(const Motion&, double turn, const Reference&);

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::work_on_circle
