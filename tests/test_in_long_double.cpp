// Motions in long double and in double: they go through the rows of the tables, within their stated errors.

#include <algorithm>
#include <map>

#include "chapters/contents.hpp"
#include "chapters/random.hpp"
#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/in_long_double.hpp"
#include "reference/truth.hpp"
#include "report/study/parallel.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

constexpr std::size_t compared = 48;

const Reference& known() {
  static const Reference all(std::string(ODDITY_SOURCE) + "/reference");
  return all;
}

/// A motion with rows in a table.
struct Rows {
  std::string table;
  std::vector<double> inputs, times;
};

std::vector<Rows> motions_of(const truth::Entry& entry) {
  std::map<std::vector<double>, std::vector<double>> motions;
  for (std::vector<double> row : entry.make().rows) {
    const double t = row.back();
    row.pop_back();
    if (t >= 0) motions[row].push_back(t);
  }
  std::vector<Rows> all;
  for (auto& [inputs, times] : motions) {
    std::ranges::sort(times);
    all.push_back({std::string(entry.name), inputs, times});
  }
  return all;
}

/// Up to `count` random motions of every table that long double can compute.
std::vector<Rows> random_motions(int count) {
  Random random(15);
  std::vector<Rows> all;
  for (const truth::Entry& entry : truth::registry()) {
    if (entry.make().inputs.back() != "t") continue;
    std::vector<Rows> motions = motions_of(entry);
    for (int i = 0; i < count && !motions.empty(); ++i) {
      const auto at =
          std::min(motions.size() - 1,
                   static_cast<std::size_t>(random.between(0, static_cast<double>(motions.size()))));
      all.push_back(motions[at]);
      motions.erase(motions.begin() + static_cast<std::ptrdiff_t>(at));
    }
  }
  return all;
}

struct Compared {
  bool made = false;
  double off = 0, error = 0, size = 0;  ///< largest values
};

/// Compares with the rows; `off` is in units of the sum of both errors.
Compared with_the_rows(const Rows& motion, BoundedBy bound = BoundedBy::routes,
                       const decltype(motion_in_double)& motion_in = motion_in_long_double) {
  const auto made = motion_in(motion.table, motion.inputs, motion.times, compared, {}, bound);
  if (!made) return {};
  Compared all{true, 0, made->error, 0};
  const std::size_t parts = made->value.size() / motion.times.size();
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    std::vector<double> row = motion.inputs;
    row.push_back(motion.times[k]);
    const Known stored = known()(motion.table, row);
    for (std::size_t i = 0; i < parts; ++i) {
      const double off = std::abs(made->value[k * parts + i] - stored.value[i]);
      all.off = std::max(all.off, off / (made->error_until[k] + stored.error));
      all.size = std::max(all.size, std::abs(stored.value[i]));
    }
  }
  return all;
}

}  // namespace

TEST_CASE("random motions in long double and in double go through the rows of their tables", "[truth]") {
  const std::vector<Rows> motions = random_motions(2);
  for (const auto& [motion_in, precise] :
       {std::pair(&motion_in_long_double, 1e-9), std::pair(&motion_in_double, 1e-6)}) {
    std::vector<Compared> all(motions.size());
    in_parallel(motions.size(), [&, motion_in = motion_in](std::size_t i) {
      all[i] = with_the_rows(motions[i], BoundedBy::routes, *motion_in);
    });
    int exact = 0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (!all[i].made) continue;
      INFO(motions[i].table << " to t = " << motions[i].times.back() << ", error " << all[i].error);
      CHECK(all[i].off <= 1);
      if (all[i].error < precise * std::max(1.0, all[i].size)) ++exact;
    }
    CHECK(exact >= 36);
  }
}

TEST_CASE("every scene's motion is available in long double", "[truth]") {
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Quantity seen = motion(*entry.exercise.scene, Parameters(entry.exercise.parameters), {1, 1, 60},
                                 known().to_digits(digits_in_long_double));
    INFO(to_string(entry.number) << ": " << seen.reference.by);
    CHECK(seen.reference.by.find("in long double") != std::string::npos);
    CHECK(seen.reference_error < 1e-10);
  }
}

TEST_CASE("motions in double are within their stated errors at every frame, from starts next to each scene's",
          "[truth]") {
  Random random(31);
  int in_double = 0;
  for (const Entry& entry : registry()) {
    if (!entry.exercise.scene) continue;
    const Scene& scene = *entry.exercise.scene;
    for (int i = 0; i < 3; ++i) {
      Parameters p(entry.exercise.parameters);
      for (std::string_view name : scene.perturbed_parameters) {
        const auto declared = std::ranges::find(p.declared(), name, &Parameter::name);
        p.set(name, std::clamp(declared->value * random.between(0.9, 1.1), declared->least, declared->most));
      }
      const Horizon horizon = i == 0 ? Horizon{360 * scene.horizon, 5400} : Horizon{6 * scene.horizon, 360};
      const Quantity fast = motion(scene, p, horizon, known().to_digits(digits_in_double)),
                     slow = motion(scene, p, horizon, known().to_digits(digits_in_long_double));
      INFO(to_string(entry.number) << ": " << fast.reference.by);
      if (fast.reference.by.find("in double") == std::string::npos) continue;
      ++in_double;
      const std::size_t parts = fast.reference.value.size() / static_cast<std::size_t>(fast.samples);
      for (std::size_t k = 0; k < fast.reference.value.size(); ++k) {
        const double off = std::abs(fast.reference.value[k] - slow.reference.value[k]);
        if (!(off <= fast.reference_error_until[k / parts] + slow.reference_error))
          FAIL_CHECK("frame " << k / parts << " is off by " << off);
      }
    }
  }
  CHECK(in_double >= 48);
}

TEST_CASE("a motion that long double cannot follow has a large stated error", "[truth]") {
  const Rows wide{"03_25_chain",
                  {1, 0.75, 0.5, 1, 0.75, 0.5, 9.8125, 2.5, 2, 2.5, 3, 0, 0, 0},
                  {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
  const Compared all = with_the_rows(wide), by_repeats = with_the_rows(wide, BoundedBy::repeats);
  REQUIRE(all.made);
  CHECK(all.off <= 1);
  CHECK(all.error > 1e-9);
  CHECK(by_repeats.off <= 1);
  CHECK(by_repeats.error == all.error);  // at the end the routes disagree
}

TEST_CASE("repeats bound roundings on chaotic chains from any start", "[truth]") {
  Random random(5);
  const std::vector<double> times{6, 7, 8};
  for (int i = 0; i < 3; ++i) {
    std::vector<double> chain{1, 0.75, 0.5, 1, 0.75, 0.5, 9.8125, 2.5};
    for (const double least : {1.8, 0.3, 0.3}) chain.push_back(random.between(least, least + 1.2));
    chain.insert(chain.end(), 3, 0.0);
    const auto routes = motion_in_long_double("03_25_chain", chain, times, compared, {});
    const auto repeats = motion_in_long_double("03_25_chain", chain, times, compared, {}, BoundedBy::repeats);
    const Known exact = known().to_digits(digits_in_long_double + 1).motion("03_25_chain", chain, times);
    REQUIRE(routes);
    REQUIRE(repeats);
    CHECK(repeats->value == routes->value);
    CHECK(repeats->error <= routes->error);
    const std::size_t parts = exact.value.size() / times.size();
    for (std::size_t k = 0; k < exact.value.size(); ++k)
      CHECK(std::abs(exact.value[k] - repeats->value[k]) <= repeats->error_until[k / parts] + exact.error);
  }
}

TEST_CASE("an unknown or impossible motion has no result in long double", "[truth]") {
  CHECK_FALSE(motion_in_long_double("04_99_nothing", {1}, std::vector{1.0}, compared, {}));
  // A hill without a second half axis.
  CHECK_FALSE(motion_in_long_double("03_11_hill", {1, 0, 10, 0, 0, 2, 2}, std::vector{1.0}, compared, {}));
}

TEST_CASE("an exception of the tick ends a motion in long double", "[truth]") {
  const auto over = [](double) { throw OutOfTime("over"); };
  CHECK_THROWS_AS(motion_in_long_double("03_05_swing", {0.7, 1, 9.81}, std::vector{1.0}, compared, over),
                  OutOfTime);
}
