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
  constexpr std::chrono::microseconds batch{100};
  constexpr std::size_t batches = 5;
  const auto once = [&] {
    const auto start = Clock::now();
    static_cast<void>(method.run(setting));
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const double first = once();
  const auto runs = static_cast<long>(
      std::clamp(std::chrono::duration<double>(batch).count() / std::max(first, 1e-8), 1.0, 1e4));
  std::vector<double> seconds;
  const std::size_t count = first > once_from ? 1 : batches;
  for (std::size_t b = 0; b < count; ++b) {
    const auto start = Clock::now();
    for (long i = 0; i < runs; ++i) static_cast<void>(method.run(setting));
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count() /
                      static_cast<double>(runs));
  }
  std::ranges::sort(seconds);
  const double spread = count > 1 ? (seconds[(3 * count) / 4] - seconds[count / 4]) / 2
                                  : std::numeric_limits<double>::quiet_NaN();
  return {seconds[count / 2], spread};
}

double seam() {
  constexpr int batches = 9, calls = 100'000;
  const auto model = type_erased(Nothing());
  const ModelInterfaceOf<2>* volatile unseen = model.get();  // by the compiler, as the algorithms' models are
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
