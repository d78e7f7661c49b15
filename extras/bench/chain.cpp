#include "extras/bench/chain.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "chapters/03_rigid_body_motion/25_chain/chain.hpp"
#include "chapters/03_rigid_body_motion/25_chain/links.hpp"
#include "report/study/fit.hpp"

namespace oddity {

namespace {

constexpr int chain_lengths[] = {10, 30, 100, 300, 1000, 3000, 10'000};
constexpr double chain_gravity = 9.81, chain_link = 1, not_timed = std::numeric_limits<double>::quiet_NaN();

/// Seconds per run, the fastest of several batches.
template <class F>
double seconds(const F& f, int runs) {
  double least = std::numeric_limits<double>::infinity();
  for (int batch = 0; batch < 5; ++batch) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < runs; ++i) f();
    least = std::min(least,
                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / runs);
  }
  return least;
}

double time_of_tensions(int n) {
  const ex03_25::Pattern p(n);
  std::vector<double> alpha(p.m.size());
  [[maybe_unused]] volatile double last = 0;
  return seconds(
      [&] {
        chain::by_tensions(p.m, p.r, chain_gravity, p.theta, p.omega, alpha);
        last = alpha.back();
      },
      std::max(1, 20'000 / n));
}

/// Time of the dense matrix, filled in and eliminated.
template <std::size_t n>
double time_of_dense() {
  const ex03_25::Pattern p(n);
  using Numbers = std::array<double, n>;
  const auto array = [](const std::vector<double>& x) {
    Numbers all;
    std::ranges::copy(x, all.begin());
    return all;
  };
  const Numbers mu = array(ex03_25::mass_from_here_on(p.m)), lengths = array(p.r), theta = array(p.theta),
                omega = array(p.omega);
  Numbers alpha{};
  [[maybe_unused]] volatile double last = 0;
  return seconds(
      [&] {
        chain::by_mass_matrix(mu, lengths, chain_gravity, theta, omega, alpha);
        last = alpha.back();
      },
      std::max(1, 300 / static_cast<int>(n)));
}

double time_of_dense(int n) {
  return n == 10    ? time_of_dense<10>()
         : n == 30  ? time_of_dense<30>()
         : n == 100 ? time_of_dense<100>()
                    : not_timed;
}

/// The largest stable step, by bisection to half a percent.
double stable_step(int n) {
  constexpr int steps = 600;
  const double theory = chain::stable_step_of_links(n, chain_gravity, chain_link);
  double low = 0.9 * theory, high = 1.1 * theory;
  while (high - low > 0.005 * theory) {
    const double middle = (low + high) / 2;
    (chain::growth_of_links(n, chain_gravity, chain_link, middle, steps) < 4 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

ChainBench bench_chains(const Progress& progress) {
  constexpr int rounds = 9;
  ChainBench bench;
  for (int n : chain_lengths)
    bench.chains.push_back({n, std::numeric_limits<double>::infinity(), time_of_dense(n), 9 * 8.0 * n,
                            stable_step(n), chain::stable_step_of_links(n, chain_gravity, chain_link)});
  for (int round = 0; round < rounds; ++round) {
    if (progress) progress("timing chains", round, rounds);
    std::vector<double> links, times;
    for (ChainResult& one : bench.chains) {
      const double time = time_of_tensions(one.links);
      one.tensions = std::min(one.tensions, time);
      links.push_back(one.links);
      times.push_back(time);
    }
    bench.slopes.push_back(power_law(links, times).exponent);
  }
  return bench;
}

}  // namespace oddity
