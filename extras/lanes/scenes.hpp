#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "extras/lanes/compiled.hpp"

/// Every model of every scene in lanes: thousands of bodies of one model at once, each with parameters of its
/// own, on the widest registers that this machine has.
namespace oddity::lanes {

/// How a body begins, in double or in float.
struct Beginning {
  std::size_t unknowns = 0, model_bytes = 0, state_bytes = 0;  ///< none for a closed form
  std::size_t observables = 0;
  bool has_events = false;    ///< lanes go on through them
  bool has_own_time = false;  ///< what it is integrated over is not the scene's time
  void (*begin)(const double* parameters, std::byte* model, std::byte* state) = nullptr;
  void (*observe)(const std::byte* model, const std::byte* state, double t, double* observed) = nullptr;
};

/// Those that are compiled in, from the narrowest.
enum class Registers { one, baseline, avx2, avx512 };
constexpr int registers_count = 4;

struct SceneInLanes {
  std::string_view number;
  std::size_t parameters;                     ///< the first of the exercise's
  std::size_t models;                         ///< in the order of its models()
  const Beginning* beginnings;                ///< of the models in double, and then in float
  const Compiled* compiled[registers_count];  ///< the same; null where this build has none
};

/// What the library beside the program has.
struct Library {
  std::span<const SceneInLanes> scenes;
  const Repeated* repeated[registers_count];
};

/// The first that asks for lanes loads the library: throws BadInput where it is missing.
std::span<const SceneInLanes> scenes_in_lanes();
/// Of doubles, and then of floats; null where this build has none.
const Repeated* repeated_operations(Registers);
/// Throws BadInput where there is none.
const SceneInLanes& scene_in_lanes(std::string_view number);

/// What the scene's quantity calls the models, in their order.
std::vector<std::string_view> model_names(const SceneInLanes&);

std::string_view name_of(Registers);  ///< "AVX2"
std::string_view name_of(Fixed);      ///< as the catalog has it
constexpr std::string_view own_steps_name = "Dormand-Prince 5(4)";

/// Whether this machine and this build have them, and the widest of those.
bool can(Registers);
Registers widest();

}  // namespace oddity::lanes

extern "C" [[gnu::visibility("default")]] const oddity::lanes::Library* oddity_lanes();
