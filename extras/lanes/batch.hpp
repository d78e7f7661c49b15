#pragma once

#include <optional>
#include <vector>

#include "chapters/exercise.hpp"
#include "extras/lanes/scenes.hpp"

namespace oddity::lanes {

enum class Steps { fixed, own };

/// Bodies of one model, each with its own parameters.
class Batch {
 public:
  /// `model`: index among the scene's models. `parameters`: one body's after the other's, as many per body as
  /// the scene has.
  Batch(const SceneInLanes& scene, std::size_t model, Precision precision, std::vector<double> parameters);

  std::size_t size() const { return bodies_; }
  bool closed_form() const { return beginning_.unknowns == 0; }
  std::size_t width(Registers registers) const { return compiled(registers).width; }
  bool has(Fixed algorithm) const;

  /// Groups the bodies side by side for these registers and steps, and keeps them so. Otherwise the first
  /// steps do it.
  void group(Registers, Steps);
  /// Steps from the bodies' states on. There is one of each algorithm for all registers, to the bit.
  void steps(Registers, Fixed, double t0, double h, long steps);
  /// Returns whether all bodies have reached t1; `each` receives how each ended.
  bool own_steps(Registers, double t0, double t1, double tolerance, double first_step,
                 std::vector<Ended>* each = nullptr);
  /// Restarts from the scene's initial condition, or from states that are this part of it.
  void begin_again(double part = 1);

  /// Observables of all bodies: of a closed form at t, or of the current states.
  std::vector<double> observed(Registers, double t) const;
  std::size_t observables() const { return beginning_.observables; }
  /// A body's state, as bytes in memory.
  std::span<const std::byte> state(std::size_t body) const;

 private:
  const Compiled& compiled(Registers) const;
  Bodies bodies() const { return {models_.data(), states_.data(), bodies_}; }
  struct Grouped {
    Registers registers;
    Steps steps;
    bool operator==(const Grouped&) const = default;
  };
  const Grouping& grouping(const Grouped&) const;
  /// All groups.
  Groups groups();
  /// Calls work(groups, number of the first) for some groups at a time, and checks this thread's stop before
  /// each.
  template <class Work>
  void for_pieces(const Work& work);
  /// Copies the groups' states to the bodies if the groups have moved.
  void catch_up() const;

  /// Multiplies every number of the states by this factor.
  template <class T>
  void scale_states(T factor);

  const SceneInLanes& scene_;
  Precision precision_;
  std::size_t of_all_;  ///< index among the scene's models in double and then in float
  const Beginning& beginning_;
  std::vector<double> parameters_;
  std::size_t bodies_;
  std::vector<std::byte> models_;
  mutable std::vector<std::byte> states_;

  /// Memory aligned for all registers.
  struct alignas(alignment) Line {
    std::byte bytes[alignment];
  };
  std::optional<Grouped> grouped_;
  std::vector<Line> group_models_, group_states_;
  mutable bool behind_ = false;  ///< whether the bodies' states are older than their groups'
};

/// Parameters of this many bodies, each a little off the exercise's: the k-th by k times `apart`.
std::vector<double> apart(const SceneInLanes& scene, std::span<const Parameter> parameters,
                          std::size_t bodies, double apart);

}  // namespace oddity::lanes
