#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "extras/engines/scenes.hpp"
#include "report/study/engines.hpp"

/// Other people's engines on scenes. Each is a program of its own (adapters/), which runs as a child with
/// limits of time and memory: what it does to itself is an outcome.
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

/// Why no rate tried is enough, as far as it can be told: what is said of its settings counts where another
/// variant of the engine without that does better, and rounding where double does, or where finer steps err
/// more. Empty where its error still falls; "not explained" where nothing is known.
std::string why_never(const EngineContest&, const EngineSeries&);

}  // namespace oddity
