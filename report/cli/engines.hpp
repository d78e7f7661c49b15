#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study/choose.hpp"
#include "report/study/engines.hpp"

namespace oddity::verbs {

/// Those whose names begin so, whatever the case; none for no name. Throws BadInput when there is none.
std::vector<EngineProgram> engines_named(const std::string& name);
/// The engines on the scene of a choice, with its need.
EngineContest beside(const Choice&, const std::vector<EngineProgram>&, const Task&, const Reference&);

/// What earlier runs kept; nothing where there was none. Throws as read_engines.
std::vector<EngineContest> kept_engines();

/// Pictures of what earlier runs of engines kept of the tasks' scenes, as the exercises have them.
std::vector<std::filesystem::path> draw_engines(const std::vector<Task>&, const Reference&,
                                                const std::filesystem::path& folder);

}  // namespace oddity::verbs
