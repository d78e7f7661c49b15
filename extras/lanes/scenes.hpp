#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "extras/lanes/compiled.hpp"

/// Every model of every scene in lanes: thousands of bodies of one model at once, each with its own
/// parameters, on the widest registers of this machine.
namespace oddity::lanes {

/// Initial condition of a body, in double or in float.
struct Beginning {
  std::size_t unknowns = 0, model_bytes = 0, state_bytes = 0;  ///< none for a closed form
  std::size_t observables = 0;
  bool has_events = false;    ///< lanes pass through them
  bool has_own_time = false;  ///< it is integrated over another variable than the scene's time
  void (*begin)(const double* parameters, std::byte* model, std::byte* state) = nullptr;
  void (*observe)(const std::byte* model, const std::byte* state, double t, double* observed) = nullptr;
};

/// The compiled sets, from the narrowest.
enum class Registers { one, baseline, avx2, avx512 };
constexpr int registers_count = 4;

struct SceneInLanes {
  std::string_view number;
  std::size_t parameters;                     ///< number of the exercise's first parameters
  std::size_t models;                         ///< in the order of its models()
  const Beginning* beginnings;                ///< models in double, and then in float
  const Compiled* compiled[registers_count];  ///< likewise; null for sets that this build lacks
};

/// Contents of the library next to the program.
struct Library {
  std::span<const SceneInLanes> scenes;
  const Repeated* repeated[registers_count];
};

/// The first call loads the library. Throws BadInput if it is missing.
std::span<const SceneInLanes> scenes_in_lanes();
/// For doubles, and then for floats; null for sets that this build lacks.
const Repeated* repeated_operations(Registers);
/// Throws BadInput if the scene has no lanes.
const SceneInLanes& scene_in_lanes(std::string_view number);

/// The models' names in the scene's quantity, in their order.
std::vector<std::string_view> model_names(const SceneInLanes&);

std::string_view name_of(Registers);  ///< "AVX2"
std::string_view name_of(Fixed);      ///< the catalog's name
constexpr std::string_view own_steps_name = "Dormand-Prince 5(4)";

/// Whether this machine and this build support them, and the widest of these.
bool can(Registers);
Registers widest();

}  // namespace oddity::lanes

extern "C" [[gnu::visibility("default")]] const oddity::lanes::Library* oddity_lanes();
