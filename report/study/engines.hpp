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

/// Results of third-party engines on scenes.
namespace oddity {

/// One run of an engine on a scene.
struct EngineTrial {
  int steps_per_frame = 1;
  Outcome outcome = Outcome::ok;
  std::string message = {};         ///< the reason for an outcome without results
  std::vector<double> errors = {};  ///< the largest in each of the motion's units, over all frames
  double in_needs = 0;              ///< the error in needs
  double energy = 0;                ///< its change, relative to its moving part; NaN where it may change
  double momentum = 0;              ///< relative change of a momentum that no force changes
  double off_joint = 0;             ///< m, the largest gap of a joint
  double seconds_per_frame = 0;     ///< the median of its runs
  double spread = 0;                ///< spread of these times
  bool same_bits = true;            ///< in all runs
  std::string restored = {};        ///< "same bits", "other bits", "not offered"; empty: not tested
  /// The observables, frame after frame, for drawing: only at one step per frame with the engine's defaults.
  std::vector<double> path = {};
  std::map<Criterion, double> by = {};  ///< by each requested criterion except path, in its own unit
};

/// A variant's trials on a scene, from coarse to fine.
struct EngineSeries {
  std::string engine, version, precision, variant, says;
  bool defaults = true, webassembly = false;
  int stated_order = 0;
  std::string lasting = {}, friction = {};
  std::string cannot = {};  ///< why the engine cannot have such a scene; then there are no trials
  std::vector<EngineTrial> trials = {};
  std::optional<PowerLaw> law = {};  ///< error over step, in its asymptotic range
  double floor = 0;                  ///< the smallest error, in needs

  /// The coarsest trial from which on all pass.
  const EngineTrial* first_enough() const;
};

/// Fits the law and finds the smallest error of the trials.
void summarize(EngineSeries&);

/// The recommendation of `choose` for the same scene.
struct Instead {
  std::string says;  ///< "one angle by Runge-Kutta 4, 1 step per frame"
  std::vector<double> errors;
  double seconds_per_frame = 0;
  std::map<Criterion, double> by = {};  ///< by each requested criterion except path
};

/// Errors of this project's models at the steps that engines take: for an algorithm, the smallest over the
/// models.
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
  std::string differs = {};  ///< differences from the scene that remain however small the step
  bool rubs = false;
  /// The criteria that judge its trials, and the error allowed by each; of a path in needs.
  std::vector<std::pair<Criterion, double>> criteria = {{Criterion::path, 1}};
};

void write(const std::vector<EngineContest>&, const std::filesystem::path&);
/// Throws BadInput, naming the file, if `write` would not write it so.
std::vector<EngineContest> read_engines(const std::filesystem::path&);

}  // namespace oddity
