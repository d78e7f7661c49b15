#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/study/engine_scenes.hpp"
#include "report/study/fit.hpp"

/// Other people's engines on scenes. Each is a program of its own (solvers/engines), which runs as a child
/// with limits of time and memory: what it does to itself is an outcome.
namespace oddity {

/// A way to use an engine.
struct EngineVariant {
  std::string name, says;
  int order = 0;  ///< as its manual has it; 0: not said
  bool defaults = true;
  std::string lasting = {}, friction = {};  ///< what no finer step takes away, and the same of its friction
};

struct EngineProgram {
  std::vector<std::string> command;
  std::string name, version, precision;
  bool webassembly = false;  ///< its times are not those of a native program
  std::vector<EngineVariant> variants;
};

/// Those that `oddity engines` has built and installed: native ones in `folder`, those of node's by what is
/// in `adapters`. Throws BadInput where others can write to these.
std::vector<EngineProgram> engines_found(const std::filesystem::path& folder,
                                         const std::filesystem::path& adapters);

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

/// Why no rate tried is enough, as far as it can be told: what is said of its settings counts where another
/// variant of the engine without that does better, and rounding where double does, or where finer steps err
/// more. Empty where its error still falls; "not explained" where nothing is known.
std::string why_never(const EngineContest&, const EngineSeries&);

/// How far to go.
struct EngineTask {
  int finest = 32;  ///< steps per frame; from 1 on, by doubling
  /// Runs of a trial of at most 4 steps per frame, and of the first that is enough; others run once.
  int timed = 5;
  double limit = 60;  ///< s for one trial
};

EngineTrial run(const EngineProgram&, const EngineVariant&, const EngineScene&, int steps_per_frame,
                const EngineTask&);
EngineContest run(const std::vector<EngineProgram>&, const EngineScene&, const EngineTask&,
                  const Progress& = {});

void write(const std::vector<EngineContest>&, const std::filesystem::path&);
/// Throws BadInput, naming the file, when it is not what `write` writes.
std::vector<EngineContest> read_engines(const std::filesystem::path&);

}  // namespace oddity
