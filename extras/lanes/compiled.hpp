#pragma once

#include <cstddef>

/// A model compiled for an instruction set, behind raw pointers. Files compiled for different sets share no
/// other type.
namespace oddity::lanes {

/// Consecutive bodies, each a model and a state of single numbers.
struct Bodies {
  const std::byte* models;
  std::byte* states;
  std::size_t count;
};

/// Bodies in lanes, which stay so from call to call: groups of bodies side by side, each a model and a state
/// of lanes.
struct Groups {
  const std::byte* models;
  std::byte* states;
  std::size_t count;
};

/// How bodies become groups. Copies of the last body fill up the last group.
struct Grouping {
  std::size_t bodies = 0;                        ///< per group
  std::size_t model_bytes = 0, state_bytes = 0;  ///< per group
  void (*in)(const Bodies&, std::byte* models, std::byte* states) = nullptr;
  void (*out)(const std::byte* states, const Bodies&) = nullptr;
};

/// Alignment of the groups' memory, for all registers.
constexpr std::size_t alignment = 64;

/// How a body's variable steps ended.
struct Ended {
  long steps;    ///< steps tried
  bool reached;  ///< otherwise its step became too small, the budget of steps is spent, or t1 is not ahead
};

enum class Fixed { runge_kutta_4, velocity_verlet, symplectic_euler };
constexpr int fixed_count = 3;

/// Null for whatever the model lacks: a closed form has no steps, other models have no closed form.
struct Compiled {
  std::size_t width = 0;  ///< numbers in a register
  Grouping for_fixed_steps = {}, for_own_steps = {};
  void (*fixed[fixed_count])(const Groups&, double t0, double h, long steps) = {};
  /// Returns whether all have reached t1. `each`: one for every body of the groups, or null.
  bool (*own_steps)(const Groups&, double t0, double t1, double tolerance, double first_step,
                    Ended* each) = nullptr;
  /// The observables of each body at t, from its parameters.
  void (*at)(const double* parameters, std::size_t bodies, double t, double* observed) = nullptr;
};

/// One operation on eight registers that do not wait for each other, `times` on each: a machine's peak
/// arithmetic.
enum class Arithmetic { addition, multiplication, division, root };
constexpr int arithmetic_count = 4, registers_at_once = 8;

struct Repeated {
  std::size_t width;
  double (*run)(Arithmetic, long times);  ///< the final value, which means nothing
};

}  // namespace oddity::lanes
