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

/// Extensions by the products in extras/. Only main.cpp knows which exist.
namespace oddity {

/// The command line to which a verb is added. After parsing, `reference` is the folder of the tables.
/// `status` is the exit code.
struct CommandLine {
  CLI::App& app;
  const std::string& reference;
  int& status;
};

/// Several bodies of one kind in each frame, for `choose --bodies`.
struct ManyBodies {
  Needs needs;
  /// Cost of a run of a method for all bodies of the need.
  std::function<Price(const Task&, const Need&)> price;
  /// The SIMD registers for the chosen method's bodies; empty: they run one after the other.
  std::function<std::string(const Choice&)> registers;
};

/// Third-party engines on the scenes, for `list`, `choose --engine` and `chart`.
struct OtherEngines {
  struct Answer {
    std::string text, json;
  };
  using Answers = std::function<Answer(const Choice&, const Reference&)>;

  /// Names of scenes that belong to no exercise.
  std::function<std::vector<std::string>()> scenes;
  /// Throws BadInput if the exercise has no scene for engines.
  std::function<void(const Entry&)> require_scene;
  /// Compares the engines of this name with a choice. Throws BadInput if there are no such engines.
  std::function<Answers(const std::string& name, const Task&)> named;
  /// Draws the tasks' scenes from the results of earlier runs, and returns the pictures.
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
