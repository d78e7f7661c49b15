#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "extras/engines/scenes.hpp"
#include "report/study/engines.hpp"

/// Third-party engines on scenes. Each is a separate program (adapters/), run as a child process with limits
/// of time and memory. A crash of it is an outcome.
namespace oddity {

/// An engine's settings.
struct EngineVariant {
  std::string name, says;
  int order = 0;  ///< as stated in its manual; 0: not stated
  bool defaults = true;
  std::string lasting = {}, friction = {};  ///< errors that no finer step removes, in general and in friction
};

struct EngineProgram {
  std::vector<std::string> command;
  std::string name, version, precision;
  bool webassembly = false;  ///< its times are not those of a native program
  std::vector<EngineVariant> variants;
};

/// Engines that `oddity engines` has built and installed: native ones in `folder`, those for node by the
/// contents of `adapters`. Throws BadInput if other users can write to these.
std::vector<EngineProgram> engines_found(const std::filesystem::path& folder,
                                         const std::filesystem::path& adapters);

/// Limits of a series.
struct EngineTask {
  int finest = 32;  ///< steps per frame; from 1 on, by doubling
  /// Runs per trial of at most 4 steps per frame, and of the first sufficient one; others run once.
  int timed = 5;
  double limit = 60;  ///< s for one trial
};

EngineTrial run(const EngineProgram&, const EngineVariant&, const EngineScene&, int steps_per_frame,
                const EngineTask&);
EngineContest run(const std::vector<EngineProgram>&, const EngineScene&, const EngineTask&,
                  const Progress& = {});

/// Why no rate tried is sufficient, as far as it is known. A property of its settings counts if another
/// variant of the engine does better without it. Rounding counts if double does better, or if finer steps
/// have larger errors. Empty where its error still falls; "not explained" where nothing is known.
std::string why_never(const EngineContest&, const EngineSeries&);

}  // namespace oddity
