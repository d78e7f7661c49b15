#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/study/frame_clock.hpp"
#include "report/study/ladder.hpp"
#include "report/study/picker.hpp"
#include "report/study/starts.hpp"

namespace oddity {

/// Selects by precision, words and the need's `takes`.
bool is_wanted(const Need&, const Method&);

/// The search of a choice. Each method climbs its ladder of settings, with ever more work allowed, until one
/// passes that meets the objective. The picker takes the cheapest, and unseen starts test it. If they refute
/// it, the search continues with these starts as well.
class Search {
 public:
  /// Throws BadInput if no method is left, or the criterion fits none of them.
  Search(const Task&, const Need&, const Reference&, const Price&, const Progress&,
         std::shared_ptr<const PartJudged>);

  Picked run();

  Starts& starts() { return starts_; }
  const Starts& starts() const { return starts_; }
  std::vector<Ladder>& ladders() { return ladders_; }
  const std::vector<Ladder>& ladders() const { return ladders_; }
  FrameClock& clock() { return clock_; }
  const FrameClock& clock() const { return clock_; }
  const Picker& picker() const { return picker_; }

  std::vector<Candidate> all_tried() const;
  /// Methods that are left out, as they cost too much over a part of the horizon.
  std::vector<PartCosts::Which> too_costly() const;
  /// The start on which the last pick failed its test. Then the starts on which methods fail that pass on the
  /// requested one, by the number of such methods.
  std::vector<std::string> hardest_starts() const;

  int rounds() const { return rounds_; }
  int failing_nearby() const { return failing_nearby_; }
  double seconds() const { return seconds_; }            ///< spent on settings
  double test_seconds() const { return test_seconds_; }  ///< spent on tests

 private:
  using Which = std::function<bool(const Ladder&)>;
  using Rung = Candidate* Ladder::Found::*;

  std::string names() const;
  PartCosts::Cost cost_over_part(const Ladder&) const;
  double most_of_a_tie(const Ladder&) const;
  double most_evaluations(const Ladder&) const;
  double most_work() const;
  void climb_chosen_over_part();
  bool readmit(const Picked&);
  void climb(const std::string& stage);
  void climb(const std::string& stage, double most_evaluations, const Which&);
  bool climb_on(const std::function<double(const Ladder&)>& seconds_per_frame);
  bool time(const std::function<Candidate*(Ladder&)>& wanted);
  void time_to_pick_from(Rung may_be_chosen, bool by_objective);
  Picked pick();
  Picked pick_cheapest();
  bool holds_elsewhere(Candidate&);

  const Need& need_;
  const Progress& progress_;
  Starts starts_;
  FrameClock clock_;
  Picker picker_;
  std::vector<Ladder> ladders_;
  std::vector<Ladder> too_costly_;
  std::optional<PartCosts> costs_;    ///< over a shorter part
  std::optional<double> comparable_;  ///< s per frame, of the method chosen over the part
  std::string refuted_on_;            ///< the start on which the last pick failed its test
  int rounds_ = 0, failing_nearby_ = 0;
  double seconds_ = 0, test_seconds_ = 0;
};

}  // namespace oddity
