#include "reference/make/03_25_chain.hpp"

#include <algorithm>

#include "reference/make/checkpoints.hpp"
#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

// Positions of the triple pendulum's masses at time t. Neighbouring trajectories diverge exponentially, so
// both routes work with extra digits.
namespace oddity::truth {

namespace chain_03_25 {

/// After 4 s neighbouring trajectories of the large-angle start diverge so fast that 42 digits would take
/// minutes per row.
Precision digits_at(double t, Precision asked) {
  return {t > 4 ? std::min(asked.digits, 32) : asked.digits, asked.kept};
}

Numbers by_tensions(const std::vector<double>& in, Precision asked) {
  static Checkpoints kept;
  const TripleStart start(in);
  const ChainTensions rhs{start.chain};
  const Precision digits = digits_at(in[14], asked);
  return rhs.positions(kept.at(
      in[14], digits, motion_of(in, digits), [&] { return rhs.start(start.theta, start.omega); },
      [&](const Numbers& x, const Number& t0, const Number& t1) {
        return solve_taylor(rhs, x, t0, t1, digits + 4);
      }));
}

Numbers enclosed(const std::vector<double>& in, Precision digits) {
  const TripleStart start(in);
  const ChainTensions rhs{start.chain};
  return rhs.positions(solve_taylor(rhs, rhs.start(start.theta, start.omega), 0, Number(in[14]), digits + 4));
}

Numbers by_angles(const std::vector<double>& in, Precision asked) {
  static Checkpoints kept;
  const TripleStart start(in);
  const ChainAngles rhs{start.chain};
  const Precision digits = digits_at(in[14], asked);
  return rhs.positions(kept.at(
      in[14], digits, motion_of(in, digits), [&] { return start.angles(); },
      [&](const Numbers& x, const Number& t0, const Number& t1) {
        return solve_extrapolation(rhs, x, t0, t1, digits + 4);
      }));
}

}  // namespace chain_03_25

Truth truth_03_25_chain() {
  using namespace chain_03_25;
  const std::vector<double> chain{1, 0.75, 0.5, 1, 0.75, 0.5, 9.8125, 2.5};
  std::vector<std::vector<double>> rows;
  const auto add = [&](const std::vector<double>& start, const std::vector<double>& times) {
    for (double t : times) {
      rows.push_back(chain);
      rows.back().insert(rows.back().end(), start.begin(), start.end());
      rows.back().push_back(t);
    }
  };
  for (double theta1 : {0.0625, 0.25, 0.5, 1.0, 1.5}) add({theta1, 0.375, 0.5, 0, 0, 0}, {1, 2, 3, 4});
  add({0x1p-10, 0x1.8p-10, 0x1p-9, 0, 0, 0}, {1, 2, 3, 4});
  add({2, 2.5, 3, 0, 0, 0}, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  return {
      "positions of the three masses of a chain t after it was let go, pivot at (0, h), theta from the "
      "downward vertical",
      "d/dt dL/dtheta_i' = dL/dtheta_i",
      {"m1", "m2", "m3", "r1", "r2", "r3", "g", "h", "theta1", "theta2", "theta3", "omega1", "omega2",
       "omega3", "t"},
      {{"x1", "m"}, {"y1", "m"}, {"x2", "m"}, {"y2", "m"}, {"x3", "m"}, {"y3", "m"}},
      rows,
      "Taylor series in Cartesian coordinates with tensions",
      by_tensions,
      "extrapolated midpoint rule in the angles, dense mass matrix",
      by_angles,
      "the first route, the remainders bounded",
      enclosed};
}

}  // namespace oddity::truth
