#pragma once

#include <string>
#include <vector>

#include "report/study/need.hpp"
#include "report/study/run.hpp"
#include "solvers/world.hpp"

namespace oddity {

/// A scene for engines, with its reference at every frame.
struct EngineScene {
  std::string scene;  ///< "3.5", or a name for further scenes
  std::string title;
  Need need;
  engines::Staging staging;
  Quantity motion;  ///< without methods
};

/// Whether the exercise has a scene for engines.
bool has_engine_scene(const Entry&);
/// Throws BadInput with a list of those that have one, if it has none.
void require_engine_scene(const Entry&);

/// The exercise's scene. Throws BadInput if it has none for engines.
EngineScene engine_scene(const Task&, const Need&, const Reference&);

/// Scenes that are not in the book: "free body", "bouncing ball", "box on corners", "chain of 10", "chain of
/// 100".
std::vector<std::string> further_engine_scenes();
/// One of these. Throws BadInput for another.
EngineScene further_engine_scene(const std::string& name, const Need&);

}  // namespace oddity
