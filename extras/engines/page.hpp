#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "report/study/engines.hpp"

/// Results of third-party engines on the scenes, as a page with its pictures.
namespace oddity {

/// A surprising property of an engine, and the program that shows it.
struct Surprise {
  std::string file, says;
};
/// Surprises of a folder, described by the first lines of its files.
std::vector<Surprise> surprises_in(const std::filesystem::path& folder);

/// Results of our models at an engine's steps, by scene.
using OwnByScene = std::map<std::string, std::vector<OwnSteps>>;

/// An overview of all scenes, and the surprises. Pictures and trials are in `engines/` next to the page;
/// `programs` is the path from the page to the folder of programs that show the surprises.
std::string engines_page(const std::vector<EngineContest>&, const std::vector<Surprise>&,
                         const std::string& programs);
/// A table of each scene's trials, by the file's name.
std::map<std::string, std::string> engine_trials(const std::vector<EngineContest>&);

/// The page's pictures by name, and the pictures of times, which it does not show.
std::map<std::string, std::string> engine_pictures(const std::vector<EngineContest>&, const OwnByScene&);
std::map<std::string, std::string> engine_pictures_of_times(const std::vector<EngineContest>&);

}  // namespace oddity
