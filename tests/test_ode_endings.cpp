// Endings of integrations: at the requested times with the work counted, or with the reason why not.

#include "report/verify/catch.hpp"
#include "solvers/ode/catalog.hpp"
#include "tests/near.hpp"
#include "tests/ode_algorithms.hpp"

using namespace oddity;
using namespace oddity::ode;
using namespace problems;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Evaluations of n fixed steps of two unknowns: those in the catalog, those of a starter, and those of a
/// Jacobian by differences.
template <class Algorithm>
long evaluations_of(long n) {
  const auto entry = *std::ranges::find(catalog(), Algorithm::name, &CatalogEntry::name);
  const long a_step = entry.evaluations + (entry.jacobian ? 4 : 0);
  const auto starting = [=](long steps, long each) {
    return std::min(n, steps) * each + std::max(0L, n - steps) * a_step;
  };
  if (std::is_same_v<Algorithm, AdamsBashforth4>) return starting(3, 4);
  if (std::is_same_v<Algorithm, AdamsBashforthMoulton6>) return starting(5, 13);
  return n * a_step + std::is_same_v<Algorithm, VelocityVerlet>;
}

template <class Algorithm>
ode::Trajectory<State> through(const Problem& problem, std::vector<double> times, double setting) {
  return integrate<Algorithm>(problem.system, problem.exact(times[0]), std::span<const double>(times),
                              setting);
}

}  // namespace

// ---- reached ----------------------------------------------------------------------------------------------

TEST_CASE("a fixed step costs its stages, some a starter, and an implicit one its Jacobian", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (!has_tolerance(Algorithm::kind)) {
      const auto evaluations = [](double end, double step) {
        return integrate<Algorithm>(oscillator.system, State{1, 0}, 0, end, step).evaluations;
      };
      CHECK(evaluations(1, 0.125) == evaluations_of<Algorithm>(8));
      CHECK(evaluations(1, 0.1) == evaluations_of<Algorithm>(10));
      CHECK(evaluations(1, 0.3) == evaluations_of<Algorithm>(4));
      CHECK(evaluations(-1, 0.3) == evaluations_of<Algorithm>(4));
      CHECK(evaluations(1, 5) == evaluations_of<Algorithm>(1));
    }
  });
}

TEST_CASE("a controlled step costs its stages, Dormand-Prince's last stage being the next one's first",
          "[solvers]") {
  const auto evaluations = []<class Algorithm>() {
    return integrate<Algorithm>(oscillator.system, State{1, 0}, 0, 5, 1e-6).evaluations;
  };
  CHECK(evaluations.operator()<CashKarp54>() % 6 == 0);
  CHECK(evaluations.operator()<DormandPrince54>() % 6 == 1);
  CHECK(evaluations.operator()<Fehlberg78>() % 13 == 0);
  CHECK(evaluations.operator()<DormandPrince853>() % 12 == 0);
  CHECK(evaluations.operator()<Verner98>() % 16 == 0);
  CHECK(evaluations.operator()<Rk8pd>() % 13 == 1);
}

TEST_CASE("the evaluations reported are the calls that were made", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if (info<Algorithm>().by_series) return;  // it makes none: the tests of solvers/taylor count
    const System system{oscillator.system.f};
    const std::vector<double> times{0, 1, 1, 2.5};
    const auto solved =
        integrate<Algorithm>(system, State{1, 0}, std::span<const double>(times), fine<Algorithm>);
    CHECK(solved.reached());
    const int before = Algorithm::kind == Kind::velocities_first ? 2 : 0;  // calls that look for the
                                                                           // velocities
    CHECK(solved.evaluations + before == system.calls);
  });
}

TEST_CASE("every requested time is reached exactly, in steps that join", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    for (const std::vector<double>& times : {std::vector{0.1, 0.35, 0.7, 1.2}, {1.2, 0.7, 0.35, 0.1}}) {
      std::size_t hits = 0;
      double last = times[0];
      const auto watch = [&](double t, const State&, double t_next, const State&) {
        if (t != last) FAIL("a step from " << t << " after one to " << last);
        last = t_next;
        hits += std::count(times.begin() + 1, times.end(), t_next) == 1;
        return false;
      };
      const auto solved = integrate<Algorithm>(separatrix.system, separatrix.exact(times[0]),
                                               std::span<const double>(times), fine<Algorithm>, watch);
      CHECK(solved.reached());
      CHECK(hits == 3);
      CHECK(last == times.back());
      for (std::size_t i = 0; i < times.size(); ++i)
        CHECK(distance(solved.value[i], separatrix.exact(times[i])) < 3e-3);
    }
  });
}

TEST_CASE("times may repeat, turn back, or be a single one", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto repeated = through<Algorithm>(separatrix, {0, 0, 1, 1, 1}, fine<Algorithm>);
    CHECK(repeated.reached());
    CHECK(repeated.value.size() == 5);
    CHECK(repeated.value[0] == repeated.value[1]);
    CHECK(repeated.value[2] == repeated.value[4]);

    const std::vector<double> zigzag{0, 1, -0.5, 0};
    const auto turned = through<Algorithm>(separatrix, zigzag, fine<Algorithm>);
    CHECK(turned.reached());
    for (std::size_t i = 0; i < zigzag.size(); ++i)
      CHECK(distance(turned.value[i], separatrix.exact(zigzag[i])) < 5e-3);

    for (const auto& still : {through<Algorithm>(separatrix, {2}, fine<Algorithm>),
                              through<Algorithm>(separatrix, {2, 2}, fine<Algorithm>)}) {
      CHECK(still.reached());
      CHECK(still.evaluations == 0);
      CHECK(still.value.back() == separatrix.exact(2));
    }
  });
}

TEST_CASE("far from zero, where time is coarse, the algorithms still advance", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const double t0 = 1e12;  // one unit in the last place is 1e-4
    const auto solved = integrate<Algorithm>(oscillator.system, State{1, 0}, t0, t0 + 1,
                                             has_tolerance(Algorithm::kind) ? 1e-6 : 0x1p-10);
    CHECK(solved.reached());
    CHECK(near(solved.value[0], std::cos(1), 1e-3));
  });
}

TEST_CASE("a watcher can end the integration", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    int steps = 0;
    const auto third = [&](double, const State&, double, const State&) { return ++steps == 3; };
    const bool by_series = info<Algorithm>().by_series;  // in long steps
    const std::array times{0.0, by_series ? 20.0 : 1.0};
    const auto solved = integrate<Algorithm>(oscillator.system, State{1, 0}, std::span<const double>(times),
                                             fine<Algorithm>, third);
    CHECK(solved.reached());
    CHECK(steps == 3);
    CHECK(solved.value.size() == 2);
    CHECK(within(solved.value.back()[0], by_series ? -1 : 0.9, 1));
  });
}

// ---- not reached ------------------------------------------------------------------------------------------

TEST_CASE("no algorithm that engines use gets past a pole", "[solvers]") {
  for_each_common_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const bool controlled = has_tolerance(Algorithm::kind);
    for (double setting :
         controlled ? std::vector{1e-1, 1e-2, 1e-4, 1e-8, 1e-12} : std::vector{1e-2, 1e-3, 1e-4}) {
      const auto solved = integrate<Algorithm>(pole.system, pole.exact(0), 0, 2, setting);
      CHECK(solved.ending == (controlled ? Ending::stalled : Ending::non_finite));
      CHECK(solved.message.find("at t = 1") != std::string::npos);
      CHECK(solved.evaluations < 50'000);
    }
  });
}

TEST_CASE("no other algorithm gets past a pole, except linearly implicit Euler", "[solvers]") {
  // A tolerance of 1e-4 may miss the pole's time by 0.3 %.
  for_each_other_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const bool controlled = has_tolerance(Algorithm::kind);
    for (double setting : controlled ? std::vector{1e-4, 1e-8} : std::vector{1e-2, 1e-3}) {
      const auto solved = integrate<Algorithm>(pole.system, pole.exact(0), 0, 2, setting);
      CHECK(solved.reached() == std::is_same_v<Algorithm, ImplicitEuler>);
      if (solved.reached()) continue;
      INFO(solved.message);
      CHECK(solved.ending == (controlled ? Ending::stalled : Ending::non_finite));
      CHECK((solved.message.find("at t = 1") != std::string::npos ||
             solved.message.find("at t = 0.99") != std::string::npos));
      CHECK(solved.evaluations < 50'000);
    }
  });
}

TEST_CASE("a fixed step that is too long for the pole passes it, with an absurd number", "[solvers]") {
  const auto solved = integrate<ExplicitEuler>(pole.system, pole.exact(0), 0, 2, 0.1);
  CHECK(solved.reached());
  CHECK(solved.value[0] > 1e30);
}

TEST_CASE("a right-hand side of NaN is never passed", "[solvers]") {
  const System system = generic([](const auto& x, auto& dxdt, auto) {
    using std::sqrt;
    dxdt = {x[1], -sqrt(x[0])};
  });
  for_each_algorithm([&]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto solved = integrate<Algorithm>(system, State{1, 0}, 0, 10, fine<Algorithm>);
    CHECK_FALSE(solved.reached());
  });
}

TEST_CASE("without a Jacobian there is no result, whatever the memory contained before", "[solvers]") {
  const auto root = [](const State& x, State& dxdt, double) { dxdt = {-std::sqrt(x[0]), 0}; };
  CHECK(integrate<ImplicitEuler>(root, State{1e-6, 0}, 0, 1e-3, 1e-3).ending == Ending::non_finite);
  CHECK_FALSE(integrate<Rosenbrock4>(root, State{1e-6, 0}, 0, 1e-3, 1e-6).reached());
}

TEST_CASE("without time nothing moves", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    for (const double t : {0.0, 2.0}) {
      const std::array times{t, t};
      const auto solved = integrate<Algorithm>(oscillator.system, State{1, 0}, times, fine<Algorithm>);
      CHECK(solved.reached());
      CHECK(solved.value.back() == State{1, 0});
    }
  });
}

TEST_CASE("a start that is not finite gives no result", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    for (double bad : {no_number, infinity})
      CHECK_FALSE(integrate<Algorithm>(oscillator.system, State{bad, 0}, 0, 1, fine<Algorithm>).reached());
  });
}

TEST_CASE("a step or tolerance that is zero, negative or not finite is refused", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    for (double setting : {0.0, -0.1, no_number, infinity}) {
      const auto solved = integrate<Algorithm>(oscillator.system, State{1, 0}, 0, 1, setting);
      CHECK(solved.ending == Ending::raised);
      CHECK(solved.evaluations == 0);
    }
  });
}

TEST_CASE("times that are not finite, and no times, are refused", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    for (double bad : {no_number, infinity, -infinity})
      CHECK(integrate<Algorithm>(oscillator.system, State{1, 0}, 0, bad, fine<Algorithm>).ending ==
            Ending::raised);
    CHECK(integrate<Algorithm>(oscillator.system, State{1, 0}, std::span<const double>(), fine<Algorithm>)
              .ending == Ending::raised);
  });
}

TEST_CASE("a fixed step beyond the budget is refused before it starts", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (!has_tolerance(Algorithm::kind)) {
      for (double step : {1e-9, 1e-300}) {
        const auto solved = integrate<Algorithm>(oscillator.system, State{1, 0}, 0, 1, step);
        CHECK(solved.ending == Ending::stalled);
        CHECK(solved.evaluations == 0);
      }
    }
  });
}

TEST_CASE("the budget of evaluations ends an endless integration", "[solvers]") {
  const auto at_rest = [](const State&, State& dxdt, double) { dxdt = {0, 0}; };
  const auto solved = integrate<RungeKutta4>(at_rest, State{1, 0}, 0, 1, 1.0 / (budget / 2));
  CHECK(solved.ending == Ending::stalled);
  CHECK(within(static_cast<double>(solved.evaluations), budget, budget + 100));
}

TEST_CASE("a limit lowers the budget during its lifetime", "[solvers]") {
  const auto ended = [] {
    return integrate<RungeKutta4>(oscillator.system, State{1, 0}, 0, 1, 1.0 / 500);  // 2000 evaluations
  };
  {
    const EvaluationLimit limit(1000);
    const EvaluationLimit higher(1e9);
    CHECK(ended().ending == Ending::stalled);
    CHECK(ended().evaluations < 1100);
  }
  CHECK(ended().reached());
}

TEST_CASE("a tolerance below rounding stalls or is met, and always ends", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (has_tolerance(Algorithm::kind)) {
      const auto solved = integrate<Algorithm>(oscillator.system, State{1, 0}, 0, 1, 1e-19);
      CHECK((solved.ending == Ending::stalled || solved.ending == Ending::reached));
      if (solved.reached()) CHECK(near(solved.value[0], std::cos(1), 1e-10));
    }
  });
}

TEST_CASE("an exception of the right-hand side passes through every algorithm, and leaves nothing behind",
          "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if (info<Algorithm>().by_series) return;  // it sees no numbers
    const System system{[](const State& x, State& dxdt, double) {
      if (x[0] < 0.5) throw std::domain_error("beyond the wall");
      dxdt = {x[1], -x[0]};
    }};
    CHECK_THROWS_WITH(integrate<Algorithm>(system, State{1, 0}, 0, 3, fine<Algorithm>), "beyond the wall");
    CHECK(integrate<Algorithm>(oscillator.system, State{1, 0}, 0, 1, fine<Algorithm>).reached());
  });
}
