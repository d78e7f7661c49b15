#pragma once

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

struct Extras {
  std::vector<std::function<void(const CommandLine&)>> verbs;
  ManyBodies bodies;
};

}  // namespace oddity
