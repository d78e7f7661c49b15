// Expected outcomes hold in the whole ranges of the parameters where an exercise declares so. Each parameter
// is put at both ends of its range, at zero and close to it; then all are as small as their ranges allow, and
// all as large.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "report/study/parallel.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

std::vector<double> extremes(const Parameter& p) {
  std::vector<double> all;
  for (double x : {p.least, p.most, 0.0, 1e-12 * p.value})
    if (p.least <= x && x <= p.most && std::isfinite(x) && (!p.whole || x == std::round(x)) &&
        std::ranges::find(all, x) == all.end())
      all.push_back(x);
  return all;
}

std::vector<Parameters> corners(const Exercise& exercise) {
  const Parameters own(exercise.parameters);
  std::vector<Parameters> all;
  Parameters small = own, large = own;
  for (const Parameter& p : exercise.parameters) {
    if (p.name == "seed") continue;
    const auto values = extremes(p);
    for (double x : values) {
      all.push_back(own);
      all.back().set(p.name, x);
    }
    const auto size = [](double x) { return std::abs(x); };
    small.set(p.name, *std::ranges::min_element(values, {}, size));
    large.set(p.name, *std::ranges::max_element(values, {}, size));
  }
  all.push_back(small);
  all.push_back(large);
  return all;
}

/// "a = 3.14, L = 2": those that are not the exercise's own.
std::string changes_of(const Exercise& exercise, const Parameters& parameters) {
  std::string all;
  for (const Parameter& p : exercise.parameters)
    if (parameters[p.name] != p.value)
      all += (all.empty() ? "" : ", ") + std::string(p.name) + " = " + format_shortest(parameters[p.name]);
  return all;
}

/// The outcomes that are not as expected, a sentence each.
std::vector<std::string> surprises(const Exercise& exercise, const Parameters& parameters) {
  static const Reference truth = Reference(std::string(ODDITY_SOURCE) + "/reference").without_new_motions();
  std::vector<std::string> all;
  Findings found;
  try {
    found = exercise.study(parameters, truth);
  } catch (const BadInput&) {
    return all;  // these parameters are refused
  }
  for (const Quantity& quantity : found.quantities) {
    if (quantity.for_own_parameters || !finite(quantity.reference.value)) continue;
    for (const Method& method : quantity.methods) {
      if (method.for_own_parameters) continue;
      const Trial trial = run(quantity, method, method.resolution.settings.back());
      if (trial.outcome != method.expected)
        all.push_back(changes_of(exercise, parameters) + ": " + quantity.name + ", " + method.model + ", " +
                      method.algorithm + " ends as " + std::string(name_of(trial.outcome)) +
                      ", expected as " + std::string(name_of(method.expected)) + ": error " +
                      format_significant(trial.error, 3) + ", needed " +
                      format_significant(quantity.need.allowed, 3));
    }
  }
  return all;
}

void check_corners(const Exercise& exercise) {
  std::mutex mutex;
  std::string all;
  const auto tried = corners(exercise);
  parallel_for_each(tried, [&](const Parameters& parameters) {
    const auto found = surprises(exercise, parameters);
    const std::lock_guard lock(mutex);
    for (const std::string& sentence : found) all += sentence + "\n";
  });
  INFO(all);
  CHECK(all.empty());
}

/// Exercises with integrals that take seconds in the corners.
constexpr std::string_view slow[]{"2.15", "3.3", "3.25"};

[[maybe_unused]] const bool registered = [] {
  for (const Entry& entry : registry())
    if (const std::string number = to_string(entry.number);
        entry.exercise.expected == Expected::in_whole_ranges)
      register_test([&entry] { check_corners(entry.exercise); },
                    number + ": outcomes are as expected at the ends of the ranges",
                    (std::ranges::find(slow, number) != std::end(slow) ? "[slow]" : "") +
                        ("[corners][" + number + "]"));
  return true;
}();

}  // namespace
