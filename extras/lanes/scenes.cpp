#include "extras/lanes/scenes.hpp"

#include <algorithm>
#include <string>

#include "reference/bad_input.hpp"
#include "report/study/sibling_program.hpp"

namespace oddity::lanes {

namespace {

const Library& library() {
  static const Library& loaded = *[] {
    const auto file = own_library("liboddity_lanes.so");
    if (!file)
      throw BadInput(
          "this program was built without its models in lanes: " + where_to_build() +
          "'./oddity' builds them where they are asked for, and so does 'cmake --build build/release --target "
          "oddity_lanes'");
    return function_of<decltype(oddity_lanes)>(*file, "oddity_lanes")();
  }();
  return loaded;
}

struct Names {
  std::string_view number;
  std::vector<std::string_view> models;
};

/// Names of models() of each scene.
const std::vector<Names>& all_names() {
  static const std::vector<Names> all{
      {"2.7", {"matrix, w of the printed listing", "frame", "matrix", "quaternion"}},
      {"3.3",
       {"equation (7) as printed", "Kepler's equation, Newton from M + 0.85 e", "equation (7)",
        "equation (2)", "polar", "Cartesian"}},
      {"3.5",
       {"small angle", "amplitude-corrected", "Jacobi's function by its Fourier series", "one angle",
        "Cartesian with constraint"}},
      {"3.7",
       {"straight tangent", "energy in q", "energy in u", "one coordinate", "Cartesian with constraints",
        "Cartesian with constraints, to the origin"}},
      {"3.9", {"closed form, one for all regimes", "plane", "plane, with the work"}},
      {"3.11", {"straight line", "height field", "momenta", "Cartesian with constraint"}},
      {"3.13",
       {"center line", "small angle", "elliptic angle", "angle about the axis", "height field",
        "Cartesian with constraint"}},
      {"3.15",
       {"no spring", "spring's end on the axis", "rigid spring", "listing as printed",
        "listing with the other rest length", "along the rod", "along the rod, with the work",
        "in the turning plane", "Cartesian with constraints"}},
      {"3.17",
       {"averaged", "small angle", "two angles as published", "two angles", "Cartesian with constraint"}},
      {"3.19", {"published equations", "two coordinates", "four coordinates with tensions"}},
      {"3.21", {"constant speeds", "one angle", "two angles", "Cartesian center"}},
      {"3.23", {"small oscillation", "one angle", "Cartesian with constraint"}},
      {"3.25", {"dense mass matrix", "tensions"}},
      {"3.27", {"Kepler's equation, Newton from pi", "(r, u, phi)", "(r, u, phi), one turn", "two bodies"}},
      {"3.29", {"center alone", "free fall", "x, y, theta", "two particles and a rod"}},
      {"3.31",
       {"sliding and spinning apart", "friction regularized at 1 cm/s", "friction at full speed only",
        "stopped by event", "time stretched by the speed"}},
      {"3.33",
       {"mean precession of a fast top", "height by its tilt", "height alone",
        "one angle, precession by quadrature", "Euler angles", "rigid body, quaternion",
        "axis and angular momentum"}},
      {"3.35",
       {"fixed tip, as proposed", "small tilt", "first order in A", "Euler angles", "rigid body, quaternion",
        "axis and angular momentum"}}};
  return all;
}

}  // namespace

std::span<const SceneInLanes> scenes_in_lanes() { return library().scenes; }

const Repeated* repeated_operations(Registers registers) {
  return library().repeated[static_cast<int>(registers)];
}

const SceneInLanes& scene_in_lanes(std::string_view number) {
  for (const SceneInLanes& scene : scenes_in_lanes())
    if (scene.number == number) return scene;
  throw BadInput("exercise " + std::string(number) + " has no models in lanes; those of scenes do");
}

std::vector<std::string_view> model_names(const SceneInLanes& scene) {
  const auto found = std::ranges::find(all_names(), scene.number, &Names::number);
  return found == all_names().end() ? std::vector<std::string_view>(scene.models) : found->models;
}

std::string_view name_of(Registers registers) {
  constexpr std::string_view names[] = {"one number", "SSE2", "AVX2", "AVX-512"};
  return names[static_cast<int>(registers)];
}
std::string_view name_of(Fixed algorithm) {
  constexpr std::string_view names[] = {"Runge-Kutta 4", "velocity Verlet", "symplectic Euler"};
  return names[static_cast<int>(algorithm)];
}

bool can(Registers registers) {
  if (!scenes_in_lanes().front().compiled[static_cast<int>(registers)]) return false;
#if defined(__x86_64__)
  if (registers == Registers::avx2) return __builtin_cpu_supports("avx2");
  if (registers == Registers::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
#endif
  return true;
}
Registers widest() {
  Registers found = Registers::one;
  for (Registers r : {Registers::baseline, Registers::avx2, Registers::avx512})
    if (can(r)) found = r;
  return found;
}

}  // namespace oddity::lanes
