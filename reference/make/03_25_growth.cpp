#include "reference/make/03_25_chain.hpp"
#include "reference/make/taylor.hpp"

// How fast a change of theta1 at the start grows: log of the largest |d(position)/d(theta1)| in m/rad after
// the time t, over t. Both routes take central differences of two trajectories, too near each other for the
// difference's error to be seen.
namespace oddity::truth {

namespace {

template <class End>
Numbers rate(const Number& apart, const Number& t, const End& end) {
  const Numbers above = end(apart), below = end(-apart);
  Number largest = 0;
  for (std::size_t i = 0; i < above.size(); ++i)
    largest = std::max<Number>(largest, abs(Number(above[i] - below[i])) / (2 * apart));
  return {log(largest) / t};
}

Numbers by_tensions(const std::vector<double>& in, int) {
  const TripleStart start(in);
  const ChainTensions rhs{start.chain};
  TaylorProblem problem(rhs, 12);
  return rate(pow(Number(10), -20), in[14], [&](const Number& apart) {
    Numbers x = rhs.start(start.theta, start.omega);
    const Number c = cos(apart), s = sin(apart);
    for (std::size_t i : {0u, 6u}) {
      const Number across = x[i], up = x[i + 1];
      x[i] = c * across - s * up;
      x[i + 1] = s * across + c * up;
    }
    return rhs.positions(problem.solve(x, 0, Number(in[14]), 38));
  });
}

Numbers by_angles(const std::vector<double>& in, int) {
  const TripleStart start(in);
  const ChainAngles rhs{start.chain};
  TaylorProblem problem(rhs, 6);
  return rate(pow(Number(10), -19), in[14], [&](const Number& apart) {
    Numbers x = start.angles();
    x[0] += apart;
    return rhs.positions(problem.solve(x, 0, Number(in[14]), 36));
  });
}

}  // namespace

Truth truth_03_25_growth() {
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
      "two Taylor trajectories in the angles, dense mass matrix, 2e-19 rad apart",
      by_angles};
}

}  // namespace oddity::truth
