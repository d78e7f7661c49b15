#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "report/study/criterion.hpp"
#include "report/study/need.hpp"
#include "report/study/parting.hpp"
#include "report/study/run.hpp"

namespace oddity {

/// A value that is made at its first use, by any thread.
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

/// Result of a method on a start at a setting.
struct OnStart {
  std::vector<double> errors;           ///< in each of the motion's units
  std::map<Criterion, double> by = {};  ///< by each requested criterion except path, in its own unit
  std::string why = {};                 ///< the reason for failing, if the error does not show it
  double error = 0;                     ///< in needs
  double unbounded_error = 0;  ///< without the bound by the motion's size, as far as it can be estimated
  double evaluations_per_frame = 0;
  Outcome outcome = Outcome::ok;
};

/// Results on a start, so that each method is run once. Thread-safe.
class Attempts {
 public:
  OnStart at(const Candidate&, const std::function<OnStart()>& make);

 private:
  using Which = std::tuple<std::string, std::string, double>;  ///< model, algorithm, setting
  std::map<Which, OnStart> all_;
  std::mutex mutex_;
};

/// Failures on a first part of a motion, by start and setting: they fail on the whole. Thread-safe.
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

/// Costs over a part of a motion.
struct PartCosts {
  using Which = std::pair<std::string, std::string>;  ///< model and algorithm
  struct Cost {
    double per_frame, per_evaluation;  ///< s
    double spread = 1;                 ///< spread of the repeats, as a part of the time
  };
  Which chosen;
  Cost of_chosen;
  std::map<Which, Cost> all = {};
};

/// State of judging a motion in parts.
struct PartJudged {
  std::string says;                        ///< the part judged here: "the first 56.25 s"
  std::shared_ptr<const Failures> before;  ///< over a shorter part; null: none was judged
  std::shared_ptr<Failures> here;          ///< over this part, for a longer one
  std::optional<PartCosts> costs = {};     ///< over a shorter part; empty: nothing was chosen there
  bool was_known = false;                  ///< the motion over a shorter part, to its end
};

/// One start of a scene: its true motion at every frame, and every method, with the request as the need.
struct Start {
  std::string says;  ///< "a = 0.5121, L = 0.9034"
  Quantity motion;
  std::shared_ptr<Lazy<Parting>> parting = {};    ///< growth of a disturbance, if paths are judged
  std::shared_ptr<Lazy<TrueEnergy>> energy = {};  ///< if energies are judged
  /// The start with a better reference; null if the motion is known well, or as well as possible.
  std::shared_ptr<Lazy<Start>> sharper = {};
  bool is_whole = true;                     ///< otherwise the motion ends where its truth is no longer known
  std::shared_ptr<Attempts> attempts = {};  ///< null: nothing is kept
  std::shared_ptr<const PartJudged> part = {};  ///< null: the motion is not judged in parts
};

/// A game's tolerance for a position [m] and an angle [rad]; for an orbit [AU], a degree of the Earth's.
double game_error(std::string_view unit);

/// A centimetre and a degree at every frame, over 10 s at 60 frames a second.
Need game_need();

/// The need in each of the motion's units.
std::vector<double> needs_of(const Need&, const Quantity& motion);

/// Error of a true motion in needs below which only trials close to the need need a better one. A margin of
/// three is then known to about a hundredth.
constexpr double known_very_well = 4e-3;

/// Whether the error of the true motion is too far below the needs to decide anything.
bool is_known_well(const Quantity& motion);

/// Digits for which a true motion's error is a millionth of the need, if errors grow by less than a
/// millionfold.
int digits_for(const Need&);

/// The scene's motion with the request as its need, and with no more digits of its truth than necessary.
Quantity known_motion(const Scene&, const Parameters&, const Horizon&, const Need&, const Reference&);

/// The need whose kicks have their ways, chosen on the task's start once for all others.
Need with_ways(Need, const Task&, const Reference&);

/// The starts of one choice: the requested one and others next to it, whose perturbed parameters are each up
/// to a tenth off. Their lazy members refer to this object, which must outlive them.
class InitialConditions {
 public:
  /// Throws BadInput when the task's exercise has no motion, or the need makes no sense.
  InitialConditions(const Task&, const Need&, const Reference&, std::shared_ptr<const PartJudged> = {});

  /// The requested start. Throws BadInput when no true motion is known there, or not as exactly as requested.
  Start asked() const;
  using AfterEach = std::function<void()>;
  /// `count` newly drawn starts, without those of which no true motion is known; made in parallel.
  std::vector<Start> nearby_starts(int count, const AfterEach&);
  /// The requested start, then `count` drawn ones.
  std::vector<Start> asked_and_nearby(int count, const AfterEach&);
  /// Number of drawn starts left out, by their kind of motion.
  const std::map<std::string, int>& left_out() const { return left_out_; }
  /// The first frames of the requested start, without a reference.
  Quantity first_frames(int count) const;

 private:
  Parameters drawn();
  std::vector<Parameters> draw(int count);
  std::optional<Start> start_if_known(const Parameters&) const;
  /// The requested start, if given, and `count` next to it; redraws those that are not comparable.
  std::vector<Start> with_asked(const std::function<Start()>& asked, int count, const AfterEach&);
  bool needs_period() const;
  /// Its true motion has the quantity that the need judges.
  bool is_comparable(const Start&) const;
  std::string says(const Parameters&) const;
  /// The start with everything needed to judge on it.
  Start to_judge(Start, const Parameters&) const;
  Start well_known(const Parameters&) const;
  /// The start with the truth that is quickly available, and a way to a better one.
  Start start(const Parameters&) const;
  Start start_in_long_double(const Parameters&) const;
  Start known_by(const Parameters&, const Reference&, int frames) const;
  /// The start, up to the time to which its true motion is known well enough.
  Start as_long_as_known(const Start& whole, const Parameters&) const;
  Parting parting(const Parameters&, const Quantity& motion) const;
  Start asked_to_choose() const;
  /// Throws BadInput if the start is not known as exactly as requested.
  Start required(Start) const;
  const Scene& scene() const { return *task_.entry->exercise.scene; }

  const Task& task_;
  const Need& need_;
  const Reference& truth_;
  std::shared_ptr<const PartJudged> part_;
  Random random_{7};
  std::map<std::string, int> left_out_;
  std::shared_ptr<Lazy<Parting>> parting_;  ///< that of the requested start, used for all
};

}  // namespace oddity
