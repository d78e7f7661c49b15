#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "report/study/need.hpp"
#include "report/study/run.hpp"

namespace oddity {

class Sharper;

/// One start of a scene: its true motion at every frame, and every method with what was asked as the need.
struct Start {
  std::string says;  ///< "a = 0.5121, L = 0.9034"
  Quantity motion;
  std::shared_ptr<Sharper> sharper = {};  ///< none where the motion is known well, or as well as can be
};

/// The start by a better known truth, made when it is first asked for, by whatever thread.
class Sharper {
 public:
  explicit Sharper(std::function<Start()> make) : make_(std::move(make)) {}
  const Start& start();

 private:
  std::function<Start()> make_;
  std::once_flag made_;
  std::optional<Start> start_;
};

/// What a game asks of a position [m] and of an angle [rad]; of an orbit [AU], a degree of the Earth's.
double game_error(std::string_view unit);

/// A centimetre and a degree at every frame, over 10 s at 60 frames a second.
Need game_need();

/// The need in each of the motion's units.
std::vector<double> needs_of(const Need&, const Quantity& motion);

/// The true motion's error is so far below the motion's needs that it decides nothing.
bool is_known_well(const Quantity& motion);

/// Digits with which a true motion's error is a millionth of the need, where errors grow by less than a
/// millionfold.
int digits_for(const Need&);

/// The scene's motion with what was asked as its need, and with no more digits of its truth than that takes.
Quantity known_motion(const Scene&, const Parameters&, const Horizon&, const Need&, const Reference&);

/// The starts of one choice: the one asked for, and others beside it, whose perturbed parameters are each up
/// to a tenth off.
class InitialConditions {
 public:
  /// Throws BadInput when the task's exercise has no motion, or the need makes no sense.
  InitialConditions(const Task&, const Need&, const Reference&);

  /// The start asked for. Throws BadInput when no true motion is known there, or not as exactly as asked.
  Start asked() const;
  /// `count` starts drawn afresh, less those of which no true motion is known.
  std::vector<Start> beside(int count);
  /// The start asked for and two sets of others beside it, all made at once; `made` is called after each.
  struct First {
    Start asked;
    std::vector<Start> seen, unseen;
  };
  First first(int seen, int unseen, const std::function<void()>& made);
  /// The motion with one of the start's parameters changed by a part of itself, without a reference.
  Quantity disturbed(double part) const;
  /// The first frame alone, without a reference.
  Quantity one_frame() const;

 private:
  Parameters draw();
  std::string says(const Parameters&) const;
  Start well_known(const Parameters&) const;
  /// Known as well as it is had quickly, and with what knows it better.
  Start start(const Parameters&) const;
  Start asked_to_choose() const;
  /// Throws BadInput where the start is not known as exactly as asked.
  Start required(Start) const;
  const Scene& scene() const { return *task_.entry->exercise.scene; }
  Horizon horizon() const { return {need_.horizon, 1, need_.frames_per_second}; }

  const Task& task_;
  const Need& need_;
  const Reference& truth_;
  Random random_{7};
};

}  // namespace oddity
