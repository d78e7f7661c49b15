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
/// Those of a folder, each told by its file's first line.
std::vector<Surprise> surprises_in(const std::filesystem::path& folder);

/// What our own models make of an engine's steps, by scene.
using OwnByScene = std::map<std::string, std::vector<OwnSteps>>;

/// What one wants to know first of all scenes, and what was found. Its pictures and trials are in `engines/`
/// beside it; `programs` is the way from the page to the folder of those that show what was found.
std::string engines_page(const std::vector<EngineContest>&, const std::vector<Surprise>&,
                         const std::string& programs);
/// A table of each scene's trials, by the file's name.
std::map<std::string, std::string> engine_trials(const std::vector<EngineContest>&);

/// The page's pictures by their names; and, where they hold times, those that it does not show.
std::map<std::string, std::string> engine_pictures(const std::vector<EngineContest>&, const OwnByScene&);
std::map<std::string, std::string> engine_pictures_of_times(const std::vector<EngineContest>&);

}  // namespace oddity
