#include "reference/make/03_25_chain.hpp"
#include "reference/make/checkpoints.hpp"
#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

// Growth rate of a change of theta1 at the start: log of the largest |d(position)/d(theta1)| in m/rad after
// the time t, over t. Both routes take central differences of two trajectories that start so close together
// that they are still close after 12 s, when they are 10^16 times as far apart. The number of digits belongs
// to that distance and is fixed, whatever is requested.
namespace oddity::truth {

namespace growth_03_25 {

/// start(apart) -> the start displaced by it; advance(x, t0, t1) -> the state at t1.
template <class Rhs, class Start, class Advance>
Numbers rate(Checkpoints& kept, const Rhs& rhs, const std::vector<double>& in, int digits,
             const Number& apart, const Start& start, const Advance& advance) {
  const double t = in[14];
  const auto end = [&](double side) {
    std::vector<double> motion = motion_of(in, digits);
    motion.push_back(side);
    return rhs.positions(kept.at(
        t, digits, motion, [&] { return start(Number(side * apart)); }, advance));
  };
  const Numbers above = end(1), below = end(-1);
  Number largest = 0;
  for (std::size_t i = 0; i < above.size(); ++i)
    largest = std::max<Number>(largest, abs(Number(above[i] - below[i])) / (2 * apart));
  return {log(largest) / t};
}

Numbers by_tensions(const std::vector<double>& in, int) {
  static Checkpoints kept;
  const TripleStart triple(in);
  const ChainTensions rhs{triple.chain};
  constexpr int digits = 38;
  const auto start = [&](const Number& apart) {
    Numbers x = rhs.start(triple.theta, triple.omega);
    const Number c = cos(apart), s = sin(apart);
    for (std::size_t i : {0u, 6u}) {
      const Number across = x[i], up = x[i + 1];
      x[i] = c * across - s * up;
      x[i + 1] = s * across + c * up;
    }
    return x;
  };
  TaylorProblem problem(rhs, start(0).size());
  return rate(
      kept, rhs, in, digits, pow(Number(10), -digits / 2 - 1), start,
      [&](const Numbers& x, const Number& t0, const Number& t1) { return problem.solve(x, t0, t1, digits); });
}

Numbers by_angles(const std::vector<double>& in, int) {
  static Checkpoints kept;
  const TripleStart triple(in);
  const ChainAngles rhs{triple.chain};
  constexpr int digits = 36;
  const auto start = [&](const Number& apart) {
    Numbers x = triple.angles();
    x[0] += apart;
    return x;
  };
  return rate(kept, rhs, in, digits, pow(Number(10), -digits / 2 - 1), start,
              [&](const Numbers& x, const Number& t0, const Number& t1) {
                return solve_extrapolation(rhs, x, t0, t1, digits);
              });
}

}  // namespace growth_03_25

Truth truth_03_25_growth() {
  using namespace growth_03_25;
  std::vector<std::vector<double>> rows;
  for (double t : {4.0, 8.0, 12.0})
    rows.push_back({1, 0.75, 0.5, 1, 0.75, 0.5, 9.8125, 2.5, 2, 2.5, 3, 0, 0, 0, t});
  for (double t : {8.0})
    rows.push_back({1, 0.75, 0.5, 1, 0.75, 0.5, 9.8125, 2.5, 0.25, 0.375, 0.5, 0, 0, 0, t});
  return {
      "rate at which a change of theta1 grows: log of the largest |d(position)/d(theta1)| after t, over t",
      "log(max_i |d X_i(t) / d theta1(0)|) / t, X in m",
      {"m1", "m2", "m3", "r1", "r2", "r3", "g", "h", "theta1", "theta2", "theta3", "omega1", "omega2",
       "omega3", "t"},
      {{"rate", "1/s"}},
      rows,
      "two Taylor trajectories in Cartesian coordinates, 2e-20 rad apart",
      by_tensions,
      "two trajectories by the extrapolated midpoint rule in the angles, dense mass matrix, 2e-19 rad apart",
      by_angles};
}

}  // namespace oddity::truth
