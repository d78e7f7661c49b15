// Work that is asked to stop, or in which something throws, ends. Its unfinished part is never taken for
// finished.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <future>
#include <numeric>
#include <thread>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "report/study/choose.hpp"
#include "report/study/in_time.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/parallel.hpp"
#include "report/study/stability.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/stability.hpp"
#include "solvers/ode/steps_in.hpp"
#include "solvers/stop.hpp"
#include "tests/in_environment.hpp"

using namespace oddity;
using namespace std::chrono_literals;

namespace {

struct Thrown {};

/// Ends the whole program with a message if something waits forever: a hanging thread cannot be ended.
template <class F>
void must_end(const std::string& what, const F& f) {
  std::promise<void> over;
  std::jthread watch([&, done = over.get_future()] {
    if (done.wait_for(60s) == std::future_status::ready) return;
    std::fprintf(stderr, "waits for ever: %s\n", what.c_str());
    std::abort();
  });
  f();
  over.set_value();
}

/// Wall time and CPU time. On a busy machine wall time is long; if threads only wait, CPU time is short.
struct Moment {
  std::chrono::steady_clock::time_point at = std::chrono::steady_clock::now();
  std::clock_t worked = std::clock();

  double seconds_since() const {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - at;
    return std::min(passed.count(), static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
  }
};

/// Throws at its nth call, in any thread.
class ThrowsAt {
 public:
  explicit ThrowsAt(long nth) : left_(nth) {}
  void operator()() const {
    if (--left_ != 0) return;
    thrown_ = Moment();
    throw Thrown();
  }
  long calls_left() const { return left_; }
  /// Seconds since it threw.
  double seconds() const { return thrown_.seconds_since(); }

 private:
  mutable std::atomic<long> left_;
  mutable Moment thrown_;
};

#ifdef __SANITIZE_THREAD__
constexpr double at_once = 10;  // s
#else
constexpr double at_once = 1;
#endif

Need brief() {
  Need need = game_need();
  need.horizon = 1;
  need.frames_per_second = 30;
  return need;
}

/// A choice in which `at` is called between pieces of work: at every progress report and for every price.
template <class At>
void choose_with(const Entry& entry, const Need& need, const At& at) {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Price price = [&](const Method& method, double setting) {
    at();
    return Time{1e-9 * static_cast<double>(method.run(setting).evaluations), 0};
  };
  choose(Task(entry), need, truth, price, [&](const std::string&, double, std::size_t) { at(); });
}

std::vector<const Entry*> scenes() {
  std::vector<const Entry*> all;
  for (const Entry& entry : registry())
    if (entry.exercise.scene) all.push_back(&entry);
  return all;
}

}  // namespace

TEST_CASE("a parallel loop runs completely, or throws", "[stop][parallel]") {
  for (int trial = 0; trial < 50; ++trial) {
    std::atomic<int> taken_for_done = 0;
    const auto inner = [&] {
      std::vector<int> done(64, 0);
      in_parallel(done.size(), [&](std::size_t i) {
        std::this_thread::sleep_for(20us);
        done[i] = 1;
      });
      if (std::accumulate(done.begin(), done.end(), 0) != 64) ++taken_for_done;
    };
    CHECK_THROWS_AS(in_parallel(8,
                                [&](std::size_t i) {
                                  if (i == 3) throw Thrown();
                                  inner();
                                }),
                    Thrown);
    CHECK(taken_for_done == 0);
  }
}

TEST_CASE("a parallel loop passes its stop on to its threads", "[stop][parallel]") {
  Stop stop;
  const Stoppable here(&stop);
  std::atomic<int> begun = 0;
  CHECK_THROWS_AS(in_parallel(1000,
                              [&](std::size_t) {
                                ++begun;
                                stop.request();
                                check_stop();
                              }),
                  Stopped);
  CHECK(begun < 1000);
  CHECK_THROWS_AS(check_stop(), Stopped);
}

TEST_CASE("a stop ends with its time, and with the enclosing one", "[stop]") {
  const Stop never;
  CHECK_FALSE(never.is_requested());
  CHECK(Stop(0.0).is_requested());
  CHECK_FALSE(Stop(1e300).is_requested());
  Stop around;
  const Stop inside(&around);
  CHECK_FALSE(inside.is_requested());
  around.request();
  CHECK(inside.is_requested());
}

TEST_CASE("a choice ends wherever something throws in it", "[stop][choose]") {
  for (const Entry* entry : scenes()) {
    const ThrowsAt never(0);
    choose_with(*entry, brief(), never);
    const long calls = -never.calls_left();
    INFO(to_string(entry->number) << ": " << calls << " calls");
    CHECK(calls > 10);
    const long throws = in_environment("ODDITY_THROWS", 56);
    for (long k = 0; k < throws; ++k) {
      const long nth = 1 + k * calls * 9 / 10 / throws;  // the last calls differ from run to run
      const ThrowsAt throws_at(nth);
      must_end(to_string(entry->number) + " thrown at in call " + std::to_string(nth),
               [&] { CHECK_THROWS_AS(choose_with(*entry, brief(), std::cref(throws_at)), Thrown); });
      INFO("thrown at in call " << nth);
      CHECK(throws_at.seconds() < at_once);
    }
  }
}

TEST_CASE("a choice ends with its time limit", "[stop][choose]") {
  const auto nothing = [] {};
  for (const Entry* entry : scenes())
    for (double limit : {1e-4, 1e-3, 3e-3, 1e-2, 3e-2}) {
      Need need = brief();
      need.time_limit = limit;
      need.horizon = 20;
      must_end(to_string(entry->number) + " within " + std::to_string(limit) + " s", [&] {
        try {
          choose_with(*entry, need, nothing);
        } catch (const OutOfTime&) {
        }
      });
    }
}

TEST_CASE("a time limit of zero or less leaves no time", "[stop][choose]") {
  for (double left : {0.0, -1.0}) {
    Need need = brief();
    need.time_limit = left;
    CHECK_THROWS_AS(choose_with(*scenes().front(), need, [] {}), OutOfTime);
  }
}

TEST_CASE("a frame of n steps has n, at any time", "[stop][steps]") {
  for (double rate : {24.0, 30.0, 50.0, 60.0, 90.0, 120.0, 144.0, 240.0, 1000.0, 1001.0})
    for (int n : {1, 2, 3, 4, 7, 12, 48, 512})
      for (long frame : {0L, 1L, 7L, 599L, 7'800L, 100'000L, 3'600'000L, 40'000'000L}) {
        const double t0 = static_cast<double>(frame) / rate, t1 = static_cast<double>(frame + 1) / rate;
        INFO(rate << " Hz, " << n << " steps, frame " << frame);
        CHECK(ode::steps_in(t0, t1, 1 / (rate * n)) == n);
        CHECK(ode::steps_in(t1, t0, 1 / (rate * n)) == n);
      }
  CHECK(ode::steps_in(0, 1, 0.3) == 4);
  CHECK(ode::steps_in(0, 1, 2) == 1);
  CHECK(ode::steps_in(5, 5, 2) == 1);
  CHECK(ode::steps_in(0, 1, 1 - 1e-9) == 2);
}

TEST_CASE("the search for theory's limits can be stopped", "[stop][stability]") {
  Stop stop;
  const Stoppable here(&stop);
  // x'' = -x, whose second unknown is a velocity
  const ode::Spectrum oscillation{10, {{{0, 1}, {0, -1}}}, {{0, 1, -1, 0}}, {false, true}};
  CHECK(ode::growth("Runge-Kutta 4", {-1, 0}) < 0);
  CHECK(ode::stable_step("semi-implicit Euler", oscillation) > 1.9);
  stop.request();
  CHECK_THROWS_AS(ode::growth("Runge-Kutta 4", {-1, 0}), Stopped);
  CHECK_THROWS_AS(ode::stable_step("semi-implicit Euler", oscillation), Stopped);
}

TEST_CASE("limits and trials end with their time limit", "[stop][stability]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  for (const Entry* entry : scenes()) {
    const Task task(*entry);
    Results blank;
    blank.exercises.emplace_back().number = entry->number;
    const auto within = [](double limit, const auto& work) {
      try {
        in_time(limit, "less", [&] { static_cast<void>(work()); });
      } catch (const OutOfTime&) {
      }
    };
    for (double limit : {0.0, 1e-3, 1e-2, 0.1}) {
      must_end(to_string(entry->number) + " within " + std::to_string(limit) + " s", [&] {
        within(limit, [&] { return with_stability(blank, std::span(&task, 1), truth); });
        within(limit, [&] { return run(std::span(&task, 1), truth, true); });
      });
    }
    CHECK_THROWS_AS(in_time(0, "less", [&] { return with_stability(blank, std::span(&task, 1), truth); }),
                    OutOfTime);
  }
}
