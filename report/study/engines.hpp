#pragma once

#include <filesystem>
#include <optional>
#include <string>
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
};

struct EngineProgram {
  std::vector<std::string> command;
  std::string name, version, precision;
  bool plane = false;
  bool webassembly = false;  ///< its times are not those of a native program
  std::vector<EngineVariant> variants;
};

/// Those that `oddity engines` has built and installed: native ones in `folder`, those of node's in the tree.
std::vector<EngineProgram> engines_found(const std::filesystem::path& folder,
                                         const std::filesystem::path& source);

/// One run of an engine on a scene.
struct EngineTrial {
  int steps_per_frame = 1;
  Outcome outcome = Outcome::ok;
  std::string message = {};           ///< why it is no more than an outcome
  std::vector<double> errors = {};    ///< the largest in each of the motion's units, over all frames
  double in_needs = 0;                ///< the error in needs
  double energy = 0;                  ///< by how much it changes, as a part of what moves; NaN where it may
  double off_joint = 0;               ///< m, how far joints come apart
  double seconds_per_frame = 0;       ///< the median of its runs
  double spread = 0;                  ///< of these
  bool same_bits = true;              ///< in all runs
  std::string restored = {};          ///< "same bits", "other bits", "not offered"; empty: not asked
  std::vector<double> observed = {};  ///< at every frame, as far as it came; kept where it is to be played
};

/// A variant's trials on a scene, from coarse to fine.
struct EngineSeries {
  std::string engine, version, precision, variant, says;
  bool defaults = true, webassembly = false;
  int stated_order = 0;
  std::string cannot = {};  ///< why the engine has no such scene; then no trials
  std::vector<EngineTrial> trials = {};
  std::optional<PowerLaw> law = {};  ///< of the error over the step, where it follows one
  double floor = 0;                  ///< the least error, in needs

  /// Its error becomes as small as is asked, and a tenth of that.
  bool converges() const { return floor < 0.1; }
  /// The first trial that holds, and all finer ones.
  const EngineTrial* first_enough() const;
};

/// What `choose` has instead.
struct Instead {
  std::string says;  ///< "one angle by Runge-Kutta 4, 1 step per frame"
  std::vector<double> errors;
  double seconds_per_frame = 0;
};

struct EngineContest {
  std::string scene, title;
  std::vector<std::string> units;
  std::vector<double> needs;
  double horizon = 0, frames_per_second = 60;
  std::vector<EngineSeries> series;
  std::optional<Instead> least = {};
};

/// How far to go.
struct EngineTask {
  int finest = 32;    ///< steps per frame; from 1 on, by doubling
  int timed = 5;      ///< runs of trials of at most 4 steps per frame; others run once
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
