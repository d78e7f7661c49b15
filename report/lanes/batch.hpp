#pragma once

#include <optional>
#include <vector>

#include "chapters/exercise.hpp"
#include "report/lanes/scenes.hpp"

namespace oddity::lanes {

/// Bodies of one model, each with parameters of its own.
class Batch {
 public:
  /// `model`: which of the scene's. `parameters`: as many a body as the scene has, one body's after the
  /// other's.
  Batch(const SceneInLanes& scene, std::size_t model, Precision precision, std::vector<double> parameters);

  std::size_t size() const { return bodies_; }
  bool closed_form() const { return beginning_.unknowns == 0; }
  std::size_t width(Registers registers) const { return compiled(registers).width; }
  bool has(Fixed algorithm) const;

  /// Puts the bodies side by side for these registers, where fixed steps keep them; these do so themselves
  /// where it is not done.
  void group(Registers);
  /// From the bodies' states on; there is one of each algorithm for all registers, to the bit.
  void steps(Registers, Fixed, double t0, double h, long steps);
  std::vector<Ended> own_steps(Registers, double t0, double t1, double tolerance, double first_step);
  void begin_again();

  /// Of all bodies: those of a closed form at t, or of the states that they have.
  std::vector<double> observed(Registers, double t) const;
  std::size_t observables() const { return beginning_.observables; }
  /// A body's state as it is in memory.
  std::span<const std::byte> state(std::size_t body) const;

 private:
  const Compiled& compiled(Registers) const;
  Bodies bodies() const { return {models_.data(), states_.data(), bodies_}; }
  /// How many groups the bodies make.
  std::size_t groups(Registers) const;
  /// Where fixed steps have moved the groups, the bodies too.
  void catch_up() const;

  const SceneInLanes& scene_;
  std::size_t of_all_;  ///< among the scene's models in double and then in float
  const Beginning& beginning_;
  std::vector<double> parameters_;
  std::size_t bodies_;
  std::vector<std::byte> models_;
  mutable std::vector<std::byte> states_;

  /// Memory as it is aligned for all registers.
  struct alignas(alignment) Line {
    std::byte bytes[alignment];
  };
  std::optional<Registers> grouped_;
  std::vector<Line> group_models_, group_states_;
  mutable bool behind_ = false;  ///< the bodies are, of their groups
};

/// The parameters of so many bodies, each a little off the exercise's: the k-th by k times `apart`.
std::vector<double> apart(const SceneInLanes& scene, std::span<const Parameter> parameters,
                          std::size_t bodies, double apart);

}  // namespace oddity::lanes
