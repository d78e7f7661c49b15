// Costs of methods, kept from run to run.

#include <fstream>
#include <iterator>

#include "chapters/contents.hpp"
#include "chapters/random.hpp"
#include "reference/files.hpp"
#include "report/cli/asked.hpp"
#include "report/study/prices.hpp"
#include "report/verify/catch.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

const Method verlet{"one angle", "velocity Verlet", {"step", {}}, nullptr};
const Method euler{"one angle", "symplectic Euler", {"step", {}}, nullptr};

/// A clock that never shows the same value twice.
struct Noisy {
  int* calls;
  Time operator()(const Method&, double) const { return {1e-6 * ++*calls, 1e-8}; }
};

/// Prices, as used by a run of the program.
struct Run {
  ScratchFolder folder;
  int calls = 0;

  KeptPrices prices(const std::string& key = "3.5 of a test", bool fresh = false) {
    return {folder.path(), key, fresh, Noisy{&calls}};
  }
  double ask(double setting = 0.5, const std::string& key = "3.5 of a test", bool fresh = false) {
    KeptPrices all = prices(key, fresh);
    const double seconds = all(verlet, setting).seconds;
    all.keep();
    return seconds;
  }
};

}  // namespace

TEST_CASE("a price is measured once, and read back in every bit", "[prices]") {
  Run run;
  const double first = run.ask();
  for (int i = 0; i < 20; ++i) CHECK(run.ask() == first);
  CHECK(run.calls == 1);
  KeptPrices again = run.prices();
  CHECK(again(verlet, 0.5).spread == 1e-8);
  CHECK(again.source().starts_with("those of an earlier run"));
  CHECK(again(euler, 0.5).seconds != first);
  CHECK(again.source().starts_with("in part those of an earlier run"));
  KeptPrices fresh = run.prices("another");
  fresh(verlet, 0.5);
  fresh(verlet, 0.5);
  CHECK(fresh.source().starts_with("measured in this run"));
}

TEST_CASE("when two runs measure at once, the first to keep a price decides it for later ones", "[prices]") {
  Run run;
  KeptPrices one = run.prices(), other = run.prices();
  const double first = one(verlet, 0.5).seconds;
  CHECK(other(verlet, 0.5).seconds != first);
  one.keep();
  other(euler, 0.5);
  other.keep();
  KeptPrices later = run.prices();
  CHECK(later(verlet, 0.5).seconds == first);
  later(euler, 0.5);
  CHECK(run.calls == 3);
}

TEST_CASE("another setting, question, machine or program has separate prices", "[prices]") {
  Run run;
  const double first = run.ask();
  CHECK(run.ask(0.25) != first);
  CHECK(run.ask(0.5, "3.5 of another test") != first);
  CHECK(run.ask() == first);

  const Task swing = task_of("3.5", {}), other = task_of("3.5", {"a=60deg"});
  Need need{0.01};
  const std::string key = price_key(swing, need);
  CHECK(key.find(machine_and_program()) != std::string::npos);
  CHECK(price_key(other, need) != key);
  need.error = 0.02;  // it is judged, and does not change the cost
  CHECK(price_key(swing, need) == key);
  need.horizon = 20;
  CHECK(price_key(swing, need) != key);
  need.horizon = Need{0.01}.horizon;
  need.frames_per_second *= 2;
  CHECK(price_key(swing, need) != key);
}

TEST_CASE("prices measured again on request replace those kept", "[prices]") {
  Run run;
  const double first = run.ask(), second = run.ask(0.5, "3.5 of a test", true);
  CHECK(second != first);
  CHECK(run.ask() == second);
}

TEST_CASE("prices that are damaged anywhere are measured again", "[prices]") {
  Run run;
  run.ask();
  const fs::path file = run.prices().file();
  const std::string whole = text_of(file);
  const auto is_measured_with = [&](const std::string& text) {
    run.folder.file(file.filename().string(), text);
    const int before = run.calls;
    run.prices()(verlet, 0.5);
    return run.calls == before + 1;
  };
  CHECK_FALSE(is_measured_with(whole));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    INFO("cut after " << length);
    CHECK(is_measured_with(whole.substr(0, length)));
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = changed[at] == '7' ? '3' : '7';
    INFO("another character at " << at << ":\n" << changed);
    CHECK(is_measured_with(changed));
  }
  CHECK(is_measured_with(whole + "1\n"));
  CHECK(is_measured_with(std::string(1000, '\0')));
  CHECK_FALSE(is_measured_with(whole));
}

TEST_CASE("prices that no clock can show are measured again, whoever sealed them", "[prices][forged]") {
  Run run;
  run.ask();
  const fs::path file = run.prices().file();
  const std::string key = text_of(file).substr(0, text_of(file).find('\n') + 1);
  const auto asked_with = [&](const std::string& rest) {
    const std::string text = key + "one angle\tvelocity Verlet\t0.5\t" + rest + "\n";
    run.folder.file(file.filename().string(), text + checksum(text) + "\n");
    const int before = run.calls;
    run.prices()(verlet, 0.5);
    return run.calls - before;
  };
  CHECK(asked_with("1e-6\t1e-8") == 0);
  CHECK(asked_with("1e-6\tnan") == 0);  // timed once
  for (const char* rest :
       {"inf\t0", "nan\t0", "0\t0", "-1e-6\t0", "5e-324\t0", "1e-300\t0", "1e300\t0", "1e-6\t-1", "1e-6\tinf",
        "1e-6", "1e-6\t0\t0", "one\ttwo", "1e-6\t1e-8\none angle\tsymplectic Euler\t0.5\tinf\t0"}) {
    INFO(rest);
    CHECK(asked_with(rest) == 1);
  }
}

TEST_CASE("prices that cannot be kept are not kept", "[prices]") {
  const ScratchFolder folder;
  int calls = 0;
  KeptPrices prices(folder.file("a file", ""), "3.5", false, Noisy{&calls});
  CHECK(prices(verlet, 0.5).seconds == prices(verlet, 0.5).seconds);
  CHECK(prices.source().ends_with("kept for the next"));
  CHECK_NOTHROW(prices.keep());
  CHECK(prices.source().find("not kept, as ") != std::string::npos);
  KeptPrices nowhere("/proc/foo/oddity/prices", "3.5", false, Noisy{&calls});
  nowhere(verlet, 0.5);
  CHECK_NOTHROW(nowhere.keep());
  CHECK(nowhere.source().ends_with("not kept, as /proc/foo/oddity/prices cannot be written"));
}

TEST_CASE("a noisy price is measured again in the same run, and the next run has the same", "[prices]") {
  const ScratchFolder folder;
  int calls = 0;
  const auto ask = [&](const std::vector<Time>& clock) {
    calls = 0;
    KeptPrices prices(folder.path(), "3.5 of a test", false,
                      [&](const Method&, double) { return clock.at(static_cast<std::size_t>(calls++)); });
    const double seconds = prices(verlet, 0.5).seconds;
    prices.keep();
    return seconds;
  };
  CHECK(ask({{9e-6, 8e-6}, {7e-6, 6e-6}, {8e-6, 7e-6}, {5e-6, 4e-6}, {6e-6, 5e-6}}) == 5e-6);
  CHECK(calls == 5);
  CHECK(ask({}) == 5e-6);
  CHECK(calls == 0);
  fs::remove(KeptPrices(folder.path(), "3.5 of a test", false).file());
  CHECK(ask({{3e-6, 2e-6}, {4e-6, 1e-8}}) == 4e-6);
  CHECK(calls == 2);
}

TEST_CASE("one question has one answer, however noisy the clock", "[prices][choose]") {
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  const Task top = task_of("3.33", {});
  Need need{0.02};
  need.horizon = 0.5;
  need.only = {"Runge-Kutta", "Euler", "Dormand-Prince"};
  const auto answer = [&](std::uint64_t seed, const fs::path& folder) {
    Random random(static_cast<int>(seed));
    KeptPrices prices(folder, price_key(top, need), false, [&](const Method& m, double setting) -> Time {
      const double seconds = 1e-8 * static_cast<double>(m.run(setting).evaluations);
      return {seconds * random.between(1, 4), seconds * random.between(0, 4)};
    });
    const Choice choice = choose(top, need, truth, std::ref(prices));
    prices.keep();
    REQUIRE(choice.chosen);
    return choice.chosen->model + " by " + choice.chosen->algorithm + " at " +
           std::to_string(choice.chosen->setting);
  };
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ScratchFolder folder;
    const std::string first = answer(seed, folder.path());
    for (std::uint64_t later = 1; later <= 3; ++later)
      CHECK(answer(100 * seed + later, folder.path()) == first);
  }
}
