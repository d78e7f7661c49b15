#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "report/study/criterion.hpp"
#include "report/study/need.hpp"
#include "report/study/parting.hpp"
#include "report/study/run.hpp"

namespace oddity {

/// What is made when it is first asked for, by whatever thread.
template <class Made>
class Lazy {
 public:
  explicit Lazy(std::function<Made()> make) : make_(std::move(make)) {}
  const Made& operator*() {
    std::call_once(is_made_, [this] { made_ = make_(); });
    return *made_;
  }

 private:
  std::function<Made()> make_;
  std::once_flag is_made_;
  std::optional<Made> made_;
};

/// How a method did on a start at a setting.
struct OnStart {
  std::vector<double> errors;           ///< in each of the motion's units
  std::map<Criterion, double> by = {};  ///< by each criterion asked for but path, in its own unit
  std::string why = {};                 ///< it does not hold, where the error does not say so
  double error = 0;                     ///< in units of what was asked
  double unbounded_error = 0;  ///< were it not bounded by the motion's size, as far as that can be told
  double evaluations_per_frame = 0;
  Outcome outcome = Outcome::ok;
};

/// What was tried on a start, so that it is tried once. For many threads.
class Attempts {
 public:
  OnStart at(const Candidate&, const std::function<OnStart()>& make);

 private:
  using Which = std::tuple<std::string, std::string, double>;  ///< model, algorithm, setting
  std::map<Which, OnStart> all_;
  std::mutex mutex_;
};

/// What fails on a first part of a motion fails on the whole of it: by start and setting. For many threads.
class Failures {
 public:
  void add(const std::string& start, const Candidate&, const OnStart&);
  std::optional<OnStart> find(const std::string& start, const Candidate&) const;
  void add(const Failures& shorter);

 private:
  using Which =
      std::tuple<std::string, std::string, std::string, double>;  ///< start, model, algorithm, setting
  std::map<Which, OnStart> all_;
  mutable std::mutex mutex_;
};

/// What is known of a motion's first part when a longer one is judged.
struct PartJudged {
  std::string says;                        ///< what is judged here: "the first 56.25 s"
  std::shared_ptr<const Failures> before;  ///< over a shorter part; null: none was judged
  std::shared_ptr<Failures> here;          ///< over this one, for a longer
};

/// One start of a scene: its true motion at every frame, and every method with what was asked as the need.
struct Start {
  std::string says;  ///< "a = 0.5121, L = 0.9034"
  Quantity motion;
  std::shared_ptr<Lazy<Parting>> parting = {};    ///< of a disturbance, where paths are judged
  std::shared_ptr<Lazy<TrueEnergy>> energy = {};  ///< where energies are judged
  /// The start by a better known truth; none where the motion is known well, or as well as can be.
  std::shared_ptr<Lazy<Start>> sharper = {};
  bool is_whole = true;                     ///< else the motion ends where its truth is no longer known
  std::shared_ptr<Attempts> attempts = {};  ///< none: nothing is kept
  std::shared_ptr<const PartJudged> part =
      {};  ///< none: no part of the motion was judged before, or may be later
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
/// to a tenth off. What these make when it is asked for, they make with this, which has to be there still.
class InitialConditions {
 public:
  /// Throws BadInput when the task's exercise has no motion, or the need makes no sense.
  InitialConditions(const Task&, const Need&, const Reference&, std::shared_ptr<const PartJudged> = {});

  /// The start asked for. Throws BadInput when no true motion is known there, or not as exactly as asked.
  Start asked() const;
  using AfterEach = std::function<void()>;
  /// `count` starts drawn afresh, less those of which no true motion is known; all made at once.
  std::vector<Start> beside(int count, const AfterEach&);
  /// The start asked for, and then those.
  std::vector<Start> asked_and_beside(int count, const AfterEach&);
  /// How many of those drawn were left out, by what kind of motion they have.
  const std::map<std::string, int>& left_out() const { return left_out_; }
  /// So many frames of the start asked for, without a reference.
  Quantity first_frames(int count) const;

 private:
  Parameters drawn();
  std::vector<Parameters> draw(int count);
  std::optional<Start> start_if_known(const Parameters&) const;
  /// The start asked for, if it is given, and `count` beside it; those that are not comparable are drawn
  /// again.
  std::vector<Start> with_asked(const std::function<Start()>& asked, int count, const AfterEach&);
  bool needs_period() const;
  /// Its true motion has what the need looks at.
  bool is_comparable(const Start&) const;
  std::string says(const Parameters&) const;
  /// The start with what it takes to judge on it.
  Start to_judge(Start, const Parameters&) const;
  Start well_known(const Parameters&) const;
  /// Known as well as it is had quickly, and with what knows it better.
  Start start(const Parameters&) const;
  /// The same start, up to where its truth is known well enough.
  Start as_long_as_known(const Start& whole, const Parameters&) const;
  Parting parting(const Parameters&, const Quantity& motion) const;
  Start asked_to_choose() const;
  /// Throws BadInput where the start is not known as exactly as asked.
  Start required(Start) const;
  const Scene& scene() const { return *task_.entry->exercise.scene; }

  const Task& task_;
  const Need& need_;
  const Reference& truth_;
  std::shared_ptr<const PartJudged> part_;
  Random random_{7};
  std::map<std::string, int> left_out_;
};

}  // namespace oddity
