#pragma once

#include <optional>
#include <vector>

#include "chapters/exercise.hpp"
#include "extras/lanes/scenes.hpp"

namespace oddity::lanes {

enum class Steps { fixed, own };

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

  /// Puts the bodies side by side for these registers and steps, where these keep them; steps do so
  /// themselves where it is not done.
  void group(Registers, Steps);
  /// From the bodies' states on; there is one of each algorithm for all registers, to the bit.
  void steps(Registers, Fixed, double t0, double h, long steps);
  /// Whether all bodies have come to t1, and, where it is asked, how each ended.
  bool own_steps(Registers, double t0, double t1, double tolerance, double first_step,
                 std::vector<Ended>* each = nullptr);
  /// From the scene's start, or from states that are this part of it.
  void begin_again(double part = 1);

  /// Of all bodies: those of a closed form at t, or of the states that they have.
  std::vector<double> observed(Registers, double t) const;
  std::size_t observables() const { return beginning_.observables; }
  /// A body's state as it is in memory.
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
  /// The groups that there are.
  Groups groups();
  /// work(groups, the first one's number) for some after the others; looks at this thread's stop before each.
  template <class Work>
  void for_pieces(const Work& work);
  /// Where the groups have been moved, the bodies too.
  void catch_up() const;

  /// Every number of the states by this factor.
  template <class T>
  void scale_states(T factor);

  const SceneInLanes& scene_;
  Precision precision_;
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
  std::optional<Grouped> grouped_;
  std::vector<Line> group_models_, group_states_;
  mutable bool behind_ = false;  ///< the bodies are, of their groups
};

/// The parameters of so many bodies, each a little off the exercise's: the k-th by k times `apart`.
std::vector<double> apart(const SceneInLanes& scene, std::span<const Parameter> parameters,
                          std::size_t bodies, double apart);

}  // namespace oddity::lanes
