#pragma once

#include <cstddef>

/// A model compiled for an instruction set, behind raw pointers: files that are compiled for different sets
/// share this and no other type.
namespace oddity::lanes {

/// Bodies one behind the other, each a model and a state of single numbers.
struct Bodies {
  const std::byte* models;
  std::byte* states;
  std::size_t count;
};

/// The same in lanes, as they stay from call to call: groups of bodies side by side, each a model and a state
/// of lanes.
struct Groups {
  const std::byte* models;
  std::byte* states;
  std::size_t count;
};

/// How bodies become groups. The last body stands in for those that there are not.
struct Grouping {
  std::size_t bodies = 0;                        ///< of a group
  std::size_t model_bytes = 0, state_bytes = 0;  ///< of a group
  void (*in)(const Bodies&, std::byte* models, std::byte* states) = nullptr;
  void (*out)(const std::byte* states, const Bodies&) = nullptr;
};

/// What the groups' memory is aligned to, for all registers.
constexpr std::size_t alignment = 64;

/// How a body's own steps ended.
struct Ended {
  long steps;    ///< tried
  bool reached;  ///< else its step became too small, or the budget of steps is spent, or t1 is not ahead
};

enum class Fixed { runge_kutta_4, velocity_verlet, symplectic_euler };
constexpr int fixed_count = 3;

/// Null is what the model does not have: a closed form has no steps, and what is integrated no closed form.
struct Compiled {
  std::size_t width = 0;  ///< numbers in a register
  Grouping for_fixed_steps = {}, for_own_steps = {};
  void (*fixed[fixed_count])(const Groups&, double t0, double h, long steps) = {};
  /// Whether all have come to t1. `each`: of every body of the groups, or null.
  bool (*own_steps)(const Groups&, double t0, double t1, double tolerance, double first_step,
                    Ended* each) = nullptr;
  /// The observables of each body at t, of its parameters.
  void (*at)(const double* parameters, std::size_t bodies, double t, double* observed) = nullptr;
};

/// One operation on registers that do not wait for each other, `times` on each of eight, which is what a
/// machine's arithmetic can do at most.
enum class Arithmetic { addition, multiplication, division, root };
constexpr int arithmetic_count = 4, registers_at_once = 8;

struct Repeated {
  std::size_t width;
  double (*run)(Arithmetic, long times);  ///< what is left in the end, which says nothing
};

}  // namespace oddity::lanes
