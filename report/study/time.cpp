#include "report/study/time.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <vector>

#include "chapters/scene.hpp"

namespace oddity {

namespace {

using Clock = std::chrono::steady_clock;

/// A model that computes nothing.
struct Nothing {
  using State = std::array<double, 2>;
  State start() const { return {}; }
  void operator()(const State&, State&, double) const {}
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
};

}  // namespace

Time time(const Method& method, double setting, double once_from) {
  constexpr double batch = 1e-4, lengthy = 1e-3;  // s
  const auto seconds_of = [&](long runs) {
    const auto start = Clock::now();
    for (long i = 0; i < runs; ++i) static_cast<void>(method.run(setting));
    return std::chrono::duration<double>(Clock::now() - start).count() / static_cast<double>(runs);
  };
  const double first = seconds_of(1);
  if (first > once_from) return {first, std::numeric_limits<double>::quiet_NaN()};
  const auto runs = static_cast<long>(std::clamp(batch / std::max(first, 1e-8), 1.0, 1e4));
  std::vector<double> seconds;
  if (runs == 1) seconds.push_back(first);
  const std::size_t count = first > lengthy ? 3 : 5;
  while (seconds.size() < count) seconds.push_back(seconds_of(runs));
  std::ranges::sort(seconds);
  return {seconds[count / 2], (seconds[(3 * count) / 4] - seconds[count / 4]) / 2};
}

double seam() {
  constexpr int batches = 9, calls = 100'000;
  const auto model = type_erased(Nothing());
  const ModelInterfaceOf<2>* volatile unseen = model.get();  // hidden from the compiler, as models are
  const ModelInterfaceOf<2>& system = *unseen;
  std::array<double, 2> x{}, dxdt{};
  std::array<double, batches> seconds{};
  for (double& each : seconds) {
    const auto start = Clock::now();
    for (int i = 0; i < calls; ++i) system(x, dxdt, 0);
    each = std::chrono::duration<double>(Clock::now() - start).count() / calls;
  }
  std::ranges::sort(seconds);
  return seconds[batches / 2];
}

}  // namespace oddity
