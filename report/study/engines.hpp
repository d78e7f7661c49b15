#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"
#include "report/study/fit.hpp"
#include "report/study/need.hpp"

/// What other people's engines did on scenes.
namespace oddity {

/// One run of an engine on a scene.
struct EngineTrial {
  int steps_per_frame = 1;
  Outcome outcome = Outcome::ok;
  std::string message = {};         ///< why it is no more than an outcome
  std::vector<double> errors = {};  ///< the largest in each of the motion's units, over all frames
  double in_needs = 0;              ///< the error in needs
  double energy = 0;                ///< by how much it changes, as a part of what moves; NaN where it may
  double momentum = 0;              ///< the same of a momentum that no force changes
  double off_joint = 0;             ///< m, how far joints come apart
  double seconds_per_frame = 0;     ///< the median of its runs
  double spread = 0;                ///< of these
  bool same_bits = true;            ///< in all runs
  std::string restored = {};        ///< "same bits", "other bits", "not offered"; empty: not asked
  /// The observables, frame after frame, for the eye: of a step per frame with the engine's defaults alone.
  std::vector<double> path = {};
  std::map<Criterion, double> by = {};  ///< by each criterion asked for but path, in its own unit
};

/// A variant's trials on a scene, from coarse to fine.
struct EngineSeries {
  std::string engine, version, precision, variant, says;
  bool defaults = true, webassembly = false;
  int stated_order = 0;
  std::string lasting = {}, friction = {};
  std::string cannot = {};  ///< why the engine has no such scene; then no trials
  std::vector<EngineTrial> trials = {};
  std::optional<PowerLaw> law = {};  ///< of the error over the step, in its asymptotic range
  double floor = 0;                  ///< the least error, in needs

  /// The first trial that holds, and all finer ones.
  const EngineTrial* first_enough() const;
};

/// The law and the least error of its trials.
void summarize(EngineSeries&);

/// What `choose` has instead.
struct Instead {
  std::string says;  ///< "one angle by Runge-Kutta 4, 1 step per frame"
  std::vector<double> errors;
  double seconds_per_frame = 0;
  std::map<Criterion, double> by = {};  ///< by each criterion asked for but path
};

/// What our own models make of the steps that engines take: by an algorithm, the least over the models.
struct OwnSteps {
  std::string algorithm;
  std::vector<std::pair<int, double>> errors;  ///< steps per frame, and the error in needs
};

struct EngineContest {
  std::string scene, title;
  std::vector<std::string> units;
  std::vector<double> needs;
  double horizon = 0, frames_per_second = 60;
  std::vector<EngineSeries> series;
  std::optional<Instead> least = {};
  std::string differs = {};  ///< what is other than in the scene however fine the step
  bool rubs = false;
  /// That its trials are judged by, and the error allowed by each; of a path in needs.
  std::vector<std::pair<Criterion, double>> criteria = {{Criterion::path, 1}};
};

void write(const std::vector<EngineContest>&, const std::filesystem::path&);
/// Throws BadInput, naming the file, when it is not what `write` writes.
std::vector<EngineContest> read_engines(const std::filesystem::path&);

}  // namespace oddity
