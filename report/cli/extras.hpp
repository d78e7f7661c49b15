#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/cli/needs.hpp"
#include "report/study/choose.hpp"

namespace CLI {
class App;
}

/// What the products in extras/ add to the program. Only main.cpp knows which there are.
namespace oddity {

/// The command line that a verb is added to: `reference` is the folder of the tables, once the line is read,
/// and `status` the exit code.
struct CommandLine {
  CLI::App& app;
  const std::string& reference;
  int& status;
};

/// Several bodies of one kind in each frame, for `choose --bodies`.
struct ManyBodies {
  Needs needs;
  /// What a run of a method costs for all of the need's bodies.
  std::function<Price(const Task&, const Need&)> price;
  /// The registers that the chosen method's bodies are side by side in; empty: they go one after the other.
  std::function<std::string(const Choice&)> registers;
};

/// Other people's engines on the scenes, for `list`, `choose --engine` and `chart`.
struct OtherEngines {
  struct Answer {
    std::string text, json;
  };
  using Answers = std::function<Answer(const Choice&, const Reference&)>;

  /// The names of scenes that no exercise has.
  std::function<std::vector<std::string>()> scenes;
  /// Throws BadInput where the exercise has no scene for engines.
  std::function<void(const Entry&)> require_scene;
  /// What the engines of this name make of the scene beside a choice. Throws BadInput where there are none.
  std::function<Answers(const std::string& name, const Task&)> named;
  /// Draws what earlier runs kept of the tasks' scenes, and returns the pictures.
  std::function<std::vector<std::filesystem::path>(const std::vector<Task>&, const Reference&,
                                                   const std::filesystem::path& folder)>
      draw;
};

struct Extras {
  std::vector<std::function<void(const CommandLine&)>> verbs;
  ManyBodies bodies;
  OtherEngines engines;
};

}  // namespace oddity
