#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// What other people's engines do on the scenes, as a page with its pictures.
namespace oddity {

/// What one would not expect of an engine, and the program that shows it.
struct Surprise {
  std::string file, says;
};
/// Those of a folder, each told by its file's first lines.
std::vector<Surprise> surprises_in(const std::filesystem::path& folder);

/// What our own models make of an engine's steps, by scene.
using OwnByScene = std::map<std::string, std::vector<OwnSteps>>;

/// The tables of all scenes, and what is said of each engine. Its pictures are in `engines/` beside it.
std::string engines_page(const std::vector<EngineContest>&, const OwnByScene&,
                         const std::vector<double>& rates, const std::vector<Surprise>&);

/// The page's pictures by their names; and, where they hold times, those that it does not show.
std::map<std::string, std::string> engine_pictures(const std::vector<EngineContest>&, const OwnByScene&);
std::map<std::string, std::string> engine_pictures_of_times(const std::vector<EngineContest>&);

}  // namespace oddity
