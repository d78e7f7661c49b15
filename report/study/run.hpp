#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "chapters/kicks.hpp"
#include "reference/reference.hpp"
#include "report/study/results.hpp"

/// A run: studies exercises and runs all their trials.
///
///   const Task task(registry()[0]);
///   const Results results = run(std::span(&task, 1), truth, false);
///   for (const auto& judged : results.exercises[0].claims)
///     std::cout << judged.claim.id << " " << name_of(judged.verdict) << "\n";
namespace oddity {

/// An exercise with the parameters to study it at.
struct Task {
  const Entry* entry;
  Parameters parameters;
  std::optional<Horizon> frames = {};       ///< only a scene's motion is studied, at these times
  std::string frames_text = {};             ///< "at 60 frames per second, 1 % dropped"
  std::shared_ptr<const Kicks> kicks = {};  ///< kicks of that motion; null: none

  explicit Task(const Entry& e) : entry(&e), parameters(e.exercise.parameters) {}
};

/// Progress callback (stage, pieces done, all pieces); `done` may be fractional. Called from several threads,
/// one at a time.
using Progress = std::function<void(const std::string& stage, double done, std::size_t all)>;

/// The quantity's method of this model and algorithm; null if it has none, as a motion's methods depend on
/// its parameters.
const Method* method_of(const Quantity&, std::string_view model, std::string_view algorithm);

/// A trial as plain values, not timed.
TimedTrial as_result(const Trial&);

/// Studies the tasks in parallel, then runs all their trials in parallel. When `timed`, runs each trial
/// again, alone, in batches long enough for the clock. The results are in the order of the tasks and do not
/// depend on the number of threads. Rethrows BadInput from a study; any other exception becomes that
/// exercise's `failure`.
Results run(std::span<const Task> tasks, const Reference& truth, bool timed, const Progress& progress = {});

}  // namespace oddity
