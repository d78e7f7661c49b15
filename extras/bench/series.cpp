#include "extras/bench/series.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "chapters/scene.hpp"
#include "extras/bench/fresh_pages.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/text/table_text.hpp"

namespace oddity {

namespace {

constexpr double series_error = 1e-12, no_ratio = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view taylor_series = "Taylor series";
constexpr long most_of_series_race = 3'000'000;

/// Settings from coarse to fine: tolerances of half decades, or steps.
std::vector<double> settings_to_try(const Method& method, double horizon) {
  std::vector<double> all;
  if (method.resolution.name == "tolerance")
    for (int k = 16; k <= 31; ++k) all.push_back(std::pow(10, -k / 2.0));
  else
    for (int k = 5; k <= 19; ++k) all.push_back(std::ldexp(horizon, -k));
  return all;
}

double seconds(const Method& method, double setting, int runs) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < runs; ++i) static_cast<void>(method.run(setting));
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / runs;
}

/// A method at a setting.
struct SeriesSide {
  const Method* method = nullptr;
  double setting = no_ratio, seconds = no_ratio;
  Trial trial = {};

  int runs() const { return static_cast<int>(std::ceil(1e-3 / std::max(seconds, 1e-6))); }
  SeriesEntrant entrant() const {
    if (!method) return {};
    return {method->algorithm + ", " + method->resolution.name + " " + format_significant(setting, 2),
            trial.error, seconds, trial.answer.evaluations};
  }
};

/// The method at the coarsest setting at which, and at all finer ones, its error is small enough.
SeriesSide coarsest(const Quantity& motion, const Method& method, double allowed, double horizon) {
  SeriesSide side;
  for (double setting : settings_to_try(method, horizon)) {
    Trial trial = run(motion, method, setting);
    const long evaluations = trial.answer.evaluations;
    if (!(trial.error <= allowed))
      side = {};
    else if (!side.method)
      side = {&method, setting, no_ratio, std::move(trial)};
    if (evaluations > most_of_series_race) break;
  }
  if (side.method) side.seconds = seconds(method, side.setting, 3);
  return side;
}

SeriesRace race(const std::string& scene, const Quantity& motion, const std::string& model, double horizon) {
  const double allowed = series_error * size_of(motion.reference.value);
  SeriesSide series, other;
  for (const Method& method : motion.methods) {
    if (method.model != model || method.precision != Precision::in_double) continue;
    SeriesSide side = coarsest(motion, method, allowed, horizon);
    if (!side.method) continue;
    SeriesSide& best = method.algorithm == taylor_series ? series : other;
    if (!best.method || side.seconds < best.seconds) best = std::move(side);
  }
  SeriesRace result{scene, model, {}, {}, no_ratio, no_ratio};
  if (series.method && other.method) {
    constexpr int rounds = 11;
    std::vector<double> ratios, times, times_of_other;
    for (int round = 0; round < rounds; ++round) {
      move_code_to_fresh_pages();
      times.push_back(seconds(*series.method, series.setting, series.runs()));
      times_of_other.push_back(seconds(*other.method, other.setting, other.runs()));
      ratios.push_back(times.back() / times_of_other.back());
    }
    for (auto* all : {&ratios, &times, &times_of_other}) std::ranges::sort(*all);
    result.ratio = ratios[rounds / 2];
    result.half_width = (ratios[3 * rounds / 4] - ratios[rounds / 4]) / 2;
    series.seconds = times[rounds / 2];
    other.seconds = times_of_other[rounds / 2];
  }
  result.series = series.entrant();
  result.other = other.entrant();
  return result;
}

std::string two_decimals(double x) { return std::isfinite(x) ? format_significant(x, 2) : "-"; }

}  // namespace

std::vector<SeriesRace> race_series(const Reference& truth, const Progress& progress) {
  std::vector<SeriesRace> races;
  std::size_t done = 0;
  for (const Entry& entry : registry()) {
    if (progress) progress("racing Taylor series to 1e-12", static_cast<double>(done++), registry().size());
    if (!entry.exercise.scene) continue;
    const Scene& scene = *entry.exercise.scene;
    const Quantity moving = motion(scene, Parameters(entry.exercise.parameters), truth);
    const auto by_series = std::ranges::find(moving.methods, taylor_series, &Method::algorithm);
    const std::string number = to_string(entry.number);
    if (by_series == moving.methods.end())
      races.push_back({number, "not analytic", {}, {}, no_ratio, no_ratio});
    else
      races.push_back(race(number, moving, by_series->model, scene.horizon));
  }
  return races;
}

std::string series_text(const std::vector<SeriesRace>& races, const Screen& screen) {
  if (races.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"scene", "model", "series", "time", "evals", "fastest other",
                                              "time of it", "evals of it", "ratio", "+-"}};
  const auto cells = [](const SeriesEntrant& e) {
    using Cells = std::vector<std::string>;
    return e.method.empty() ? Cells{"-", "-", "-"}
                            : Cells{e.method, shown_time(e.seconds), std::to_string(e.evaluations)};
  };
  for (const SeriesRace& r : races) {
    std::vector<std::string> row{r.scene, r.model};
    for (const SeriesEntrant& e : {r.series, r.other})
      for (std::string& cell : cells(e)) row.push_back(std::move(cell));
    row.push_back(two_decimals(r.ratio));
    row.push_back(two_decimals(r.half_width));
    rows.push_back(std::move(row));
  }
  const auto ahead = std::ranges::count_if(races, &SeriesRace::ahead);
  return wrapped(
             "\nTaylor series and the fastest other method of the catalog on the same model, both to 1e-12 of the "
             "motion's size, in turn\n",
             screen) +
         aligned(rows, screen, {{"scene", "ratio"}, {"model", "evals", "evals of it", "+-"}}) +
         wrapped("  The series are ahead, by more than the spread, on " + std::to_string(ahead) + " of " +
                     std::to_string(races.size()) + " scenes.\n",
                 screen, 4);
}

}  // namespace oddity
